// Pairs of literals from which no way leads to the goal: h² backwards (Alcázar and Torralba, ICAPS 2015). A
// tile that is not painted while the one that has to be painted from it is; a crate in a corner. A state that
// has such a pair is a dead end, and no search need look at it.
#pragma once

#include <cstdint>
#include <vector>

#include "components/planner/budget.h"
#include "components/planner/ground_task.h"
#include "components/planner/pair_reachability.h"

namespace goalnet::planner {

class DeadPairs {
 public:
  // `forwards` computed for the same task. Nothing is known where nothing is known forwards, or the budget
  // runs out.
  void compute(const GroundTask& task, const PairReachability& forwards, Budget& budget);

  bool any() const { return !rows_.empty(); }
  // Whether the state, which `action` led to from one that is not dead, has such a pair.
  bool dead_after(const GroundTask& task, const GroundAction& action, const Word* state) const {
    if (rows_.empty()) return false;
    for (const GroundEffect& effect : task.effects_of(action)) {
      if (literal_holds(state, effect.literal) && dead(state, effect.literal)) return true;
    }
    return false;
  }
  // The same for any state.
  bool dead(const Word* state) const;

 private:
  void add_operators(const GroundTask& task, const PairReachability& forwards, Budget& budget);
  // Whether the literal, which holds, makes a dead pair with another one that does.
  bool dead(const Word* state, Literal literal) const {
    const std::int32_t place = place_[static_cast<std::size_t>(literal)];
    if (place < 0) return false;
    const Word* if_true = rows_.data() + static_cast<std::size_t>(place) * 2 * words_;
    for (std::size_t w = 0; w < words_; ++w) {
      if (((state[w] & if_true[w]) | (~state[w] & if_true[words_ + w])) != 0) return true;
    }
    return false;
  }

  PairFixpoint pairs_;
  std::size_t words_ = 0;
  std::vector<std::int32_t> place_;  // by literal: in rows_, or -1
  std::vector<Word> rows_;  // two for each place: the atoms that may not be true beside it, and not false
};

}  // namespace goalnet::planner
