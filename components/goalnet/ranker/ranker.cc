#include "components/goalnet/ranker/ranker.h"

#include <algorithm>
#include <cmath>

namespace goalnet::inference {

namespace {

// Most candidates put some thing that nobody spoke of somewhere: of those every eighth is kept and counts
// for eight.
void thin(Moment& moment, const Instruction& instruction, std::size_t wanted, Random& random) {
  constexpr std::size_t kKeepOneOf = 8;
  const auto named = [&](Symbol symbol) {
    const int found = instruction.find(symbol);
    return found >= 0 && instruction.objects[static_cast<std::size_t>(found)].mention >= 0;
  };
  Decision thinned;
  thinned.offsets.push_back(0);
  for (std::size_t i = 0; i < moment.actions.size(); ++i) {
    const SymAction& action = moment.actions[i];
    const bool keep = i == wanted || action.y == symbol::kNone || named(action.x);
    if (!keep && random.below(kKeepOneOf) != 0) continue;
    const auto begin = moment.decision.features.begin();
    thinned.features.insert(thinned.features.end(), begin + moment.decision.offsets[i],
                            begin + moment.decision.offsets[i + 1]);
    thinned.offsets.push_back(static_cast<std::uint32_t>(thinned.features.size()));
    thinned.target.push_back(i == wanted ? 1.0f : 0.0f);
    thinned.offset.push_back(keep ? 0.0f : std::log(static_cast<float>(kKeepOneOf)));
  }
  moment.decision = std::move(thinned);
}

}  // namespace

std::vector<Decision> decisions_of(const Example& example, const Instruction& instruction,
                                   const Lexicon& lexicon, const Places& places, const Hints& hints,
                                   Random* random) {
  std::vector<Decision> decisions;
  PartialRun run;
  for (std::size_t k = 0; k <= example.macros.size(); ++k) {
    const bool stop = k == example.macros.size();
    run.now = stop ? example.states.back() : example.states[example.macros[k].first];
    const SymAction action = stop ? SymAction{} : example.macros[k].second;
    Moment moment = make_moment(instruction, lexicon, places, hints, run);
    const auto found = std::find(moment.actions.begin(), moment.actions.end(), action);
    if (found != moment.actions.end()) {
      const auto wanted = static_cast<std::size_t>(found - moment.actions.begin());
      if (random != nullptr) {
        thin(moment, instruction, wanted, *random);
      } else {
        moment.decision.target.assign(moment.actions.size(), 0.0f);
        moment.decision.target[wanted] = 1;
      }
      decisions.push_back(std::move(moment.decision));
    }
    run.actions.push_back(action);
  }
  return decisions;
}

Ranker untrained_ranker(const std::vector<const Example*>& examples, bool grounding,
                        const RankerOptions& options) {
  Ranker ranker;
  ranker.options = options;
  ranker.places = learn_places(examples);
  std::vector<Memory> memories;
  for (const Example* example : examples)
    if (!example->perturbed) memories.push_back(remember(*example, grounding));
  ranker.neighbours = Neighbours(std::move(memories));
  return ranker;
}

Ranker train_ranker(const std::vector<const Example*>& examples, const Lexicon& lexicon, bool grounding,
                    const RankerOptions& options, const std::function<bool(int, double)>& progress) {
  Ranker ranker = untrained_ranker(examples, grounding, options);
  std::vector<Decision> decisions;
  Random random(options.training.seed);
  for (const Example* example : examples) {
    const Instruction& instruction = grounding ? example->given : example->none;
    // As it will be in use: the neighbours come from other scenarios.
    const auto near = ranker.neighbours.nearest(instruction, example->states.front(), options.neighbours,
                                                example->scenario);
    const Hints hints = make_hints(near, instruction, grounding ? example->read_given : example->read_none);
    auto more = decisions_of(*example, instruction, lexicon, ranker.places, hints, &random);
    std::move(more.begin(), more.end(), std::back_inserter(decisions));
  }
  ranker.policy.train(decisions, options.training, progress);
  return ranker;
}

Proposal propose(const Ranker& ranker, const Lexicon& lexicon, const Instruction& instruction,
                 const Reading& reading, const SymState& start, std::uint64_t seed) {
  const RankerOptions& options = ranker.options;
  const auto near = ranker.neighbours.nearest(instruction, start, options.neighbours);
  Hints hints = make_hints(near, instruction, reading);
  Rollout rollout(ranker.policy, instruction, lexicon, ranker.places, hints, start);
  std::vector<CandidateRun> pool;
  const auto share = [](CandidateRun& run, int source) -> float& {
    return source == 2 ? run.replayed : source == 3 ? run.read : run.sampled;
  };
  const auto add = [&](CandidateRun run, float weight) {
    for (CandidateRun& known : pool)
      if (known.actions == run.actions) {
        known.weight += weight;
        share(known, run.source) += weight;
        return;
      }
    run.weight = weight;
    share(run, run.source) = weight;
    pool.push_back(std::move(run));
  };
  Random random(seed);
  add(rollout.greedy(), options.greedy_weight);
  for (std::size_t i = 0; i < options.samples && rollout.moments() < options.moments; ++i)
    add(rollout.sample(random, options.temperature), 1);
  for (const auto* list : {&near.by_words, &near.by_room})
    for (std::size_t i = 0; i < std::min(list->size(), options.replays); ++i) {
      const Neighbour& neighbour = (*list)[i];
      CandidateRun run = play(start, replay(*neighbour.memory, instruction));
      run.source = 2;
      add(std::move(run), options.replay_weight * neighbour.similarity);
    }
  if (!reading.macros.empty()) {
    CandidateRun run = play(start, reading.macros);
    run.source = 3;
    add(std::move(run), reading.complete ? options.reading_weight : options.reading_weight / 2);
  }
  float total = 1e-9f;
  for (const CandidateRun& run : pool) total += run.weight;
  for (CandidateRun& run : pool) {
    run.weight /= total;
    run.sampled /= total;
    run.replayed /= total;
    run.read /= total;
    run.log_probability = rollout.log_probability(run.macros);
  }
  return {std::move(pool), std::move(hints)};
}

}  // namespace goalnet::inference
