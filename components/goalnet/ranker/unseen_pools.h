// Pools of candidate runs for demonstrations that the proposing ranker had not seen: what the trees learn
// from.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "components/core/outcome.h"
#include "components/goalnet/ranker/checkpoint.h"
#include "components/goalnet/ranker/ranker.h"
#include "components/goalnet/ranker/run_features.h"

namespace goalnet::inference {

// A pool and how each run of it would have scored.
struct UnseenPool {
  int fold = 0;
  SymState start;
  CandidateRun truth;  // what the person did
  std::vector<CandidateRun> pool;
  std::vector<RunFeatures> features;
  std::vector<Agreement> scores;
};

// One fold: `seen` trains a ranker, `unseen` gets pools. `stage` names it in the checkpoint, from which the
// pools are taken if they are there. `progress` (0..1): false stops, kCancelled.
Expected<std::vector<UnseenPool>> unseen_pools(const std::vector<const Example*>& seen,
                                               const std::vector<const Example*>& unseen, int fold,
                                               const Lexicon& lexicon, bool grounding,
                                               const RankerOptions& options, Checkpoint& checkpoint,
                                               const std::string& stage,
                                               const std::function<bool(double)>& progress);

}  // namespace goalnet::inference
