// A domain prepared for grounding: action schemas as lists of literals.
//
// Preparation moves work from every query to the construction of a Planner:
// - A parameter compared with constants, "(= ?z Sink)", splits the schema into one case per constant and one
//   for the rest, so that equality with constants disappears.
// - A toggle, with effects under a condition and under its opposite, becomes two schemas (on and off). LM-cut
//   is weak on the undivided form.
// - Disjunctions at the top of small preconditions become separate schemas; variables under a leading
//   'exists' become further parameters.
// - Effects are a flat list: variables, condition, literal.
// Several schemas may therefore carry the name of one action.
#pragma once

#include <cstdint>
#include <stop_token>
#include <vector>

#include "components/planner/domain.h"

namespace goalnet::planner {

struct LiteralPattern {
  AtomPattern atom;
  bool negative = false;
};

// left = right, or left ≠ right.
struct EqualityPattern {
  Term left, right;
  bool negative = false;
};

struct Condition {
  std::vector<LiteralPattern> fixed;   // on predicates that no action changes
  std::vector<LiteralPattern> fluent;  // on the others
  std::vector<EqualityPattern> equalities;
  std::vector<Formula> complex;  // everything else, in normal form
};

struct CompiledEffect {
  std::vector<std::int32_t> variables;  // slots quantified here
  Condition condition;
  LiteralPattern literal;
  // Another schema reaches this literal at no more cost and with fewer consequences, so this one need not be
  // grounded for its sake: to let go of a mug, "release" is enough, one need not try all places to put it.
  bool dominated = false;
};

struct CompiledSchema {
  std::int32_t action = 0;           // in Domain::actions
  std::int32_t parameter_count = 0;  // slots bound when an action is ground: parameters and leading 'exists'
  std::vector<TypeSet> slots;        // of all variables
  std::vector<std::int32_t> slot_sets;                   // the same, as numbers of CompiledDomain::type_sets
  std::vector<std::pair<std::int32_t, ObjectId>> fixed;  // parameters that this case fixes
  Condition precondition;
  std::vector<CompiledEffect> effects;
  CostExpression cost;
};

struct EffectReference {
  std::int32_t schema;
  std::int32_t effect;
};

// A definition of a derived predicate that depends on itself.
struct CompiledAxiom {
  PredicateId predicate = 0;
  std::int32_t parameter_count = 0;
  std::vector<TypeSet> slots;
  Formula body;  // in normal form
};

struct CompiledDomain {
  // Once `stop` asks, the result is not complete and must not be used.
  explicit CompiledDomain(const Domain& domain, const std::stop_token& stop = {});

  const Domain& domain;
  std::vector<std::uint8_t>
      is_fluent;  // by predicate: some action changes it, or it is computed in every state
  std::vector<CompiledSchema> schemas;
  std::vector<CompiledAxiom> axioms;
  std::vector<TypeSet> type_sets;     // every different set of types that a variable has
  std::vector<std::uint8_t> allowed;  // by set * number of types + type: whether the type is in the set
  // By 2 * predicate + (negative ? 1 : 0): the effects that produce such literals.
  std::vector<std::vector<EffectReference>> producers;
};

// Splits a normal-form formula at its top conjunction.
Condition split_condition(const std::vector<std::uint8_t>& is_fluent, Formula formula);

}  // namespace goalnet::planner
