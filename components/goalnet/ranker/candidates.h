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

// At most so many: worlds with very many objects keep those the instruction names.
inline constexpr std::size_t kMaxCandidates = 4096;

// Refers to the instruction, which must outlive it.
class Candidates {
 public:
  Candidates(const Instruction& instruction, const Lexicon& lexicon, const Places& places);
  // All actions that can be reached and would change something; kStop comes first.
  std::vector<SymAction> in(const SymState& state) const;

 private:
  // An object, with what never changes of it.
  struct Thing {
    Symbol symbol;
    bool named, on, in, utensil, xbox, vessel;
  };
  std::vector<Thing> relevant(const SymState& state) const;

  const Instruction& instruction_;
  std::vector<Thing> things_;
};

}  // namespace goalnet::inference
