// How the grounder defines derived atoms that depend on themselves.
#include "components/planner/grounder.h"

#include <algorithm>

namespace goalnet::planner {

// The axioms of a derived atom; what they read is needed in the same sense as the atom: to hold, or not to
// hold.
void Grounder::define(Literal literal) {
  const auto atom = static_cast<std::size_t>(literal >> 1);
  const PredicateId predicate = task_->atoms.predicate(literal >> 1);
  if (!definitions_[atom].known) {
    Definition definition;
    definition.known = true;
    definition.axiom_begin = static_cast<std::uint32_t>(task_->axioms.size());
    for (const CompiledAxiom& axiom : compiled_.axioms) {
      if (axiom.predicate != predicate) continue;
      std::fill_n(binder_.values().begin(), axiom.slots.size(), -1);
      bool fits = true;
      const auto arguments = task_->atoms.arguments(literal >> 1);
      for (std::size_t i = 0; i < arguments.size(); ++i) {
        binder_.values()[i] = arguments[i];
        fits = fits && index_->problem().object_is_a(arguments[i], axiom.slots[i]);
      }
      if (!fits) continue;
      slots_ = axiom.slots;
      const Value value = instantiate(axiom.body);
      if (stopped_) return;
      if (value.kind == Value::Kind::kFalse) continue;
      GroundAxiom ground;
      ground.head = literal & ~1;
      ground.condition_begin = static_cast<std::uint32_t>(task_->conditions.size());
      if (value.kind == Value::Kind::kCondition) task_->conditions.push_back(value.condition);
      ground.condition_end = static_cast<std::uint32_t>(task_->conditions.size());
      task_->axioms.push_back(ground);
    }
    definition.axiom_end = static_cast<std::uint32_t>(task_->axioms.size());
    definitions_[atom] = definition;
  }
  for (std::uint32_t a = definitions_[atom].axiom_begin; a < definitions_[atom].axiom_end; ++a) {
    const GroundAxiom ground = task_->axioms[a];
    for (std::uint32_t i = ground.condition_begin; i < ground.condition_end; ++i) {
      const ConditionId condition = task_->conditions[i];
      (literal & 1) != 0 ? need_opposite(condition) : need(condition);
    }
  }
}

// Which atoms are derived, and how they are computed.
void Grounder::finish_axioms() {
  GroundTask& task = *task_;
  task.derived.assign(task.initial.size(), 0);
  for (std::size_t atom = 0; atom < task.derived.size(); ++atom) {
    const PredicateId predicate = task.atoms.predicate(static_cast<std::int32_t>(atom));
    if (!compiled_.domain.recursive(predicate)) continue;
    task.derived[atom] = compiled_.domain.layer[static_cast<std::size_t>(predicate)] + 1;
    task.changes[atom] = 1;
  }
  task.derivation.build(task);
}

}  // namespace goalnet::planner
