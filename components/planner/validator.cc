#include "components/planner/validator.h"

#include <algorithm>

#include "components/planner/interpreter.h"

namespace goalnet::planner {

Expected<Validation> validate(const Problem& problem, const std::vector<Action>& plan) {
  const Interpreter interpreter(problem);
  AtomSet state;
  state.assign(problem.initial);
  interpreter.complete(state);
  Validation result;
  std::vector<ObjectId> binding;
  for (std::size_t step = 0; step < plan.size(); ++step) {
    const std::string where = "step " + std::to_string(step + 1) + ", (" + to_string(plan[step]) + "): ";
    const auto schema = interpreter.bind(plan[step], binding);
    if (!schema) return fail(schema.error().outcome, where + schema.error().message);
    const ActionSchema& action = **schema;
    if (!interpreter.holds(action.precondition, action.slots, binding, state)) {
      return fail(Outcome::kNoPlan,
                  where + interpreter.why_not(action.precondition, action.slots, binding, state));
    }
    const auto cost = interpreter.cost(action, binding);
    if (!cost) return fail(cost.error().outcome, where + cost.error().message);
    result.cost += *cost;
    for (const AtomChange& change : interpreter.changes(action.effect, action.slots, binding, state)) {
      state.set(change.predicate, change.arguments.data(), change.arguments.size(), change.added);
    }
    interpreter.complete(state);
  }
  binding.assign(problem.goal_slots.size(), 0);
  if (!interpreter.holds(problem.goal, problem.goal_slots, binding, state)) {
    return fail(Outcome::kNoPlan, "after the last step the goal is not reached: " +
                                      interpreter.why_not(problem.goal, problem.goal_slots, binding, state));
  }
  for (std::int32_t atom = 0; atom < state.table().size(); ++atom) {
    if (!state.holds(atom)) continue;
    std::string fact = "(" + problem.domain().predicates.name(state.table().predicate(atom));
    for (const ObjectId id : state.table().arguments(atom)) fact += " " + problem.object_name(id);
    result.final_facts.push_back(fact + ")");
  }
  std::sort(result.final_facts.begin(), result.final_facts.end());
  return result;
}

}  // namespace goalnet::planner
