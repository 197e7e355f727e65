#include "components/planner/attainable.h"

#include <algorithm>
#include <array>

namespace goalnet::planner {
namespace {

std::size_t kind_of(PredicateId predicate, bool negative) {
  return 2 * static_cast<std::size_t>(predicate) + (negative ? 1 : 0);
}

// The kinds of literal worth asking about. The others are produced by an action that asks for no static fact
// and for no doubtful one; what it needs not to hold is taken for granted.
std::vector<std::uint8_t> doubtful_kinds(const CompiledDomain& compiled) {
  std::vector<std::uint8_t> doubtful(compiled.producers.size(), 1);
  if (doubtful.empty()) return doubtful;  // compiling was cancelled
  const auto easy = [&](const Condition& condition) {
    return std::all_of(condition.fixed.begin(), condition.fixed.end(),
                       [](const auto& l) { return l.negative; }) &&
           std::all_of(condition.fluent.begin(), condition.fluent.end(), [&](const LiteralPattern& literal) {
             return literal.negative || doubtful[kind_of(literal.atom.predicate, false)] == 0;
           });
  };
  const auto easily_produced = [&](const EffectReference& reference) {
    const CompiledSchema& schema = compiled.schemas[static_cast<std::size_t>(reference.schema)];
    return easy(schema.precondition) &&
           easy(schema.effects[static_cast<std::size_t>(reference.effect)].condition);
  };
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t kind = 0; kind < doubtful.size(); ++kind) {
      const auto producers = compiled.producers[kind];
      if (doubtful[kind] == 0 || std::none_of(producers.begin(), producers.end(), easily_produced)) continue;
      doubtful[kind] = 0;
      changed = true;
    }
  }
  for (PredicateId predicate = 0; predicate < compiled.domain.predicates.size(); ++predicate) {
    if (!compiled.domain.recursive(predicate)) continue;
    doubtful[kind_of(predicate, false)] = doubtful[kind_of(predicate, true)] = 0;  // computed, not produced
  }
  return doubtful;
}

}  // namespace

Attainable::Attainable(const CompiledDomain& compiled)
    : compiled_(compiled), doubtful_(doubtful_kinds(compiled)), binders_(kDeepest, Binder(compiled)) {}

void Attainable::restart(ProblemIndex& index, Budget& budget) {
  index_ = &index;
  for (Binder& binder : binders_) binder.restart(index, budget);
  asked_.clear();
  answers_.clear();
}

bool Attainable::can_hold(std::span<const LiteralPattern> literals, const ObjectId* binding) {
  return can_hold(literals, binding, 0);
}

bool Attainable::can_hold(std::span<const LiteralPattern> literals, const ObjectId* binding,
                          std::size_t depth) {
  return std::all_of(literals.begin(), literals.end(), [&](const LiteralPattern& literal) {
    return ask(literal.atom, literal.negative, binding, depth);
  });
}

bool Attainable::ask(const AtomPattern& atom, bool negative, const ObjectId* binding, std::size_t depth) {
  const std::size_t kind = kind_of(atom.predicate, negative);
  if (doubtful_[kind] == 0) return true;
  std::array<ObjectId, 16> ids{};
  const std::size_t count = atom.arguments.size();
  for (std::size_t i = 0; i < count; ++i) ids[i] = atom.arguments[i].resolve(binding);
  if (index_->problem().initial.contains(atom.predicate, ids.data(), count) != negative) return true;
  const auto key = static_cast<PredicateId>(kind);
  if (depth == kDeepest) {
    const std::int32_t known = asked_.find(key, ids.data(), count);
    return known == AtomTable::kNone || answers_[static_cast<std::size_t>(known)] != kNo;
  }
  bool is_new = false;
  const auto entry = static_cast<std::size_t>(asked_.add(key, ids.data(), count, &is_new));
  if (!is_new) return answers_[entry] != kNo;  // while it is being asked about: perhaps
  answers_.push_back(kPerhaps);
  if (!produced(kind, {atom.predicate, {ids.data(), count}}, depth)) answers_[entry] = kNo;
  return answers_[entry] != kNo;
}

bool Attainable::produced(std::size_t kind, AtomRef atom, std::size_t depth) {
  Binder& binder = binders_[depth];
  int tried = 0;
  for (const EffectReference& reference : compiled_.producers[kind]) {
    const CompiledSchema& schema = compiled_.schemas[static_cast<std::size_t>(reference.schema)];
    const CompiledEffect& effect = schema.effects[static_cast<std::size_t>(reference.effect)];
    if (!binder.begin(schema) || !binder.unify(schema, effect.literal.atom, atom)) continue;
    const bool none = binder.each(schema, &effect, true, [&] {
      if (++tried > kMostTried) return false;
      return !(binder.static_part_holds(schema.precondition) && binder.static_part_holds(effect.condition) &&
               can_hold(schema.precondition.fluent, binder.data(), depth + 1) &&
               can_hold(effect.condition.fluent, binder.data(), depth + 1));
    });
    if (!none) return true;
  }
  return false;
}

}  // namespace goalnet::planner
