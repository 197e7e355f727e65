// Which of the candidate runs would people do? Learned from pools made for demonstrations that the proposing
// ranker had not seen.
#pragma once

#include <functional>
#include <vector>

#include "components/goalnet/ranker/boosted_trees.h"
#include "components/goalnet/ranker/checkpoint.h"
#include "components/goalnet/ranker/confidence.h"
#include "components/goalnet/ranker/ranker.h"
#include "components/goalnet/ranker/run_features.h"

namespace goalnet::inference {

struct Choice {
  CandidateRun run;
  float expected = 0;  // the SJI that the pool lets expect of it; see Confidence for what that is worth
};

// The run that agrees best with the pool (minimum Bayes risk), each run of the pool counting by its weight
// and by what the trees say of it (without trees by its weight alone), and then made to agree better still
// (improve_run.h). The pool is not empty.
Choice choose_run(const BoostedTrees& trees, const std::vector<CandidateRun>& pool,
                  const AgreementTable& table, const std::vector<RunFeatures>& features,
                  const SymState& start);

struct Reranker {
  BoostedTrees trees;
  Confidence confidence;  // from choices by trees that had not seen the example's fold either
};

// Pools by rankers that had not seen the example's fold of scenarios, scored, and trees fitted to them.
// `progress` (0..1): false stops. Errors: kCancelled, and those of the checkpoint.
Expected<Reranker> train_reranker(const std::vector<const Example*>& examples, const Lexicon& lexicon,
                                  bool grounding, const RankerOptions& options, Checkpoint& checkpoint,
                                  const std::function<bool(double)>& progress = {});

}  // namespace goalnet::inference
