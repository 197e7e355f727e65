// Goals to actions under the benchmark's rules, in microseconds: almost every predicted step needs one
// action. What it cannot do (goals that need a real search) goes to a general planner that the caller may
// plug in.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "components/goalnet/sym_sim.h"

namespace goalnet::inference {

struct SymGoal {
  std::vector<SymFact> positive, negative;
  bool empty() const { return positive.empty() && negative.empty(); }
};

SymGoal to_sym_goal(const Goal& goal, Symbols& symbols);
bool satisfied(const SymGoal& goal, const SymState& state);

// A general planner: a plan for `goal` from `state`, or nothing when there is none.
using FullPlanner =
    std::function<std::optional<std::vector<SymAction>>(const SymGoal& goal, const SymState& state)>;

class GoalPlanner {
 public:
  explicit GoalPlanner(FullPlanner full_planner = {}) : full_planner_(std::move(full_planner)) {}

  // A plan of the fewest actions where one action, or the natural run to one action, reaches the goal; else
  // what the full planner finds; else the predicates one after the other, as far as that works out. Empty
  // when the goal holds already; nothing when no plan was found.
  std::optional<std::vector<SymAction>> plan(const SymGoal& goal, const SymState& state) const;

 private:
  FullPlanner full_planner_;
};

}  // namespace goalnet::inference
