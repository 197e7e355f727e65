// Reaches one goal after the other, in an order found on the way: a goal whose relaxed plan for the rest
// would undo it again was reached too early and is put back. Towers are built from the bottom that way.
// Incomplete: it may give up where a plan exists.
#pragma once

#include <cstdint>
#include <vector>

#include "components/planner/greedy_search.h"

namespace goalnet::planner {

class SerialSearch {
 public:
  // `most_states`: evaluated before giving up. True with plan() reaching all goals of `task` from `initial`. `heuristic` must have been made for the
  // whole goal.
  bool search(const GroundTask& task, RelaxedPlanner& heuristic, const Word* initial, std::int64_t most_states,
              std::int64_t most_bytes, Budget& budget, Statistics& statistics);
  const std::vector<std::int32_t>& plan() const { return plan_; }

 private:
  bool advance(const GroundTask& task, RelaxedPlanner& heuristic, ConditionId goal, std::int64_t most_bytes,
               bool strict, Budget& budget, Statistics& statistics);

  GroundTask part_;  // with some of the goals
  RelaxedTask relaxed_;
  RelaxedPlanner planner_;
  GreedySearch greedy_;
  std::vector<Word> state_, next_, after_;
  std::vector<ConditionId> reached_;
  std::vector<std::int32_t> plan_;
};

}  // namespace goalnet::planner
