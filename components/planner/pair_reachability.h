// Which pairs of literals can hold together: the h² reachability analysis (Haslum and Geffner, AIPS 2000) on
// rows of bits. A pair that is never reached is mutually exclusive in every state that a plan can lead to.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "components/planner/budget.h"
#include "components/planner/ground_task.h"
#include "components/planner/pair_fixpoint.h"

namespace goalnet::planner {

class PairReachability {
 public:
  // False where nothing is known: the task is too large for it to pay, or the budget ran out. Disjunctions in
  // conditions are taken to hold, and effects that happen under a condition to delete nothing, so that what
  // is found exclusive is.
  bool compute(const GroundTask& task, Budget& budget);

  // Both literals must be needed by the task, otherwise the answer is false.
  bool exclusive(Literal a, Literal b) const;
  // Whether the conditions can never hold together because a pair of their literals cannot.
  bool impossible(std::span<const ConditionId> conditions) const;

 private:
  friend class DeadPairs;
  void add_operators(const GroundTask& task, Budget& budget);
  std::int32_t index_of(Literal literal) const { return index_[static_cast<std::size_t>(literal)]; }

  bool known_ = false;
  std::vector<std::int32_t> index_;  // by literal; -1 = not needed
  PairFixpoint pairs_;
};

}  // namespace goalnet::planner
