#include "components/goalnet/ranker/ranker_model.h"

#include <algorithm>
#include <array>

#include "components/goalnet/ranker/reranker.h"
#include "components/goalnet/tokenizer.h"

namespace goalnet::inference {
namespace {

using namespace symbol;

std::uint64_t fingerprint_of(const StepInput& input) {
  std::uint64_t hash = 0xcbf29ce484222325ull;
  const auto add = [&](std::string_view text) {
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ull;
    hash = (hash ^ 0xffu) * 0x100000001b3ull;
  };
  add(input.sentence);
  add(input.grounding != nullptr ? "given" : "none");
  if (input.grounding != nullptr)
    for (const auto& [word, objects] : *input.grounding) {
      add(word);
      for (const std::string& object : objects) add(object);
    }
  for (const std::string& object : input.states.front().objects) add(object);
  for (const Predicate& fact : input.states.front().facts) {
    add(fact.relation);
    add(fact.subject);
    add(fact.object);
  }
  return hash;
}

Goal to_goal(const SymDelta& change, const Symbols& symbols, double confidence) {
  Goal goal;
  for (const SymFact fact : change.added) goal.positive.push_back(to_predicate(fact, symbols));
  for (const SymFact fact : change.removed) goal.negative.push_back(to_predicate(fact, symbols));
  goal.confidence = confidence;
  return goal;
}

// What an action is for, without its side effects: a robot that puts a mug down need not be told to let go of
// it.
SymDelta purpose(const SymAction& action, const SymState& before, const std::vector<SymAction>& run) {
  SymState after = before;
  apply(action, after);
  SymDelta change = delta(before, after);
  if (action.verb == Verb::kMoveTo || action.verb == Verb::kGrasp) change.removed.clear();
  const auto means = [&](SymFact fact) {
    const Relation relation = relation_of(fact);
    return (relation == Relation::kNear && action.verb != Verb::kMoveTo) ||
           (relation == Relation::kGrasping && action.verb != Verb::kGrasp && action.verb != Verb::kRelease);
  };
  std::erase_if(change.added, means);
  std::erase_if(change.removed, means);
  // Water that runs over what stands in the sink anyway is no purpose; only over what this run put there.
  std::erase_if(change.added, [&](SymFact fact) {
    return relation_of(fact) == Relation::kState && object_of(fact) == kWater &&
           subject_of(fact) != action.x && subject_of(fact) != action.y &&
           std::none_of(run.begin(), run.end(),
                        [&](const SymAction& other) { return other.x == subject_of(fact); });
  });
  return change;
}

}  // namespace

RankerModel::RankerModel(RankerParts parts, ModelUse use) : parts_(std::move(parts)), use_(use) {
  for (const std::string& word : parts_.known_words) parts_.language->add_known(word);
}

Expected<Goal> RankerModel::do_infer(const StepInput& input) {
  const std::uint64_t key = fingerprint_of(input);
  if (key != decoded_for_) {
    const auto words = tokenize(input.sentence);
    if (!words) return tl::unexpected(words.error());
    decoded_ = decode(input);
    decoded_for_ = key;
  }
  if (decoded_.refused) return tl::unexpected(decoded_.refusal);
  // Where in the run are we? Behind the last step that was asked for.
  std::size_t next = 0;
  for (const Goal& done : input.goals)
    for (std::size_t i = next; i < decoded_.steps.size(); ++i)
      if (decoded_.steps[i].positive == done.positive && decoded_.steps[i].negative == done.negative) {
        next = i + 1;
        break;
      }
  for (; next < decoded_.steps.size(); ++next)
    if (!satisfied(decoded_.steps[next], input.states.back().facts)) return decoded_.steps[next];
  return Goal{};
}

RankerModel::Decoded RankerModel::decode(const StepInput& input) {
  auto words = *tokenize(input.sentence);
  // Things that the lexicon does not list are known by their names from here on.
  for (const std::string& object : input.states.front().objects)
    if (const Symbol symbol = parts_.symbols.intern(object); symbol != kNone)
      parts_.lexicon->class_of(symbol, parts_.symbols);
  if (use_ == ModelUse::kRobot)
    for (std::string& word : words) word = parts_.language->correct(parts_.language->synonym(word));
  const WorldState& world = input.states.front();
  const Instruction instruction =
      see_instruction(words, input.grounding, world.objects, *parts_.lexicon, parts_.symbols);
  const SymState start = to_sym_state(world.facts, parts_.symbols);
  // The seed depends on the words only: the same instruction is decoded alike wherever it is given.
  const std::uint64_t seed = hash_text(input.sentence);
  return use_ == ModelUse::kBenchmark ? decode_benchmark(instruction, start, seed)
                                      : decode_robot(instruction, start, seed);
}

RankerModel::Decoded RankerModel::decode_benchmark(const Instruction& instruction, const SymState& start,
                                                   std::uint64_t seed) {
  const Ranker& ranker = instruction.grounding_given ? parts_.given : parts_.none;
  const auto pool = propose(ranker, *parts_.lexicon, instruction, start, seed);
  const FrameReader reader(*parts_.lexicon, *parts_.language, parts_.symbols);
  const Understanding understanding = reader.read(instruction, start);
  const auto features =
      run_features(pool, instruction, start, play(start, understanding.macros), understanding.complete);
  const std::size_t best = choose_run(ranker.reranker, pool, features);
  const double confidence =
      std::clamp(static_cast<double>(features[best][4]), 0.0, 1.0);  // expected agreement
  Decoded decoded;
  SymState now = start;
  for (const SymAction& action : pool[best].actions) {
    SymState after = now;
    apply(action, after);
    decoded.steps.push_back(to_goal(delta(now, after), parts_.symbols, confidence));
    now = after;
  }
  return decoded;
}

// Whether a run does the same kinds of things with the same kinds of objects as the reading: it may choose
// among instances, but adds nothing that nobody asked for and leaves nothing out.
bool RankerModel::same_kind(const CandidateRun& run, const CandidateRun& reading,
                            const Instruction& instruction) const {
  const auto kinds = [&](const CandidateRun& of) {
    std::vector<std::array<int, 3>> list;
    for (const SymAction& action : of.macros) {
      const auto kind = [&](Symbol symbol) {
        const int found = instruction.find(symbol);
        return found < 0 ? 100000 + symbol
                         : static_cast<int>(instruction.objects[static_cast<std::size_t>(found)].class_id);
      };
      list.push_back({static_cast<int>(action.verb), kind(action.x), kind(action.y)});
    }
    std::sort(list.begin(), list.end());
    return list;
  };
  return kinds(run) == kinds(reading);
}

RankerModel::Decoded RankerModel::decode_robot(const Instruction& instruction, const SymState& start,
                                               std::uint64_t seed) {
  Decoded decoded;
  const FrameReader reader(*parts_.lexicon, *parts_.language, parts_.symbols);
  const Understanding understanding = reader.read(instruction, start);
  const auto refuse = [&](const std::string& why) {
    decoded.refused = true;
    decoded.refusal = {Outcome::kNotUnderstood, why};
  };
  if (!understanding.complete) {
    refuse(understanding.problems.empty() ? "nothing here can be done about that"
                                          : understanding.problems.front());
    return decoded;
  }
  if (understanding.macros.empty()) return decoded;  // all of it holds already
  const Ranker& ranker = instruction.grounding_given ? parts_.given : parts_.none;
  auto pool = propose(ranker, *parts_.lexicon, instruction, start, seed);
  // The grammatical reading has as much say as everything learned; the learned runs tell which of several
  // readings, and how sure to be.
  CandidateRun read = play(start, understanding.macros);
  read.source = 3;
  read.weight = 1.0f;
  pool.insert(pool.begin(), read);
  const auto agreements = expected_agreement(pool);
  std::size_t best = 0;
  for (std::size_t i = 1; i < pool.size(); ++i)
    if (agreements[i].mean() > agreements[best].mean() && same_kind(pool[i], pool[0], instruction)) best = i;
  float support = 0;  // how far the learned runs agree with the choice
  for (const CandidateRun& run : pool)
    if (run.source != 3) support += run.weight * agreement(pool[best], run).f1;
  const double confidence = std::clamp(0.6 + 0.4 * static_cast<double>(support), 0.0, 1.0);

  SymState now = start;
  for (const SymAction& macro : pool[best].macros) {
    SymDelta change;
    for (const SymAction& action : with_means(macro, now)) {
      if (action == macro) change = purpose(action, now, pool[best].macros);
      apply(action, now);
    }
    if (!change.empty()) decoded.steps.push_back(to_goal(change, parts_.symbols, confidence));
  }
  return decoded;
}

}  // namespace goalnet::inference
