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
#include <span>
#include <stop_token>
#include <utility>
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
  Array<LiteralPattern> fixed;   // on predicates that no action changes
  Array<LiteralPattern> fluent;  // on the others
  Array<EqualityPattern> equalities;
  Array<Formula> complex;  // everything else, in normal form
};

struct CompiledEffect {
  Array<std::int32_t> variables;  // slots quantified here
  Condition condition;
  LiteralPattern literal;
  // Another schema reaches this literal at no more cost and with fewer consequences, so this one need not be
  // grounded for its sake: to let go of a mug, "release" is enough, one need not try all places to put it.
  bool dominated = false;
};

struct CompiledSchema {
  std::int32_t action = 0;           // in Domain::actions
  std::int32_t parameter_count = 0;  // slots bound when an action is ground: parameters and leading 'exists'
  Array<TypeSet> slots;              // of all variables
  Array<std::int32_t> slot_sets;     // the same, as numbers of CompiledDomain::type_sets
  Array<std::pair<std::int32_t, ObjectId>> fixed;  // parameters that this case fixes
  Condition precondition;
  Array<CompiledEffect> effects;
  CostExpression cost;
};

struct EffectReference {
  std::int32_t schema;
  std::int32_t effect;
};

// Lists of effects by number, in one piece of memory.
class Producers {
 public:
  std::size_t size() const { return ends_.size(); }
  std::span<const EffectReference> operator[](std::size_t kind) const {
    const std::uint32_t begin = kind == 0 ? 0 : ends_[kind - 1];
    return {references_.data() + begin, ends_[kind] - begin};
  }
  // Sorts what each(visit) passes as visit(kind, reference), called twice; `kinds` is one more than the
  // highest.
  template <class Each>
  void build(std::size_t kinds, const Each& each) {
    ends_.assign(kinds + 1, 0);
    each([&](std::size_t kind, EffectReference) { ++ends_[kind + 1]; });
    for (std::size_t i = 1; i <= kinds; ++i) ends_[i] += ends_[i - 1];
    references_.resize(ends_[kinds]);
    each([&](std::size_t kind, EffectReference reference) { references_[ends_[kind]++] = reference; });
    ends_.pop_back();
  }

 private:
  std::vector<std::uint32_t> ends_;
  std::vector<EffectReference> references_;
};

// A definition of a derived predicate that depends on itself.
struct CompiledAxiom {
  PredicateId predicate = 0;
  std::int32_t parameter_count = 0;
  Array<TypeSet> slots;
  Formula body;  // in normal form
};

struct CompiledDomain {
  // Once `stop` asks, the result is not complete and must not be used.
  explicit CompiledDomain(const Domain& domain, const std::stop_token& stop = {});

  const Domain& domain;
  Arena arena;  // where the schemas lie
  // By predicate: some action changes it, or it is computed in every state.
  std::vector<std::uint8_t> is_fluent;
  Chunks<CompiledSchema> schemas;
  std::vector<CompiledAxiom> axioms;
  std::vector<TypeSet> type_sets;     // every different set of types that a variable has
  std::vector<std::uint8_t> allowed;  // by set * number of types + type: whether the type is in the set
  // By 2 * predicate + (negative ? 1 : 0): the effects that produce such literals.
  Producers producers;
};

}  // namespace goalnet::planner
