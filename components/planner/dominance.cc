#include "components/planner/dominance.h"

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

namespace goalnet::planner {
namespace {

// What each slot of B is called in A.
using Renaming = std::vector<std::optional<Term>>;

bool maps_to(const AtomPattern& of_b, const AtomPattern& of_a, Renaming& names) {
  if (of_b.predicate != of_a.predicate) return false;
  for (std::size_t i = 0; i < of_b.arguments.size(); ++i) {
    const Term b = of_b.arguments[i], a = of_a.arguments[i];
    if (!b.is_variable()) {
      if (!(b == a)) return false;
      continue;
    }
    auto& name = names[static_cast<std::size_t>(b.slot())];
    if (!name) name = a;
    if (!(*name == a)) return false;
  }
  return true;
}

bool maps_to(const LiteralPattern& of_b, const LiteralPattern& of_a, Renaming& names) {
  return of_b.negative == of_a.negative && maps_to(of_b.atom, of_a.atom, names);
}

bool contains(std::span<const LiteralPattern> of_a, const LiteralPattern& of_b, const Renaming& names) {
  return std::any_of(of_a.begin(), of_a.end(), [&](const LiteralPattern& a) {
    Renaming trial = names;
    return maps_to(of_b, a, trial);
  });
}

// The same condition, literal by literal.
bool same_condition(const Condition& of_b, const Condition& of_a, Renaming names) {
  if (!of_b.complex.empty() || !of_a.complex.empty() || !of_b.equalities.empty() ||
      !of_a.equalities.empty()) {
    return false;
  }
  const auto same = [&](std::span<const LiteralPattern> b, std::span<const LiteralPattern> a) {
    return b.size() == a.size() &&
           std::all_of(b.begin(), b.end(), [&](const auto& l) { return contains(a, l, names); });
  };
  return same(of_b.fixed, of_a.fixed) && same(of_b.fluent, of_a.fluent);
}

bool has_effect(const CompiledSchema& a, const CompiledSchema& b, const CompiledEffect& of_b,
                const Renaming& names) {
  return std::any_of(a.effects.begin(), a.effects.end(), [&](const CompiledEffect& of_a) {
    if (of_a.variables.size() != of_b.variables.size()) return false;
    Renaming trial = names;
    for (std::size_t i = 0; i < of_b.variables.size(); ++i) {
      const auto slot_b = static_cast<std::size_t>(of_b.variables[i]),
                 slot_a = static_cast<std::size_t>(of_a.variables[i]);
      if (b.slots[slot_b] != a.slots[slot_a]) return false;
      trial[slot_b] = Term::variable(of_a.variables[i]);
    }
    return maps_to(of_b.literal, of_a.literal, trial) &&
           same_condition(of_b.condition, of_a.condition, trial);
  });
}

bool dominates(const Domain& domain, const CompiledSchema& b, const CompiledSchema& a,
               const CompiledEffect& of_a) {
  if (!b.cost.functions.empty() || b.cost.constant > a.cost.constant) return false;
  if (!b.precondition.complex.empty() || !b.precondition.equalities.empty()) return false;
  const auto achieves = [&](const CompiledEffect& of_b) {
    Renaming names(b.slots.size());
    if (!of_b.variables.empty() || !same_condition(of_b.condition, of_a.condition, names)) return false;
    if (!maps_to(of_b.literal, of_a.literal, names)) return false;
    for (std::int32_t slot = 0; slot < b.parameter_count; ++slot) {
      const auto i = static_cast<std::size_t>(slot);
      if (!names[i]) {
        const auto fixed =
            std::find_if(b.fixed.begin(), b.fixed.end(), [&](const auto& f) { return f.first == slot; });
        if (fixed == b.fixed.end()) return false;  // not determined by the literal
        names[i] = Term::object(fixed->second);
        continue;
      }
      // Whatever A's term can be, B must accept.
      TypeId type = 0;
      TypeSet types{&type, 1};
      if (names[i]->is_variable()) {
        types = a.slots[static_cast<std::size_t>(names[i]->slot())];
      } else {
        type = domain.constant_types[static_cast<std::size_t>(names[i]->value)];
      }
      const bool accepted =
          std::all_of(types.begin(), types.end(), [&](TypeId t) { return domain.is_a(t, b.slots[i]); });
      if (!accepted) return false;
    }
    const auto known = [&](std::span<const LiteralPattern> needs, std::span<const LiteralPattern> given) {
      return std::all_of(needs.begin(), needs.end(),
                         [&](const auto& l) { return contains(given, l, names); });
    };
    return known(b.precondition.fixed, a.precondition.fixed) &&
           known(b.precondition.fluent, a.precondition.fluent) &&
           std::all_of(b.effects.begin(), b.effects.end(),
                       [&](const CompiledEffect& e) { return has_effect(a, b, e, names); });
  };
  return std::any_of(b.effects.begin(), b.effects.end(), achieves);
}

}  // namespace

void mark_dominated_effects(CompiledDomain& compiled) {
  // Quadratic in the number of schemas; domains with very many would only gain from it by luck.
  if (compiled.schemas.size() > 400) return;
  const auto kind = [](const LiteralPattern& literal) {
    return 2 * static_cast<std::size_t>(literal.atom.predicate) + (literal.negative ? 1 : 0);
  };
  // By kind of literal: the schemas that produce it; most pairs of schemas have nothing in common.
  std::vector<std::vector<const CompiledSchema*>> producers(
      2 * static_cast<std::size_t>(compiled.domain.predicates.size()));
  for (const CompiledSchema& b : compiled.schemas) {
    if (!b.cost.functions.empty() || !b.precondition.complex.empty() || !b.precondition.equalities.empty())
      continue;
    for (const CompiledEffect& effect : b.effects) {
      auto& list = producers[kind(effect.literal)];
      if (effect.variables.empty() && (list.empty() || list.back() != &b)) list.push_back(&b);
    }
  }
  for (CompiledSchema& a : compiled.schemas) {
    for (CompiledEffect& effect : a.effects) {
      if (!effect.variables.empty()) continue;
      const auto& candidates = producers[kind(effect.literal)];
      // B must have fewer parameters, so that no two schemas dominate each other.
      effect.dominated = std::any_of(candidates.begin(), candidates.end(), [&](const CompiledSchema* b) {
        if (&a == b || b->parameter_count >= a.parameter_count) return false;
        if (b->precondition.fluent.size() > a.precondition.fluent.size() ||
            b->effects.size() > a.effects.size())
          return false;
        return dominates(compiled.domain, *b, a, effect);
      });
    }
  }
}

}  // namespace goalnet::planner
