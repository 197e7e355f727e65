// What the planner says: plans with the names of actions, and why there is none.
#include <algorithm>

#include "components/planner/pair_reachability.h"
#include "components/planner/planner_impl.h"

namespace goalnet::planner {

Action Planner::Impl::name_of(std::int32_t schema, const ObjectId* binding) const {
  const CompiledSchema& compiled_schema = compiled.schemas[static_cast<std::size_t>(schema)];
  const ActionSchema& action = domain.actions[static_cast<std::size_t>(compiled_schema.action)];
  Action result{std::string(action.name), {}};
  for (std::int32_t i = 0; i < action.parameter_count; ++i) {
    result.arguments.push_back(index.problem().object_name(binding[i]));
  }
  return result;
}

std::int64_t Planner::Impl::cost_of(const std::vector<std::int32_t>& actions) const {
  std::int64_t cost = 0;
  for (const std::int32_t action : actions) cost += task.actions[static_cast<std::size_t>(action)].cost;
  return cost;
}

Expected<Plan> Planner::Impl::stopped(const Budget& budget, const SolveOptions& options) const {
  if (budget.reason() == Budget::Reason::kCancelled)
    return fail(Outcome::kCancelled, "planning was cancelled");
  const double limit = std::chrono::duration<double>(options.time_limit).count();
  return fail(Outcome::kTimeLimit,
              "no plan found within " + std::to_string(limit) + " s; that there is none is not known");
}

std::string Planner::Impl::literal_text(Literal literal) const {
  const AtomRef atom = task.atoms[literal >> 1];
  std::string text = "(" + domain.predicates.name(atom.predicate);
  for (const ObjectId id : atom.arguments) text += " " + index.problem().object_name(id);
  return (literal & 1) != 0 ? "(not " + text + "))" : text + ")";
}

std::string Planner::Impl::unreachable_message() const {
  for (const ConditionId condition : task.goal) {
    if (condition >= 0 && !lm_cut.reachable(condition)) {
      return "there is no plan: nothing can make " + literal_text(condition) + " true";
    }
  }
  return "there is no plan: nothing leads to the goal";
}

// Why every state was tried in vain, where two goals can never hold together; or "".
std::string Planner::Impl::exclusive_goals_message(Budget& budget) const {
  PairReachability pairs;
  if (!pairs.compute(task, budget)) return "";
  for (std::size_t i = 0; i < task.goal.size(); ++i) {
    for (std::size_t j = 0; j < i && !budget.poll(); ++j) {
      if (task.goal[i] < 0 || task.goal[j] < 0 || !pairs.exclusive(task.goal[i], task.goal[j])) continue;
      return "there is no plan: " + literal_text(task.goal[j]) + " and " + literal_text(task.goal[i]) +
             " exclude each other";
    }
  }
  return "";
}

void Planner::Impl::name_actions(Plan& plan) const {
  for (const std::int32_t action : best) {
    const GroundAction& ground = task.actions[static_cast<std::size_t>(action)];
    plan.actions.push_back(name_of(ground.schema, task.bindings.data() + ground.binding));
  }
}

void Planner::Impl::tell(Plan plan, const SolveOptions& options) const {
  if (!options.on_plan) return;
  name_actions(plan);
  plan.lower_bound = std::min(plan.lower_bound, plan.cost);
  options.on_plan(plan);
}

Expected<Plan> Planner::Impl::finish(Plan plan, bool found, Budget& budget, const SolveOptions& options) {
  if (budget.reason() == Budget::Reason::kCancelled) return stopped(budget, options);
  if (!found) {
    if (exhausted) {
      const std::string why = exclusive_goals_message(budget);
      return fail(Outcome::kNoPlan,
                  why.empty() ? "there is no plan: every state that could lead on was tried" : why);
    }
    if (budget.reason() == Budget::Reason::kTime) return stopped(budget, options);
    return fail(Outcome::kStepLimit,
                "no plan found within the memory and node limits; that there is none is not known");
  }
  name_actions(plan);
  return plan;
}

}  // namespace goalnet::planner
