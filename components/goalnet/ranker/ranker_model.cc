#include "components/goalnet/ranker/ranker_model.h"

#include <algorithm>
#include <array>
#include <utility>

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
  if (input.distances != nullptr)
    for (const auto& [object, distance] : *input.distances) {
      add(object);
      add(std::to_string(distance));
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

// What was understood, and what of the message made no difference to it.
std::string not_sure(const std::vector<SymAction>& actions, const std::vector<std::string>& unused,
                     const Symbols& symbols) {
  std::string text = "not sure: I understood ";
  for (const SymAction& action : actions)
    text += (&action == &actions.front() ? "\"" : ", ") + to_string(action, symbols);
  text += actions.empty() ? "that all of it is so already" : "\"";
  for (const std::string& word : unused)
    text += (&word == &unused.front() ? "; unclear: \"" : ", \"") + word + "\"";
  return text + "; please say it in other words";
}

// "yes, please do": an answer to "did you mean ...?", and nothing else.
bool agrees(const std::vector<std::string>& words) {
  static constexpr std::array<std::string_view, 9> kYes = {"yes",  "yeah",    "yep",    "yup", "exactly",
                                                           "sure", "correct", "indeed", "aye"};
  static constexpr std::array<std::string_view, 16> kWith = {
      "yes",  "please", "do",  "that",  "it",     "go",  "ahead", "ok",
      "okay", "i",      "did", "thank", "thanks", "you", ".",     ","};
  const auto is = [](const auto& group, const std::string& word) {
    return std::find(group.begin(), group.end(), word) != group.end();
  };
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) { return is(kYes, word); }) &&
         std::all_of(words.begin(), words.end(),
                     [&](const std::string& word) { return is(kYes, word) || is(kWith, word); });
}

}  // namespace

RankerModel::RankerModel(RankerParts parts, ModelUse use) : parts_(std::move(parts)), use_(use) {
  for (const std::string& word : parts_.known_words) parts_.language->add_known(word);
}

Expected<void> RankerModel::read_language() {
  auto robot = RobotLanguage::load(parts_.symbols);
  if (!robot) return tl::unexpected(robot.error());
  robot_ = std::move(*robot);
  return {};
}

Expected<Goal> RankerModel::do_infer(const StepInput& input) {
  const std::uint64_t key = fingerprint_of(input);
  if (key != decoded_for_) {
    const auto words =
        tokenize(input.sentence, use_ == ModelUse::kRobot ? Endings::kKept : Endings::kDropped);
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
  const auto words = *tokenize(input.sentence, use_ == ModelUse::kRobot ? Endings::kKept : Endings::kDropped);
  // Things that the lexicon does not list are known by their names from here on.
  for (const std::string& object : input.states.front().objects)
    if (const Symbol symbol = parts_.symbols.intern(object); symbol != kNone)
      parts_.lexicon->class_of(symbol, parts_.symbols);
  const WorldState& world = input.states.front();
  const SymState start = to_sym_state(world.facts, parts_.symbols);
  if (use_ == ModelUse::kRobot) return decode_robot(input, words, start);
  const Instruction instruction = see_instruction(words, input.grounding, world.objects, *parts_.lexicon,
                                                  *parts_.language, parts_.symbols);
  // The seed depends on the words only: the same instruction is decoded alike wherever it is given.
  return decode_benchmark(instruction, start, hash_text(input.sentence));
}

RankerModel::Decoded RankerModel::decode_benchmark(const Instruction& instruction, const SymState& start,
                                                   std::uint64_t seed) {
  const Ranker& ranker = instruction.grounding_given ? parts_.given : parts_.none;
  const FrameReader reader(*parts_.lexicon, *parts_.language, parts_.symbols);
  const Understanding understanding = reader.read(instruction, start);
  const Reading reading{understanding.macros, understanding.complete};
  const auto [pool, hints] = propose(ranker, *parts_.lexicon, instruction, reading, start, seed);
  const AgreementTable table(pool);
  const auto features = run_features(pool, table, instruction, start, hints);
  const auto [run, expected] = choose_run(ranker.reranker, pool, table, features, start);
  const auto confidence = static_cast<double>(ranker.confidence(expected));
  Decoded decoded;
  SymState now = start;
  for (const SymAction& action : run.actions) {
    SymState after = now;
    apply(action, after);
    decoded.steps.push_back(to_goal(delta(now, after), parts_.symbols, confidence));
    now = after;
  }
  return decoded;
}

// The grammar says what is to be done: doing more because somebody in a recording did so would surprise. What
// it cannot read is guessed; a guess is mostly a question.
RankerModel::Decoded RankerModel::decode_robot(const StepInput& input, std::vector<std::string> words,
                                               const SymState& start) {
  // An offer stands for the next message only.
  const std::string offered = std::exchange(offered_, {});
  if (!offered.empty() && agrees(words)) words = *tokenize(offered, Endings::kKept);
  const auto reading = robot_->read(words, input.states.front().objects, start, input.distances);
  const Understanding& understanding = reading.understanding;
  if (!understanding.complete)
    return guessed(input, words, start, reading,
                   {understanding.unknown_thing ? Outcome::kUnknownObject : Outcome::kNotUnderstood,
                    understanding.problems.empty() ? "nothing here can be done about that"
                                                   : understanding.problems.front()});
  const auto judgement = robot_->judge(words, reading, start, input.distances);
  signs_ = judgement.signs;
  const double confidence = robot_->confidence().of(signs_);
  if (confidence < robot_->confidence().least())
    return guessed(
        input, words, start, reading,
        {Outcome::kNotUnderstood, not_sure(understanding.macros, judgement.unused, parts_.symbols)});
  Decoded decoded = steps_of(understanding, confidence);
  if (std::any_of(decoded.steps.begin(), decoded.steps.end(),
                  [&](const Goal& step) { return !satisfied(step, input.states.front().facts); }))
    return decoded;
  // That all of it is so already is a likely misreading where something else is likely meant.
  const auto guess = robot_->guess(words, reading, input.states.front().objects, start, input.distances);
  if (!guess || !guess->overrules) return decoded;
  return offer(*guess, {Outcome::kNotUnderstood, "not sure: I understood that all of it is so already"});
}

RankerModel::Decoded RankerModel::steps_of(const Understanding& understanding, double confidence) {
  Decoded decoded;
  if (understanding.macros.empty()) return decoded;  // all of it holds already
  for (const SymDelta& step : understanding.steps)
    if (!step.empty()) decoded.steps.push_back(to_goal(step, parts_.symbols, confidence));
  return decoded;
}

RankerModel::Decoded RankerModel::guessed(const StepInput& input, const std::vector<std::string>& words,
                                          const SymState& start, const RobotLanguage::Reading& refused,
                                          Error refusal) {
  const auto guess = robot_->guess(words, refused, input.states.front().objects, start, input.distances);
  if (guess && guess->sure) return steps_of(guess->reading.understanding, guess->probability);
  if (guess) return offer(*guess, std::move(refusal));
  Decoded decoded;
  decoded.refused = true;
  decoded.refusal = std::move(refusal);
  return decoded;
}

RankerModel::Decoded RankerModel::offer(const RobotLanguage::Guess& guess, Error refusal) {
  Decoded decoded;
  decoded.refused = true;
  decoded.refusal = std::move(refusal);
  decoded.refusal.message += "; did you mean \"" + guess.sentence + "\"?";
  offered_ = guess.sentence;
  return decoded;
}

}  // namespace goalnet::inference
