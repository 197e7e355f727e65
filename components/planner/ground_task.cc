#include "components/planner/ground_task.h"

#include <algorithm>

namespace goalnet::planner {

bool junction_holds(const GroundTask& task, const Word* state, std::int32_t junction) {
  const Junction& j = task.junctions[static_cast<std::size_t>(junction)];
  for (const ConditionId child : task.children(j)) {
    if (condition_holds(task, state, child) != j.conjunction) return !j.conjunction;
  }
  return j.conjunction;
}

void GroundTask::clear() {
  atoms.clear();
  initial.clear();
  changes.clear();
  needed.clear();
  actions.clear();
  bindings.clear();
  effects.clear();
  conditions.clear();
  junctions.clear();
  junction_children.clear();
  goal.clear();
  goal_impossible = false;
  axioms.clear();
  derived.clear();
  derivation.clear();
}

void apply_action(const GroundTask& task, const Word* state, const GroundAction& action, Word* next) {
  std::copy_n(state, task.words(), next);
  for (const GroundEffect& effect : task.effects_of(action)) {
    if (!effect.conditional() || all_hold(task, state, task.conditions_of(effect)))
      make_true(next, effect.literal);
  }
  if (!task.axioms.empty()) task.derivation.run(next);
}

void initial_state(const GroundTask& task, Budget& budget, std::vector<Word>* state) {
  state->assign(std::max<std::size_t>(task.words(), 1), 0);
  for (std::size_t atom = 0; atom < task.initial.size(); ++atom) {
    if (atom % 4096 == 0 && budget.check()) return;
    if (task.initial[atom] != 0) (*state)[atom >> 6] |= Word{1} << (atom & 63u);
  }
  if (!task.axioms.empty()) task.derivation.run(state->data());
}

}  // namespace goalnet::planner
