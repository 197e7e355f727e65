// The LM-cut heuristic (Helmert and Domshlak, ICAPS 2009) for tasks with conditional effects: an admissible
// estimate of the cost to the goal, made of disjoint sets of actions of which every plan needs one. An
// action's conditional effects are operators of their own, but share one cost: what one cut takes, no other
// can (Röger, Pommerening and Helmert, ECAI 2014, call this the basic variant).
#pragma once

#include <cstdint>
#include <vector>

#include "components/planner/budget.h"
#include "components/planner/cost_queue.h"
#include "components/planner/growing.h"
#include "components/planner/relaxed_task.h"

namespace goalnet::planner {

class LmCut {
 public:
  static constexpr std::int64_t kDeadEnd = INT64_MAX / 4;

  // Makes the tables for a task. If the budget runs out, nothing may be asked before the next restart().
  void restart(const RelaxedTask& relaxed, Budget& budget);
  // kDeadEnd if the goal is not even reachable in the relaxation. When the budget runs out in the middle,
  // what was counted so far is returned, which is admissible too; reachable() then means nothing.
  std::int64_t evaluate(const Word* state, Budget& budget);

  // Whether the relaxation reaches this from the state last evaluated.
  bool reachable(ConditionId condition) const;
  // After evaluate(): the cost that no cut has taken, of an action, and of reaching a proposition (at least
  // kDeadEnd if that is not possible).
  std::int64_t cost_left(std::int32_t action) const { return cost_left_[static_cast<std::size_t>(action)]; }
  std::int64_t cost_left_to(Proposition p) const { return proposition_cost_[static_cast<std::size_t>(p)]; }

 private:
  void explore(const Word* state, Budget& budget);
  void propagate(Budget& budget);
  void reach(Proposition p, std::int64_t cost);
  void update_supporter(std::int32_t op);
  void mark_goal_zone(Proposition p, Budget& budget);
  bool needs_zone(const RelaxedOperator& op) const;
  void find_cut(const Word* state, Budget& budget);

  const RelaxedTask* relaxed_ = nullptr;
  Growing<std::int64_t> cost_left_;  // by action
  Growing<std::int64_t> proposition_cost_;
  Growing<std::int32_t> unsatisfied_;  // by operator
  Growing<Proposition> supporter_;     // by operator: its most expensive precondition
  Growing<std::int64_t> supporter_cost_;
  std::vector<Proposition> zone_;                       // leads to the goal for free
  Growing<std::uint8_t> in_zone_, reached_;             // by proposition
  Growing<std::int32_t> precondition_count_, missing_;  // by operator
  Growing<std::int32_t> uses_;                          // by proposition; zero between uses
  std::vector<std::int32_t> pending_;                   // operators
  std::vector<Proposition> stack_;
  std::vector<std::int32_t> cut_;  // operators
  std::vector<std::int32_t> cut_actions_;
  Growing<std::uint8_t> in_cut_;  // by action
  CostQueue queue_;
};

}  // namespace goalnet::planner
