// Symmetries of a ground task: permutations of its atoms and actions that leave the task, its initial state and its goal
// as they are. Interchangeable cups, burners or crates give them. Two states that differ by one are equally far from the
// goal, so that a search needs only one of them (Pochter, Zohar and Rosenschein, AAAI 2011).
//
// Generators are found by colour refinement and every one is verified exactly before use; a symmetry that is overlooked
// costs time, never correctness.
#pragma once

#include <cstdint>
#include <vector>

#include "components/planner/budget.h"
#include "components/planner/ground_task.h"

namespace goalnet::planner {

class Symmetry {
 public:
  // Number of generators found.
  std::int64_t find(const GroundTask& task, const Word* initial, Budget& budget);
  std::int64_t count() const { return static_cast<std::int64_t>(generators_.size()); }
  // key = a representative of the state's orbit: generators are applied greedily as long as the result gets smaller.
  void canonical(const Word* state, Word* key);

 private:
  struct Generator {
    std::vector<std::pair<std::int32_t, std::int32_t>> moves;  // atom → atom, where different
  };
  std::vector<Generator> generators_;
  std::vector<Word> trial_;
  std::size_t words_ = 1;
};

}  // namespace goalnet::planner
