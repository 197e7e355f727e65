// How the grounder turns conditions with bound variables into those of the task.
#include "components/planner/grounder.h"

#include <algorithm>
#include <array>

namespace goalnet::planner {

Literal Grounder::literal_for(const AtomPattern& pattern, bool negative) {
  std::array<ObjectId, 16> ids{};
  for (std::size_t i = 0; i < pattern.arguments.size(); ++i)
    ids[i] = pattern.arguments[i].resolve(binder_.data());
  bool is_new = false;
  const std::int32_t atom =
      task_->atoms.add(pattern.predicate, ids.data(), pattern.arguments.size(), &is_new);
  if (is_new) {
    const bool holds =
        index_->problem().initial.contains(pattern.predicate, ids.data(), pattern.arguments.size());
    task_->initial.push_back(holds ? 1 : 0);
    task_->changes.push_back(0);
    task_->needed.push_back(0);
    task_->needed.push_back(0);
  }
  return 2 * atom + (negative ? 1 : 0);
}

// Appends the fluent and complex parts; false if one of them cannot hold. The static part is checked
// elsewhere.
bool Grounder::instantiate(const Condition& condition, std::vector<ConditionId>* result) {
  for (const LiteralPattern& literal : condition.fluent)
    result->push_back(literal_for(literal.atom, literal.negative));
  for (const Formula& formula : condition.complex) {
    const Value value = instantiate(formula);
    if (value.kind == Value::Kind::kFalse) return false;
    if (value.kind != Value::Kind::kCondition) continue;
    // A conjunction dissolves into the list.
    if (value.condition < 0 && task_->junctions[static_cast<std::size_t>(~value.condition)].conjunction) {
      const Junction junction = task_->junctions[static_cast<std::size_t>(~value.condition)];
      for (std::uint32_t i = junction.begin; i < junction.end; ++i)
        result->push_back(task_->junction_children[i]);
    } else {
      result->push_back(value.condition);
    }
  }
  return true;
}

Grounder::Value Grounder::instantiate_junction(bool conjunction, std::vector<ConditionId>& children) {
  std::sort(children.begin(), children.end());
  children.erase(std::unique(children.begin(), children.end()), children.end());
  if (children.empty()) return {conjunction ? Value::Kind::kTrue : Value::Kind::kFalse, 0};
  if (children.size() == 1) return {Value::Kind::kCondition, children[0]};
  Junction junction;
  junction.conjunction = conjunction;
  junction.begin = static_cast<std::uint32_t>(task_->junction_children.size());
  task_->junction_children.insert(task_->junction_children.end(), children.begin(), children.end());
  junction.end = static_cast<std::uint32_t>(task_->junction_children.size());
  task_->junctions.push_back(junction);
  return {Value::Kind::kCondition, ~static_cast<ConditionId>(task_->junctions.size() - 1)};
}

Grounder::Value Grounder::instantiate(const Formula& formula) {
  const auto constant = [](bool value) { return Value{value ? Value::Kind::kTrue : Value::Kind::kFalse, 0}; };
  if (stopped_ || budget_->poll()) {
    stopped_ = true;
    return constant(false);
  }
  switch (formula.kind) {
    case Formula::Kind::kTrue:
      return constant(true);
    case Formula::Kind::kFalse:
      return constant(false);
    case Formula::Kind::kEqual:
      return constant(formula.atom.arguments[0].resolve(binder_.data()) ==
                      formula.atom.arguments[1].resolve(binder_.data()));
    case Formula::Kind::kAtom:
    case Formula::Kind::kNot: {
      const bool negative = formula.kind == Formula::Kind::kNot;
      const Formula& inner = negative ? formula.children.front() : formula;
      if (inner.kind == Formula::Kind::kEqual) {
        return constant(instantiate(inner).kind != Value::Kind::kTrue);
      }
      if (compiled_.is_fluent[static_cast<std::size_t>(inner.atom.predicate)] == 0) {
        return constant(index_->holds_initially(inner.atom, binder_.data()) != negative);
      }
      return {Value::Kind::kCondition, literal_for(inner.atom, negative)};
    }
    case Formula::Kind::kAnd:
    case Formula::Kind::kOr: {
      const bool conjunction = formula.kind == Formula::Kind::kAnd;
      std::vector<ConditionId> children;
      for (const Formula& child : formula.children) {
        const Value value = instantiate(child);
        if (value.kind == Value::Kind::kCondition) {
          children.push_back(value.condition);
        } else if ((value.kind == Value::Kind::kTrue) != conjunction) {
          return value;
        }
      }
      return instantiate_junction(conjunction, children);
    }
    case Formula::Kind::kForall:
    case Formula::Kind::kExists: {
      const bool conjunction = formula.kind == Formula::Kind::kForall;
      std::vector<ConditionId> children;
      bool decided = false;
      const auto recurse = [&](const auto& self, std::size_t i) -> void {
        if (decided || stopped_) return;
        if (i == formula.slots.size()) {
          const Value value = instantiate(formula.children.front());
          if (value.kind == Value::Kind::kCondition) {
            children.push_back(value.condition);
          } else if ((value.kind == Value::Kind::kTrue) != conjunction) {
            decided = true;
          }
          return;
        }
        const auto slot = static_cast<std::size_t>(formula.slots[i]);
        const Problem& problem = index_->problem();
        const TypeSet& types = slots_[slot];
        for (ObjectId object = 0; object < problem.object_count() && !decided; ++object) {
          if (!problem.object_is_a(object, types)) continue;
          binder_.values()[slot] = object;
          self(self, i + 1);
        }
        binder_.values()[slot] = -1;
      };
      recurse(recurse, 0);
      if (decided) return constant(!conjunction);
      return instantiate_junction(conjunction, children);
    }
  }
  return constant(false);
}

}  // namespace goalnet::planner
