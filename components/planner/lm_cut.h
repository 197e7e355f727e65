// The LM-cut heuristic (Helmert and Domshlak, ICAPS 2009) for tasks with conditional effects: an admissible estimate of
// the cost to the goal, made of disjoint sets of actions of which every plan needs one. An action's conditional effects
// are operators of their own, but share one cost: what one cut takes, no other can (Röger, Pommerening and Helmert,
// ECAI 2014, call this the basic variant).
#pragma once

#include <cstdint>
#include <vector>

#include "components/planner/budget.h"
#include "components/planner/cost_queue.h"
#include "components/planner/relaxed_task.h"

namespace goalnet::planner {

class LmCut {
 public:
  static constexpr std::int64_t kDeadEnd = INT64_MAX / 4;

  void restart(const RelaxedTask& relaxed);
  // kDeadEnd if the goal is not even reachable in the relaxation. When the budget runs out in the middle, what was
  // counted so far is returned, which is admissible too.
  std::int64_t evaluate(const Word* state, Budget& budget);

  // Whether the relaxation reaches this from the state last evaluated.
  bool reachable(ConditionId condition) const;

 private:
  void explore(const Word* state);
  void propagate();
  void reach(Proposition p, std::int64_t cost);
  void update_supporter(std::int32_t op);
  void mark_goal_zone(Proposition p);
  bool find_cut(const Word* state);

  const RelaxedTask* relaxed_ = nullptr;
  std::vector<std::int64_t> cost_left_;       // by action
  std::vector<std::int64_t> proposition_cost_;
  std::vector<std::int32_t> unsatisfied_;     // by operator
  std::vector<Proposition> supporter_;        // by operator: its most expensive precondition
  std::vector<std::int64_t> supporter_cost_;
  std::vector<std::uint8_t> zone_;            // by proposition: 1 = leads to the goal for free, 2 = reached before
  std::vector<Proposition> stack_;
  std::vector<std::int32_t> cut_;             // operators
  std::vector<std::int32_t> cut_actions_;
  std::vector<std::uint8_t> in_cut_;          // by action
  CostQueue queue_;
};

}  // namespace goalnet::planner
