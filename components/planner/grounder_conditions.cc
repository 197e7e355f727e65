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
    if (!compiled_.axioms.empty()) definitions_.push_back({});
  }
  return 2 * atom + (negative ? 1 : 0);
}

// Appends the fluent and complex parts; false if one of them cannot hold. The static part is checked
// elsewhere.
bool Grounder::instantiate(const Condition& condition, Growing<ConditionId>* result) {
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

// There may be a million of them: in parts, so that it can be stopped. Junctions, numbered downwards, often
// come in the opposite order.
void Grounder::sort(Growing<ConditionId>& conditions) {
  const auto not_below = [](ConditionId a, ConditionId b) { return a <= b; };
  if (std::adjacent_find(conditions.begin(), conditions.end(), not_below) == conditions.end()) {
    std::reverse(conditions.begin(), conditions.end());
    return;
  }
  constexpr std::size_t kPart = 4096;
  const std::size_t size = conditions.size();
  const auto at = [&](std::size_t i) { return conditions.begin() + std::min(i, size); };
  for (std::size_t begin = 0; begin < size && !stopped_; begin += kPart) {
    std::sort(at(begin), at(begin + kPart));
    stopped_ = budget_->check();
  }
  for (std::size_t part = kPart; part < size && !stopped_; part *= 2) {
    for (std::size_t begin = 0; begin < size && !stopped_; begin += 2 * part) {
      std::inplace_merge(at(begin), at(begin + part), at(begin + 2 * part));
      stopped_ = budget_->check();
    }
  }
}

Grounder::Value Grounder::instantiate_junction(bool conjunction, Growing<ConditionId>& children) {
  const auto not_above = [](ConditionId a, ConditionId b) { return a >= b; };
  if (std::adjacent_find(children.begin(), children.end(), not_above) != children.end()) {  // rarely
    sort(children);
    children.truncate(
        static_cast<std::size_t>(std::unique(children.begin(), children.end()) - children.begin()));
  }
  if (children.empty()) return {conjunction ? Value::Kind::kTrue : Value::Kind::kFalse, 0};
  if (children.size() == 1) return {Value::Kind::kCondition, children[0]};
  Junction junction;
  junction.conjunction = conjunction;
  junction.begin = static_cast<std::uint32_t>(task_->junction_children.size());
  task_->junction_children.append(children);
  junction.end = static_cast<std::uint32_t>(task_->junction_children.size());
  task_->junctions.push_back(junction);
  return {Value::Kind::kCondition, ~static_cast<ConditionId>(task_->junctions.size() - 1)};
}

// What the static facts and equalities say while some variables are not bound yet.
Grounder::Known Grounder::known_value(const Formula& formula) const {
  const auto known = [](bool value) { return value ? Known::kTrue : Known::kFalse; };
  const auto opposite_of = [](Known value) {
    return value == Known::kOpen ? value : value == Known::kTrue ? Known::kFalse : Known::kTrue;
  };
  switch (formula.kind) {
    case Formula::Kind::kTrue:
      return Known::kTrue;
    case Formula::Kind::kFalse:
      return Known::kFalse;
    case Formula::Kind::kEqual:
      if (binder_.any_open(formula.atom)) return Known::kOpen;
      return known(formula.atom.arguments[0].resolve(binder_.data()) ==
                   formula.atom.arguments[1].resolve(binder_.data()));
    case Formula::Kind::kAtom:
      if (compiled_.is_fluent[static_cast<std::size_t>(formula.atom.predicate)] != 0) return Known::kOpen;
      if (binder_.any_open(formula.atom)) return Known::kOpen;
      return known(index_->holds_initially(formula.atom, binder_.data()));
    case Formula::Kind::kNot:
      return opposite_of(known_value(formula.children.front()));
    case Formula::Kind::kAnd:
    case Formula::Kind::kOr: {
      const Known deciding = formula.kind == Formula::Kind::kAnd ? Known::kFalse : Known::kTrue;
      Known result = opposite_of(deciding);
      for (const Formula& child : formula.children) {
        const Known value = known_value(child);
        if (value == deciding) return deciding;
        if (value == Known::kOpen) result = value;
      }
      return result;
    }
    case Formula::Kind::kForall:
    case Formula::Kind::kExists:
      return Known::kOpen;
  }
  return Known::kOpen;
}

// The objects that are worth trying for a quantified variable: all of its type, or, where a static fact has
// to hold (or, under 'forall', must not) for the rest to matter, those for which it does.
template <class Visit>
void Grounder::for_each_candidate(const Formula& inner, bool conjunction, std::int32_t slot,
                                  const Visit& visit) {
  const TypeSet& types = slots_[static_cast<std::size_t>(slot)];
  const std::vector<ObjectId>& all = objects_of(types);
  std::span<const std::int32_t> facts;
  const AtomPattern* join = nullptr;
  std::size_t position = 0;
  const auto consider = [&](const Formula& part) {
    const bool negative = part.kind == Formula::Kind::kNot;
    const Formula& atom = negative ? part.children.front() : part;
    if (atom.kind != Formula::Kind::kAtom || negative != conjunction) return;
    if (compiled_.is_fluent[static_cast<std::size_t>(atom.atom.predicate)] != 0) return;
    const TermList& arguments = atom.atom.arguments;
    const auto mine = std::find(arguments.begin(), arguments.end(), Term::variable(slot));
    if (mine == arguments.end()) return;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      const ObjectId bound = arguments[i].resolve(binder_.data());
      if (bound < 0) continue;
      const auto found = index_->facts(atom.atom.predicate, i, bound);
      if (found.size() >= (join == nullptr ? all.size() : facts.size())) continue;
      facts = found;
      join = &atom.atom;
      position = static_cast<std::size_t>(mine - arguments.begin());
    }
  };
  if (inner.kind == (conjunction ? Formula::Kind::kOr : Formula::Kind::kAnd)) {
    for (const Formula& part : inner.children) consider(part);
  } else {
    consider(inner);
  }
  if (join == nullptr) {
    for (const ObjectId object : all) {
      if (!visit(object)) return;
    }
    return;
  }
  std::vector<ObjectId> candidates;
  for (const std::int32_t fact : facts) {
    const ObjectId object = index_->problem().initial.arguments(fact)[position];
    if (index_->problem().object_is_a(object, types)) candidates.push_back(object);
  }
  std::sort(candidates.begin(), candidates.end());
  candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
  for (const ObjectId object : candidates) {
    if (!visit(object)) return;
  }
}

