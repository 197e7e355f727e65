// What the satisficing searches leave out: states from which no way leads to the goal, and states that differ
// from one already met only in which of several interchangeable objects is where.
#pragma once

#include <vector>

#include "components/planner/dead_pairs.h"
#include "components/planner/object_symmetry.h"
#include "components/planner/state_table.h"

namespace goalnet::planner {

struct Pruning {
  DeadPairs dead;
  ObjectSymmetry symmetry;

  void restart(StateTable& states, std::size_t words) const { states.restart(words, symmetry.any()); }
  // The number of the state or of one like it, adding it if there is none. `key` is room for a state.
  std::int32_t add(StateTable& states, const Word* state, std::vector<Word>& key, bool* is_new) const {
    if (!symmetry.any()) return states.add(state, state, is_new);
    key.resize(states.words());
    symmetry.canonical(state, key.data());
    return states.add(state, key.data(), is_new);
  }
};

}  // namespace goalnet::planner
