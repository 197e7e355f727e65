// Interchangeable objects: two that can change places in a ground task without changing its actions and its
// goal, wherever they are at first. Sandwiches, tents and cups of a kind give them. States that differ only
// in which of them is where are equally far from the goal, so that a search needs only one of those (Pochter,
// Zohar and Rosenschein, AAAI 2011, for the case of objects).
//
// Found among objects that look alike, and every swap is verified exactly on the ground actions: what is
// overlooked costs time, never correctness. Unlike symmetry.h it takes one pass over the actions of each
// object, so that it pays in large tasks.
#pragma once

#include <cstdint>
#include <vector>

#include "components/planner/budget.h"
#include "components/planner/ground_task.h"

namespace goalnet::planner {

class ObjectSymmetry {
 public:
  // Tasks with junctions or axioms have none here; nor has one for which the budget ran out.
  void find(const GroundTask& task, Budget& budget);
  bool any() const { return !classes_.empty(); }
  // The number of objects that another one can take the place of.
  std::int64_t count() const;
  // key = a state that some swaps of objects lead to from `state`, mostly the same for all such states: the
  // objects of a class are sorted by what holds of them. `key` may be `state`.
  void canonical(const Word* state, Word* key) const;

 private:
  struct Swap {  // of an object and the next one of its class
    std::vector<std::pair<std::int32_t, std::int32_t>>
        atoms;  // that change places, first of the first object
  };
  using Class = std::vector<Swap>;

  std::vector<Class> classes_;
  std::size_t words_ = 1;
};

}  // namespace goalnet::planner
