#include "components/goalnet/training/planner_feeding.h"

#include <algorithm>
#include <array>
#include <memory>
#include <string_view>

#include "components/goalnet/goal_planner.h"
#include "components/goalnet/sym_sim.h"

namespace goalnet::inference::training {

namespace {

// Relations that the rules know; facts of others stay as they were.
bool ruled(std::string_view relation) {
  constexpr std::array<std::string_view, 7> kRuled = {"Near",  "On",          "In",           "Grasping",
                                                      "state", "IsGraspable", "IsSqueezeable"};
  return std::find(kRuled.begin(), kRuled.end(), relation) != kRuled.end();
}

}  // namespace

Simulator planner_simulator() {
  const auto symbols = std::make_shared<Symbols>();
  return [symbols](const Goal& goal, WorldState& state) {
    SymState sym = to_sym_state(state.facts, *symbols);
    const auto plan = GoalPlanner().plan(to_sym_goal(goal, *symbols), sym);
    if (!plan || plan->empty()) return false;
    for (const SymAction& action : *plan) apply(action, sym);
    FactSet facts = to_fact_set(sym, *symbols);
    for (const Predicate& fact : state.facts) {
      if (!ruled(fact.relation)) facts.insert(fact);
    }
    state.facts = std::move(facts);
    return true;
  };
}

}  // namespace goalnet::inference::training