const std::vector<ObjectId>& Grounder::objects_of(const TypeSet& types) {
  const auto [place, is_new] = objects_.try_emplace(types);
  if (is_new) {
    for (ObjectId object = 0; object < index_->problem().object_count(); ++object) {
      if (stopped_ = budget_->poll(); stopped_) break;
      if (index_->problem().object_is_a(object, types)) place->second.push_back(object);
    }
  }
  return place->second;
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
      Growing<ConditionId> children;
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
      const Formula& inner = formula.children.front();
      for (const std::int32_t slot : formula.slots) binder_.values()[static_cast<std::size_t>(slot)] = -1;
      Growing<ConditionId> children;
      bool decided = false;
      const auto recurse = [&](const auto& self, std::size_t i) -> void {
        if (decided || stopped_) return;
        if (i == formula.slots.size()) {
          const Value value = instantiate(inner);
          if (value.kind == Value::Kind::kCondition) {
            children.push_back(value.condition);
          } else if ((value.kind == Value::Kind::kTrue) != conjunction) {
            decided = true;
          }
          return;
        }
        if (budget_->poll()) {
          stopped_ = true;
          return;
        }
        const auto slot = static_cast<std::size_t>(formula.slots[i]);
        for_each_candidate(inner, conjunction, formula.slots[i], [&](ObjectId object) {
          binder_.values()[slot] = object;
          const Known known = known_value(inner);
          // What is the same whatever the other variables are need not be written out for all of them.
          if (known == Known::kOpen || (known == Known::kTrue) != conjunction) self(self, i + 1);
          return !decided && !stopped_;
        });
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
