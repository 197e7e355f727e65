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

CompiledDomain::CompiledDomain(const Domain& the_domain, const std::stop_token& stop)
    : domain(the_domain), is_fluent(static_cast<std::size_t>(the_domain.predicates.size()), 0) {
  for (const ActionSchema& action : domain.actions) {
    if (stop.stop_requested()) return;
    collect_fluents(action.effect, &is_fluent);
  }
  for (const DerivedPredicate& definition : domain.derived) {
    if (!domain.recursive(definition.predicate)) continue;
    is_fluent[static_cast<std::size_t>(definition.predicate)] = 1;
    std::vector<TypeSet> slots(definition.slots.begin(), definition.slots.end());
    CompiledAxiom axiom{definition.predicate, definition.parameter_count, {}, {}};
    axiom.body = Normaliser(domain, slots, arena, stop).normalise(definition.body);
    axiom.slots = arena.copy(slots);
    axioms.push_back(axiom);
  }
  compile_actions(*this, stop);
  if (stop.stop_requested()) return;
  mark_dominated_effects(*this);
  const auto type_count = static_cast<std::size_t>(domain.types.size());
  for (CompiledSchema& schema : schemas) {
    if (stop.stop_requested()) return;
    schema.slot_sets = arena.allocate_array<std::int32_t>(schema.slots.size());
    for (std::size_t i = 0; i < schema.slots.size(); ++i) {
      const TypeSet& types = schema.slots[i];
      auto known = std::find(type_sets.begin(), type_sets.end(), types);
      if (known == type_sets.end()) {
        type_sets.push_back(types);
        known = type_sets.end() - 1;
        for (std::size_t type = 0; type < type_count; ++type) {
          allowed.push_back(domain.is_a(static_cast<TypeId>(type), types) ? 1 : 0);
        }
      }
      schema.slot_sets[i] = static_cast<std::int32_t>(known - type_sets.begin());
    }
  }
  producers.build(2 * is_fluent.size(), [&](const auto& visit) {
    for (std::size_t s = 0; s < schemas.size() && !stop.stop_requested(); ++s) {
      for (std::size_t e = 0; e < schemas[s].effects.size(); ++e) {
        const LiteralPattern& literal = schemas[s].effects[e].literal;
        visit(2 * static_cast<std::size_t>(literal.atom.predicate) + (literal.negative ? 1 : 0),
              EffectReference{static_cast<std::int32_t>(s), static_cast<std::int32_t>(e)});
      }
    }
  });
}

}  // namespace goalnet::planner
