#include "components/planner/one_action.h"

#include <algorithm>
#include <array>
#include <span>

#include "components/planner/atom_table.h"

namespace goalnet::planner {

bool simple_goal(const Domain& domain, const Formula& goal, std::vector<GoalLiteral>* literals) {
  literals->clear();
  const auto add = [&](const Formula& part) {
    const bool negative = part.kind == Formula::Kind::kNot;
    const Formula& atom = negative ? part.children.front() : part;
    if (atom.kind != Formula::Kind::kAtom) return false;
    if (domain.is_derived(atom.atom.predicate)) return false;
    literals->push_back({&atom.atom, negative});
    return true;
  };
  if (goal.kind == Formula::Kind::kTrue) return true;
  if (goal.kind == Formula::Kind::kAnd) return std::all_of(goal.children.begin(), goal.children.end(), add);
  return add(goal);
}

const AtomPattern* contradiction(const std::vector<GoalLiteral>& goal) {
  if (std::none_of(goal.begin(), goal.end(), [](const GoalLiteral& l) { return l.negative; })) return nullptr;
  AtomTable wanted;
  std::array<ObjectId, 16> ids{};
  const auto arguments = [&](const AtomPattern& atom) {
    for (std::size_t i = 0; i < atom.arguments.size(); ++i) ids[i] = atom.arguments[i].value;
    return ids.data();
  };
  for (const GoalLiteral& l : goal) {
    if (!l.negative) wanted.add(l.atom->predicate, arguments(*l.atom), l.atom->arguments.size());
  }
  for (const GoalLiteral& l : goal) {
    if (l.negative && wanted.contains(l.atom->predicate, arguments(*l.atom), l.atom->arguments.size()))
      return l.atom;
  }
  return nullptr;
}

OneAction::OneAction(const CompiledDomain& compiled) : compiled_(compiled) {
  std::size_t most = 1;
  for (const CompiledSchema& schema : compiled.schemas) most = std::max(most, schema.slots.size());
  binding_.assign(most, -1);
}

bool OneAction::holds(const GoalLiteral& literal) const {
  return index_->holds_initially(*literal.atom, nullptr) != literal.negative;
}

bool OneAction::bind(const CompiledSchema& schema, std::int32_t slot, ObjectId object) {
  ObjectId& bound = binding_[static_cast<std::size_t>(slot)];
  if (bound >= 0) return bound == object;
  if (!index_->object_fits(object, schema.slot_sets[static_cast<std::size_t>(slot)])) return false;
  bound = object;
  return true;
}

bool OneAction::unify(const CompiledSchema& schema, const AtomPattern& pattern, const ObjectId* arguments) {
  for (std::size_t i = 0; i < pattern.arguments.size(); ++i) {
    const Term term = pattern.arguments[i];
    if (term.is_variable() ? !bind(schema, term.slot(), arguments[i]) : term.value != arguments[i])
      return false;
  }
  return true;
}

std::optional<OneAction::Found> OneAction::find(ProblemIndex& index, const std::vector<GoalLiteral>& goal,
                                                Budget& budget) {
  index_ = &index;
  goal_ = &goal;
  budget_ = &budget;
  // The action must produce every literal that does not hold; start from the one with the fewest producers.
  std::span<const EffectReference> producers;
  const GoalLiteral* wanted = nullptr;
  for (const GoalLiteral& literal : goal) {
    if (holds(literal)) continue;
    const auto candidates =
        compiled_
            .producers[2 * static_cast<std::size_t>(literal.atom->predicate) + (literal.negative ? 1 : 0)];
    if (wanted != nullptr && candidates.size() >= producers.size()) continue;
    producers = candidates;
    wanted = &literal;
  }
  if (wanted == nullptr) return std::nullopt;
  std::array<ObjectId, 16> arguments{};
  for (std::size_t i = 0; i < wanted->atom->arguments.size(); ++i)
    arguments[i] = wanted->atom->arguments[i].value;
  for (const EffectReference& reference : producers) {
    const CompiledSchema& schema = compiled_.schemas[static_cast<std::size_t>(reference.schema)];
    const CompiledEffect& effect = schema.effects[static_cast<std::size_t>(reference.effect)];
    std::fill_n(binding_.begin(), schema.slots.size(), -1);
    bool fits = unify(schema, effect.literal.atom, arguments.data());
    for (const auto& [slot, object] : schema.fixed) fits = fits && bind(schema, slot, object);
    if (fits && search(schema, &effect, true)) {
      return Found{reference.schema, {binding_.begin(), binding_.begin() + schema.parameter_count}};
    }
  }
  return std::nullopt;
}

// Binds what is still open from facts that hold and tries every way; true with binding_ left as found.
bool OneAction::search(const CompiledSchema& schema, const CompiledEffect* effect, bool parameters) {
  if (budget_->poll()) return false;
  const auto is_open = [this](Term term) {
    return term.is_variable() && binding_[static_cast<std::size_t>(term.slot())] < 0;
  };
  const std::array<const Condition*, 2> conditions = {&schema.precondition, &effect->condition};
  for (const Condition* condition : conditions) {
    for (const auto* literals : {&condition->fluent, &condition->fixed}) {
      for (const LiteralPattern& literal : *literals) {
        const auto& arguments = literal.atom.arguments;
        if (std::any_of(arguments.begin(), arguments.end(), is_open)) continue;
        if (index_->holds_initially(literal.atom, binding_.data()) == literal.negative) return false;
      }
    }
    for (const EqualityPattern& equality : condition->equalities) {
      if (is_open(equality.left) || is_open(equality.right)) continue;
      if ((equality.left.resolve(binding_.data()) == equality.right.resolve(binding_.data())) ==
          equality.negative) {
        return false;
      }
    }
  }
  std::int32_t open = -1;
  for (std::int32_t slot = 0; slot < schema.parameter_count && open < 0; ++slot) {
    if (binding_[static_cast<std::size_t>(slot)] < 0) open = slot;
  }
  for (std::size_t i = 0; i < effect->variables.size() && open < 0; ++i) {
    if (binding_[static_cast<std::size_t>(effect->variables[i])] < 0) open = effect->variables[i];
  }
  if (open < 0) {
    return condition_holds(schema, schema.precondition) && condition_holds(schema, effect->condition) &&
           accept(schema);
  }
  for (const Condition* condition : conditions) {
    for (const EqualityPattern& equality : condition->equalities) {
      if (equality.negative || is_open(equality.left) == is_open(equality.right)) continue;
      const bool left_open = is_open(equality.left);
      const std::int32_t slot = (left_open ? equality.left : equality.right).slot();
      const ObjectId value = (left_open ? equality.right : equality.left).resolve(binding_.data());
      if (bind(schema, slot, value) && search(schema, effect, parameters)) return true;
      binding_[static_cast<std::size_t>(slot)] = -1;
      return false;
    }
  }
  for (const Condition* condition : conditions) {
    for (const auto* literals : {&condition->fluent, &condition->fixed}) {
      for (const LiteralPattern& literal : *literals) {
        const auto& arguments = literal.atom.arguments;
        if (literal.negative || std::none_of(arguments.begin(), arguments.end(), is_open)) continue;
        auto facts = index_->facts(literal.atom.predicate);
        for (std::size_t i = 0; i < arguments.size(); ++i) {
          if (is_open(arguments[i])) continue;
          const auto fewer = index_->facts(literal.atom.predicate, i, arguments[i].resolve(binding_.data()));
          if (fewer.size() < facts.size()) facts = fewer;
        }
        std::array<std::int32_t, 16> opened{};
        std::size_t count = 0;
        for (const Term term : arguments) {
          if (is_open(term)) opened[count++] = term.slot();
        }
        for (const std::int32_t fact : facts) {
          if (unify(schema, literal.atom, index_->problem().initial.arguments(fact).data()) &&
              search(schema, effect, parameters)) {
            return true;
          }
          for (std::size_t i = 0; i < count; ++i) binding_[static_cast<std::size_t>(opened[i])] = -1;
        }
        return false;
      }
    }
  }
  for (const ObjectId object : index_->objects(schema.slot_sets[static_cast<std::size_t>(open)])) {
    binding_[static_cast<std::size_t>(open)] = object;
    if (search(schema, effect, parameters)) return true;
  }
  binding_[static_cast<std::size_t>(open)] = -1;
  return false;
}

bool OneAction::condition_holds(const CompiledSchema& schema, const Condition& condition) {
  const auto literal_holds = [this](const LiteralPattern& literal) {
    return index_->holds_initially(literal.atom, binding_.data()) != literal.negative;
  };
  const auto equality_holds = [this](const EqualityPattern& equality) {
    return (equality.left.resolve(binding_.data()) == equality.right.resolve(binding_.data())) !=
           equality.negative;
  };
  return std::all_of(condition.fluent.begin(), condition.fluent.end(), literal_holds) &&
         std::all_of(condition.fixed.begin(), condition.fixed.end(), literal_holds) &&
         std::all_of(condition.equalities.begin(), condition.equalities.end(), equality_holds) &&
         std::all_of(condition.complex.begin(), condition.complex.end(),
                     [&](const Formula& formula) { return formula_holds(schema, formula); });
}

bool OneAction::formula_holds(const CompiledSchema& schema, const Formula& formula) {
  if (budget_->poll()) return false;
  const auto child = [&](const Formula& inner) { return formula_holds(schema, inner); };
  switch (formula.kind) {
    case Formula::Kind::kTrue:
      return true;
    case Formula::Kind::kFalse:
      return false;
    case Formula::Kind::kAtom:
      return index_->holds_initially(formula.atom, binding_.data());
    case Formula::Kind::kEqual:
      return formula.atom.arguments[0].resolve(binding_.data()) ==
             formula.atom.arguments[1].resolve(binding_.data());
    case Formula::Kind::kNot:
      return !child(formula.children.front());
    case Formula::Kind::kAnd:
      return std::all_of(formula.children.begin(), formula.children.end(), child);
    case Formula::Kind::kOr:
      return std::any_of(formula.children.begin(), formula.children.end(), child);
    case Formula::Kind::kForall:
    case Formula::Kind::kExists: {
      const bool universal = formula.kind == Formula::Kind::kForall;
      const auto each = [&](const auto& self, std::size_t i) -> bool {
        if (i == formula.slots.size()) return child(formula.children.front());
        const auto slot = static_cast<std::size_t>(formula.slots[i]);
        bool result = universal;
        for (const ObjectId object : index_->objects(schema.slot_sets[slot])) {
          binding_[slot] = object;
          if (self(self, i + 1) != universal) {
            result = !universal;
            break;
          }
        }
        binding_[slot] = -1;
        return result;
      };
      return each(each, 0);
    }
  }
  return false;
}

// Whether the effect makes the literal's atom what the effect says, for some instance of its variables.
bool OneAction::happens(const CompiledSchema& schema, const CompiledEffect& effect,
                        const GoalLiteral& literal) {
  std::array<ObjectId, 16> arguments{};
  for (std::size_t i = 0; i < literal.atom->arguments.size(); ++i)
    arguments[i] = literal.atom->arguments[i].value;
  // The search may be in the middle of binding the variables of this same effect.
  std::vector<ObjectId>& outer = outer_;
  outer.clear();
  for (const std::int32_t slot : effect.variables) {
    outer.push_back(binding_[static_cast<std::size_t>(slot)]);
    binding_[static_cast<std::size_t>(slot)] = -1;
  }
  bool result = false;
  if (unify(schema, effect.literal.atom, arguments.data())) {
    const auto each = [&](const auto& self, std::size_t i) -> bool {
      if (i == effect.variables.size()) return condition_holds(schema, effect.condition);
      const auto slot = static_cast<std::size_t>(effect.variables[i]);
      if (binding_[slot] >= 0) return self(self, i + 1);
      for (const ObjectId object : index_->objects(schema.slot_sets[slot])) {
        binding_[slot] = object;
        const bool good = self(self, i + 1);
        binding_[slot] = -1;
        if (good) return true;
      }
      return false;
    };
    result = each(each, 0);
  }
  for (std::size_t i = effect.variables.size(); i-- > 0;) {
    binding_[static_cast<std::size_t>(effect.variables[i])] = outer[i];
  }
  return result;
}

bool OneAction::accept(const CompiledSchema& schema) {
  if (index_->cost(schema.cost, binding_.data()) < 0) return false;
  for (const GoalLiteral& literal : *goal_) {
    if (budget_->poll()) return false;
    bool added = false, deleted = false;
    for (const CompiledEffect& effect : schema.effects) {
      if (effect.literal.atom.predicate != literal.atom->predicate) continue;
      if (effect.literal.negative ? deleted : added) continue;
      if (happens(schema, effect, literal)) (effect.literal.negative ? deleted : added) = true;
    }
    const bool before = index_->holds_initially(*literal.atom, nullptr);
    const bool after = added || (before && !deleted);
    if (after == literal.negative) return false;
  }
  return true;
}

}  // namespace goalnet::planner
