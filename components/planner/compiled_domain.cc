#include "components/planner/compiled_domain.h"

#include <algorithm>

#include "components/planner/dominance.h"
#include "components/planner/normal_form.h"
#include "components/planner/schema_compiler.h"

namespace goalnet::planner {
namespace {

void collect_fluents(const Effect& effect, std::vector<std::uint8_t>* is_fluent) {
  if (effect.kind == Effect::Kind::kAdd || effect.kind == Effect::Kind::kDelete) {
    (*is_fluent)[static_cast<std::size_t>(effect.atom.predicate)] = 1;
  }
  for (const Effect& child : effect.children) collect_fluents(child, is_fluent);
}

}  // namespace

Condition split_condition(const std::vector<std::uint8_t>& is_fluent, Formula formula) {
  Condition result;
  std::vector<Formula> parts;
  parts.push_back(std::move(formula));
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Formula part = std::move(parts[i]);
    if (part.kind == Formula::Kind::kTrue) continue;
    if (part.kind == Formula::Kind::kAnd) {
      for (Formula& child : part.children) parts.push_back(std::move(child));
      continue;
    }
    const bool negative = part.kind == Formula::Kind::kNot;
    const Formula& atom = negative ? part.children[0] : part;
    if (atom.kind == Formula::Kind::kAtom) {
      const bool fluent = is_fluent[static_cast<std::size_t>(atom.atom.predicate)] != 0;
      (fluent ? result.fluent : result.fixed).push_back({atom.atom, negative});
    } else if (atom.kind == Formula::Kind::kEqual) {
      result.equalities.push_back({atom.atom.arguments[0], atom.atom.arguments[1], negative});
    } else {
      result.complex.push_back(std::move(part));
    }
  }
  return result;
}

CompiledDomain::CompiledDomain(const Domain& the_domain, const std::stop_token& stop)
    : domain(the_domain), is_fluent(static_cast<std::size_t>(the_domain.predicates.size()), 0) {
  for (const ActionSchema& action : domain.actions) collect_fluents(action.effect, &is_fluent);
  for (const DerivedPredicate& definition : domain.derived) {
    if (!domain.recursive(definition.predicate)) continue;
    is_fluent[static_cast<std::size_t>(definition.predicate)] = 1;
    CompiledAxiom axiom{definition.predicate, definition.parameter_count, definition.slots, {}};
    axiom.body = Normaliser(domain, axiom.slots, stop).normalise(definition.body);
    axioms.push_back(std::move(axiom));
  }
  for (std::size_t i = 0; i < domain.actions.size() && !stop.stop_requested(); ++i) {
    compile_action(*this, static_cast<std::int32_t>(i), stop);
  }
  if (stop.stop_requested()) return;
  mark_dominated_effects(*this);
  const auto type_count = static_cast<std::size_t>(domain.types.size());
  for (CompiledSchema& schema : schemas) {
    if (stop.stop_requested()) return;
    for (const TypeSet& types : schema.slots) {
      auto known = std::find(type_sets.begin(), type_sets.end(), types);
      if (known == type_sets.end()) {
        type_sets.push_back(types);
        known = type_sets.end() - 1;
        for (std::size_t type = 0; type < type_count; ++type) {
          allowed.push_back(domain.is_a(static_cast<TypeId>(type), types) ? 1 : 0);
        }
      }
      schema.slot_sets.push_back(static_cast<std::int32_t>(known - type_sets.begin()));
    }
  }
  producers.resize(2 * is_fluent.size());
  for (std::size_t s = 0; s < schemas.size(); ++s) {
    for (std::size_t e = 0; e < schemas[s].effects.size(); ++e) {
      const LiteralPattern& literal = schemas[s].effects[e].literal;
      producers[2 * static_cast<std::size_t>(literal.atom.predicate) + (literal.negative ? 1 : 0)].push_back(
          {static_cast<std::int32_t>(s), static_cast<std::int32_t>(e)});
    }
  }
}

}  // namespace goalnet::planner
