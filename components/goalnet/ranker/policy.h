// The log-linear ranker as a policy: which action next, given the instruction, the world and what was done.
#pragma once

#include <vector>

#include "components/goalnet/random.h"
#include "components/goalnet/ranker/candidates.h"
#include "components/goalnet/ranker/features.h"
#include "components/goalnet/ranker/log_linear.h"
#include "components/goalnet/ranker/run_pool.h"
#include "components/goalnet/ranker/step_table.h"

namespace goalnet::inference {

inline constexpr std::size_t kMaxMacros = 25;
inline constexpr std::size_t kMaxActions = 30;

// The candidates of one moment with their features, as training and decoding see them.
struct Moment {
  std::vector<SymAction> actions;
  Decision decision;  // target left empty
};
Moment make_moment(const Instruction& instruction, const Lexicon& lexicon, const Places& places,
                   const Hints& hints, const PartialRun& run);

// Rolls the policy out for one instruction; moments seen before are remembered, so that many samples cost
// little.
class Rollout {
 public:
  Rollout(const LogLinear& model, const Instruction& instruction, const Lexicon& lexicon,
          const Places& places, const Hints& hints, const SymState& start);

  CandidateRun greedy();
  CandidateRun sample(Random& random, float temperature);
  // Moments looked at so far: what the time goes into.
  std::size_t moments() const { return moments_; }
  // Log probability of a run of macros followed by a stop; what the policy cannot do costs a fixed amount.
  float log_probability(std::span<const SymAction> macros);

 private:
  struct Node {
    std::vector<SymAction> actions;
    std::vector<float> probability;
    std::vector<int> child;  // index into nodes_, -1 not visited, -2 leads nowhere new
    PartialRun run;
    std::size_t primitive = 0;  // actions so far, means included
    bool expanded = false;
  };
  // What is remembered of an action from moment to moment.
  struct Known {
    ActionHints hints;
    EarlierFeatures earlier;
  };
  void expand(std::size_t index);
  int follow(std::size_t index, std::size_t choice);
  template <class Choose>
  CandidateRun roll(Choose choose);

  const LogLinear& model_;
  const Instruction& instruction_;
  const Candidates candidates_;
  const Hints& hints_;
  const SymState start_;
  std::vector<Node> nodes_;
  StepTable numbers_;         // of actions, and by these numbers:
  std::vector<float> fixed_;  // scores of the fixed features
  std::vector<Known> known_;
  std::vector<std::uint32_t> features_, offsets_;
  std::size_t moments_ = 0;
};

}  // namespace goalnet::inference
