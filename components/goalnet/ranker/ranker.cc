#include "components/goalnet/ranker/ranker.h"

#include <algorithm>

namespace goalnet::inference {

std::vector<Decision> decisions_of(const Example& example, const Instruction& instruction,
                                   const Lexicon& lexicon, const Places& places,
                                   std::span<const NeighbourVote> votes) {
  std::vector<Decision> decisions;
  PartialRun run;
  run.start = example.states.front();
  for (std::size_t k = 0; k <= example.macros.size(); ++k) {
    const bool stop = k == example.macros.size();
    run.now = stop ? example.states.back() : example.states[example.macros[k].first];
    const SymAction action = stop ? SymAction{} : example.macros[k].second;
    Moment moment = make_moment(instruction, lexicon, places, votes, run);
    const auto found = std::find(moment.actions.begin(), moment.actions.end(), action);
    if (found != moment.actions.end()) {
      moment.decision.target.assign(moment.actions.size(), 0.0f);
      moment.decision.target[static_cast<std::size_t>(found - moment.actions.begin())] = 1;
      decisions.push_back(std::move(moment.decision));
    }
    run.actions.push_back(action);
  }
  return decisions;
}

Ranker train_ranker(const std::vector<const Example*>& examples, const Lexicon& lexicon, bool grounding,
                    const RankerOptions& options, const std::function<bool(int, double)>& progress) {
  Ranker ranker;
  ranker.options = options;
  ranker.places = learn_places(examples);
  std::vector<Memory> memories;
  for (const Example* example : examples)
    if (!example->perturbed) memories.push_back(remember(*example, grounding));
  ranker.neighbours = Neighbours(std::move(memories));
  std::vector<Decision> decisions;
  for (const Example* example : examples) {
    const Instruction& instruction = grounding ? example->given : example->none;
    // As it will be in use: the neighbours come from other scenarios.
    const auto near = ranker.neighbours.nearest(instruction, example->states.front(), options.neighbours,
                                                example->scenario);
    auto more = decisions_of(*example, instruction, lexicon, ranker.places, votes(near));
    std::move(more.begin(), more.end(), std::back_inserter(decisions));
  }
  ranker.policy.train(decisions, options.training, progress);
  return ranker;
}

std::vector<CandidateRun> propose(const Ranker& ranker, const Lexicon& lexicon,
                                  const Instruction& instruction, const SymState& start, std::uint64_t seed) {
  const RankerOptions& options = ranker.options;
  const auto near = ranker.neighbours.nearest(instruction, start, options.neighbours);
  const auto neighbour_votes = votes(near);
  Rollout rollout({&ranker.policy}, instruction, lexicon, ranker.places, neighbour_votes, start);
  std::vector<CandidateRun> pool;
  const auto add = [&](CandidateRun run, float weight) {
    for (CandidateRun& known : pool)
      if (known.actions == run.actions) {
        known.weight += weight;
        (run.source == 2 ? known.replayed : known.sampled) += weight;
        return;
      }
    run.weight = weight;
    (run.source == 2 ? run.replayed : run.sampled) = weight;
    pool.push_back(std::move(run));
  };
  Random random(seed);
  add(rollout.greedy(), options.greedy_weight);
  for (std::size_t i = 0; i < options.samples; ++i) add(rollout.sample(random, options.temperature), 1);
  for (std::size_t i = 0; i < std::min(near.size(), options.replays); ++i) {
    CandidateRun run = play(start, replay(*near[i].memory, instruction));
    run.source = 2;
    add(std::move(run), options.replay_weight * near[i].similarity);
  }
  float total = 1e-9f;
  for (const CandidateRun& run : pool) total += run.weight;
  for (CandidateRun& run : pool) {
    run.weight /= total;
    run.sampled /= total;
    run.replayed /= total;
    run.log_probability = rollout.log_probability(run.macros);
  }
  return pool;
}

std::vector<Agreement> expected_agreement(const std::vector<CandidateRun>& pool) {
  std::vector<Agreement> result(pool.size());
  for (std::size_t a = 0; a < pool.size(); ++a)
    for (const CandidateRun& truth : pool) {
      const Agreement one = agreement(pool[a], truth);
      result[a].sji += truth.weight * one.sji;
      result[a].f1 += truth.weight * one.f1;
      result[a].ied += truth.weight * one.ied;
      result[a].grr += truth.weight * one.grr;
    }
  return result;
}

}  // namespace goalnet::inference
