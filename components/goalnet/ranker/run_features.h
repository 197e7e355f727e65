// What can be said of each candidate run of a pool: how it agrees with the others, with neighbours and with
// the grammar, and how it fits the words.
#pragma once

#include <array>
#include <vector>

#include "components/goalnet/ranker/hints.h"
#include "components/goalnet/ranker/instruction.h"
#include "components/goalnet/ranker/run_pool.h"

namespace goalnet::inference {

inline constexpr std::size_t kRunFeatures = 84;
using RunFeatures = std::array<float, kRunFeatures>;

// How each run of a pool would score if another one were the demonstration. Row by row: runs; columns:
// truths.
class AgreementTable {
 public:
  explicit AgreementTable(const std::vector<CandidateRun>& pool);
  const Agreement& operator()(std::size_t run, std::size_t truth) const {
    return cells_[run * size_ + truth];
  }

 private:
  std::size_t size_;
  std::vector<Agreement> cells_;
};

// One row for each run of the pool.
std::vector<RunFeatures> run_features(const std::vector<CandidateRun>& pool, const AgreementTable& table,
                                      const Instruction& instruction, const SymState& start,
                                      const Hints& hints);

}  // namespace goalnet::inference
