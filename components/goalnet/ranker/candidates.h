// The things a robot might do next, as the last action of a natural run (sym_sim.h, with_means).
#pragma once

#include <vector>

#include "components/goalnet/ranker/instruction.h"
#include "components/goalnet/sym_sim.h"

namespace goalnet::inference {

// Which classes something was ever kept on or in: limits "keep" to sensible places. Learned from
// demonstrations.
struct Places {
  std::vector<ClassId> on, in;  // sorted
};

// All actions that can be reached and would change something; kStop comes first. At most kMaxCandidates:
// worlds with very many objects keep those the instruction names.
inline constexpr std::size_t kMaxCandidates = 4096;
std::vector<SymAction> candidates(const Instruction& instruction, const Lexicon& lexicon,
                                  const Places& places, const SymState& state);

}  // namespace goalnet::inference
