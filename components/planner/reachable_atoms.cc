#include "components/planner/reachable_atoms.h"

#include <algorithm>
#include <array>

namespace goalnet::planner {

bool ReachableAtoms::asks_for_atoms(const Condition& condition) const {
  return std::any_of(condition.fluent.begin(), condition.fluent.end(), [this](const LiteralPattern& literal) {
    return !literal.negative && atoms_.covers(literal.atom.predicate);
  });
}

void ReachableAtoms::find_triggers() {
  if (!triggers_.empty()) return;
  triggers_.resize(static_cast<std::size_t>(compiled_.domain.predicates.size()));
  const auto add = [&](std::size_t schema, std::size_t effect, const Condition& condition) {
    for (const LiteralPattern& literal : condition.fluent) {
      if (literal.negative) continue;
      triggers_[static_cast<std::size_t>(literal.atom.predicate)].push_back(
          {static_cast<std::int32_t>(schema), effect, &literal.atom});
    }
  };
  for (std::size_t s = 0; s < compiled_.schemas.size(); ++s) {
    const CompiledSchema& schema = compiled_.schemas[s];
    add(s, kAllEffects, schema.precondition);
    for (std::size_t e = 0; e < schema.effects.size(); ++e) add(s, e, schema.effects[e].condition);
  }
}

const AtomLists* ReachableAtoms::compute(ProblemIndex& index, std::int64_t most_firings, Budget& budget) {
  std::vector<std::uint8_t> covered = compiled_.is_fluent;
  for (PredicateId predicate = 0; predicate < compiled_.domain.predicates.size(); ++predicate) {
    if (compiled_.domain.recursive(predicate)) covered[static_cast<std::size_t>(predicate)] = 0;
  }
  atoms_.restart(std::move(covered));
  find_triggers();
  firings_ = 0;
  most_firings_ = most_firings;
  binder_.restart(index, budget);
  binder_.limit_to(&atoms_);
  const AtomTable& initial = index.problem().initial;
  for (std::int32_t atom = 0; atom < initial.size(); ++atom) {
    if (budget.poll()) return nullptr;
    const auto arguments = initial.arguments(atom);
    if (atoms_.covers(initial.predicate(atom)))
      atoms_.add(initial.predicate(atom), arguments.data(), arguments.size());
  }
  for (const CompiledSchema& schema : compiled_.schemas) {
    if (!asks_for_atoms(schema.precondition) && binder_.begin(schema)) fire(schema, kAllEffects);
  }
  for (std::int32_t atom = 0; atom < atoms_.size(); ++atom) {
    const AtomRef trigger = atoms_[atom];
    for (const Trigger& on : triggers_[static_cast<std::size_t>(trigger.predicate)]) {
      if (budget.poll() || firings_ > most_firings_) return nullptr;
      const CompiledSchema& schema = compiled_.schemas[static_cast<std::size_t>(on.schema)];
      if (binder_.begin(schema) && binder_.unify(schema, *on.atom, trigger)) fire(schema, on.effect);
    }
  }
  return budget.stopped() || firings_ > most_firings_ ? nullptr : &atoms_;
}

// Every way to bind what is still open.
void ReachableAtoms::fire(const CompiledSchema& schema, std::size_t effect) {
  const auto count = [this] { return ++firings_ <= most_firings_; };
  if (effect != kAllEffects) {
    const CompiledEffect& one = schema.effects[effect];
    if (one.literal.negative || !atoms_.covers(one.literal.atom.predicate)) return;
    binder_.each(schema, &one, true, [&] {
      produce(one);
      return count();
    });
    return;
  }
  binder_.each(schema, nullptr, true, [&] {
    for (const CompiledEffect& any : schema.effects) {
      if (any.literal.negative || !atoms_.covers(any.literal.atom.predicate)) continue;
      binder_.each(schema, &any, false, [&] {
        produce(any);
        return count();
      });
    }
    return count();
  });
}

void ReachableAtoms::produce(const CompiledEffect& effect) {
  const AtomPattern& atom = effect.literal.atom;
  std::array<ObjectId, 16> ids{};
  for (std::size_t i = 0; i < atom.arguments.size(); ++i) ids[i] = atom.arguments[i].resolve(binder_.data());
  atoms_.add(atom.predicate, ids.data(), atom.arguments.size());
}

}  // namespace goalnet::planner
