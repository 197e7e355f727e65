#include "components/planner/binder.h"

#include <algorithm>

namespace goalnet::planner {

Binder::Binder(const CompiledDomain& compiled) {
  std::size_t most = 64;
  for (const CompiledSchema& schema : compiled.schemas) most = std::max(most, schema.slots.size());
  for (const CompiledAxiom& axiom : compiled.axioms) most = std::max(most, axiom.slots.size());
  values_.assign(most, -1);
}

bool Binder::begin(const CompiledSchema& schema) {
  std::fill_n(values_.begin(), schema.slots.size(), -1);
  for (const auto& [slot, object] : schema.fixed) {
    if (!index_->problem().present(object)) return false;
    values_[static_cast<std::size_t>(slot)] = object;
  }
  return true;
}

bool Binder::bind(const CompiledSchema& schema, std::int32_t slot, ObjectId object) {
  ObjectId& bound = values_[static_cast<std::size_t>(slot)];
  if (bound >= 0) return bound == object;
  if (!index_->object_fits(object, schema.slot_sets[static_cast<std::size_t>(slot)])) return false;
  bound = object;
  return true;
}

bool Binder::unify(const CompiledSchema& schema, const AtomPattern& pattern, AtomRef atom) {
  for (std::size_t i = 0; i < pattern.arguments.size(); ++i) {
    const Term term = pattern.arguments[i];
    if (term.is_variable()) {
      if (!bind(schema, term.slot(), atom.arguments[i])) return false;
    } else if (term.value != atom.arguments[i]) {
      return false;
    }
  }
  return true;
}

bool Binder::static_part_holds(const Condition& condition) const {
  for (const EqualityPattern& equality : condition.equalities) {
    if ((equality.left.resolve(data()) == equality.right.resolve(data())) == equality.negative) return false;
  }
  for (const LiteralPattern& literal : condition.fixed) {
    if (index_->holds_initially(literal.atom, data()) == literal.negative) return false;
  }
  return true;
}

bool Binder::any_open(const AtomPattern& atom) const {
  return std::any_of(atom.arguments.begin(), atom.arguments.end(),
                     [this](Term term) { return is_open(term); });
}

bool Binder::refused(const Condition& condition) const {
  for (const EqualityPattern& equality : condition.equalities) {
    if (is_open(equality.left) || is_open(equality.right)) continue;
    if ((equality.left.resolve(data()) == equality.right.resolve(data())) == equality.negative) return true;
  }
  for (const LiteralPattern& literal : condition.fixed) {
    if (any_open(literal.atom)) continue;
    if (index_->holds_initially(literal.atom, data()) == literal.negative) return true;
  }
  if (reachable_ == nullptr) return false;
  return std::any_of(condition.fluent.begin(), condition.fluent.end(), [this](const LiteralPattern& literal) {
    return !literal.negative && !is_reachable(literal.atom);
  });
}

std::int32_t Binder::first_open(const CompiledSchema& schema, const CompiledEffect* effect,
                                bool parameters) const {
  for (std::int32_t slot = 0; parameters && slot < schema.parameter_count; ++slot) {
    if (values_[static_cast<std::size_t>(slot)] < 0) return slot;
  }
  if (effect == nullptr) return -1;
  for (const std::int32_t slot : effect->variables) {
    if (values_[static_cast<std::size_t>(slot)] < 0) return slot;
  }
  return -1;
}

// An equality with one open side decides it.
const EqualityPattern* Binder::decisive_equality(const Condition& condition) const {
  for (const EqualityPattern& equality : condition.equalities) {
    if (!equality.negative && is_open(equality.left) != is_open(equality.right)) return &equality;
  }
  return nullptr;
}

void Binder::choose_join(const Condition& condition, Join* best) const {
  for (const LiteralPattern& literal : condition.fixed) {
    if (literal.negative || !any_open(literal.atom)) continue;
    const auto& arguments = literal.atom.arguments;
    auto facts = index_->facts(literal.atom.predicate);
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      if (is_open(arguments[i])) continue;
      const auto fewer = index_->facts(literal.atom.predicate, i, arguments[i].resolve(data()));
      if (fewer.size() < facts.size()) facts = fewer;
    }
    if (best->atom == nullptr || facts.size() < best->size)
      *best = {&literal.atom, facts.size(), false, facts, {}};
  }
  if (reachable_ != nullptr) choose_reachable(condition, best);
}

void Binder::choose_reachable(const Condition& condition, Join* best) const {
  for (const LiteralPattern& literal : condition.fluent) {
    const AtomPattern& atom = literal.atom;
    if (literal.negative || !reachable_->covers(atom.predicate) || !any_open(atom)) continue;
    AtomLists::List list = reachable_->with(atom.predicate);
    for (std::size_t i = 0; i < atom.arguments.size(); ++i) {
      if (is_open(atom.arguments[i])) continue;
      const auto fewer = reachable_->with(atom.predicate, i, atom.arguments[i].resolve(data()));
      if (fewer.size < list.size) list = fewer;
    }
    const auto size = static_cast<std::size_t>(list.size);
    if (best->atom == nullptr || size < best->size) *best = {&atom, size, true, {}, list};
  }
}

bool Binder::is_reachable(const AtomPattern& atom) const {
  if (!reachable_->covers(atom.predicate) || any_open(atom)) return true;
  std::array<ObjectId, 16> ids{};
  for (std::size_t i = 0; i < atom.arguments.size(); ++i) ids[i] = atom.arguments[i].resolve(data());
  return reachable_->contains(atom.predicate, ids.data(), atom.arguments.size());
}

}  // namespace goalnet::planner
