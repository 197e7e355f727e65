// Symmetries of a ground task: permutations of its atoms that leave the actions and the goal as they are (the
// initial state need not be). Interchangeable cups, burners or crates give them. Two states that differ by
// one are equally far from the goal, so that a search needs only one of them (Pochter, Zohar and Rosenschein,
// AAAI 2011).
//
// Generators are found by colour refinement and every one is verified exactly before use; a symmetry that is
// overlooked costs time, never correctness.
#pragma once

#include <cstdint>
#include <vector>

#include "components/planner/budget.h"
#include "components/planner/ground_task.h"

namespace goalnet::planner {

class Symmetry {
 public:
  // Number of generators found. Tasks with junctions or axioms, or too large for it to pay, have none here.
  std::int64_t find(const GroundTask& task, Budget& budget);
  std::int64_t count() const { return static_cast<std::int64_t>(generators_.size()); }
  // key = a representative of the state's orbit: generators are applied greedily as long as the result gets
  // smaller.
  void canonical(const Word* state, Word* key);

 private:
  using Permutation = std::vector<std::int32_t>;  // of atoms
  using Colours = std::vector<std::uint64_t>;     // of atoms
  struct Generator {
    std::vector<std::pair<std::int32_t, std::int32_t>> moves;  // atom → atom, where different
  };

  Colours refined(const GroundTask& task, Colours colours, Budget& budget) const;
  // The permutation that the two colourings suggest; false if their classes do not match.
  static bool match(const Colours& left, const Colours& right, Permutation* permutation);
  // Everything about the actions and the goal, renamed by the permutation, in a canonical order.
  static std::vector<std::vector<std::int32_t>> description(const GroundTask& task,
                                                            const Permutation& permutation, Budget& budget);

  std::vector<Generator> generators_;
  std::vector<Word> trial_;
  std::size_t words_ = 1;
};

}  // namespace goalnet::planner
