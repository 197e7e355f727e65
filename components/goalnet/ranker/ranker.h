// The trained parts of the feature-sharing ranker, and the runs it proposes for an instruction.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "components/goalnet/ranker/boosted_trees.h"
#include "components/goalnet/ranker/confidence.h"
#include "components/goalnet/ranker/log_linear.h"
#include "components/goalnet/ranker/neighbours.h"
#include "components/goalnet/ranker/policy.h"
#include "components/goalnet/ranker/run_pool.h"

namespace goalnet::inference {

struct RankerOptions {
  std::size_t neighbours = 20;  // asked for votes
  std::size_t replays = 6;      // of these, replayed as candidate runs, by words and by room
  std::size_t samples = 40;     // runs drawn from the policy
  std::size_t moments = 100;    // of the policy, looked at before no more runs are drawn: bounds the time
  float temperature = 1.0f;
  float greedy_weight = 2.0f;   // of the greedy run, in samples
  float replay_weight = 6.0f;   // of a replay, in samples, times the similarity
  float reading_weight = 2.0f;  // of what the grammar reads; half of it when it cannot read everything
  LogLinearOptions training;
};

struct Ranker {
  RankerOptions options;
  Places places;
  LogLinear policy{kFeatureBuckets};
  Neighbours neighbours;
  BoostedTrees reranker;  // empty: runs are chosen by expected agreement alone
  Confidence confidence;  // what the expected agreement of the choice is worth
};

// All of a ranker but what is learned: the memories of the examples, seen with or without their grounding.
Ranker untrained_ranker(const std::vector<const Example*>& examples, bool grounding,
                        const RankerOptions& options);
// With its policy trained on the examples. Deterministic.
Ranker train_ranker(const std::vector<const Example*>& examples, const Lexicon& lexicon, bool grounding,
                    const RankerOptions& options, const std::function<bool(int, double)>& progress = {});

struct Proposal {
  std::vector<CandidateRun> pool;
  Hints hints;
};

// Candidate runs with their weights; equal runs are merged (weights added). The greedy run comes first.
Proposal propose(const Ranker& ranker, const Lexicon& lexicon, const Instruction& instruction,
                 const Reading& reading, const SymState& start, std::uint64_t seed);

// An example's steps as decisions. With `random` most of the least likely candidates are left out, for speed.
std::vector<Decision> decisions_of(const Example& example, const Instruction& instruction,
                                   const Lexicon& lexicon, const Places& places, const Hints& hints,
                                   Random* random = nullptr);

}  // namespace goalnet::inference
