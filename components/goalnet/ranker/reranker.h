// Which of the candidate runs would people do? Learned from pools made for demonstrations that the proposing
// ranker had not seen.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "components/goalnet/ranker/boosted_trees.h"
#include "components/goalnet/ranker/ranker.h"

namespace goalnet::inference {

inline constexpr std::size_t kRunFeatures = 48;
using RunFeatures = std::array<float, kRunFeatures>;

// One row for each run of the pool. `reading`: the run that the grammar suggests, and whether it read
// everything.
std::vector<RunFeatures> run_features(const std::vector<CandidateRun>& pool, const Instruction& instruction,
                                      const SymState& start, const CandidateRun& reading, bool complete);

// The run that agrees best with the pool (minimum Bayes risk), each run of the pool counting by its weight
// and by what the trees say of it. Without trees by its weight alone.
std::size_t choose_run(const BoostedTrees& trees, const std::vector<CandidateRun>& pool,
                       const std::vector<RunFeatures>& features);

// The run that a person did.
CandidateRun demonstrated_run(const Example& example);

// Reads an instruction by its grammar; empty run and false when it cannot.
using Reader = std::function<std::pair<CandidateRun, bool>(const Instruction&, const SymState&)>;

// Pools by rankers that had not seen the example's fold of scenarios, scored, and trees fitted to them.
BoostedTrees train_reranker(const std::vector<const Example*>& examples, const Lexicon& lexicon,
                            bool grounding, const RankerOptions& options, const Reader& reader,
                            const std::function<bool(double)>& progress = {});

}  // namespace goalnet::inference
