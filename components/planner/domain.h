// A PDDL domain after parsing: types, constants, predicates, action schemas. Immutable afterwards; may be
// read from several threads at once.
#pragma once

#include <cstdint>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "components/core/outcome.h"
#include "components/planner/arena.h"
#include "components/planner/chunks.h"
#include "components/planner/formula.h"
#include "components/planner/symbols.h"

namespace goalnet::planner {

struct PredicateSchema {
  Array<TypeSet> parameters;
};

// A numeric function; only those that give action costs are supported.
struct FunctionSchema {
  Array<TypeSet> parameters;
};

// (increase (total-cost) (distance ?a ?b)): a constant plus the values of functions.
struct CostExpression {
  std::int64_t constant = 0;
  Array<AtomPattern> functions;  // `predicate` holds the function's number
};

struct ActionSchema {
  std::string_view name;
  std::int32_t parameter_count = 0;
  Array<TypeSet> slots;  // types of the parameters, then of all quantified variables
  Formula precondition;
  Effect effect;
  CostExpression cost;  // meaningful where the problem minimises total-cost
};

// (:derived (above ?x ?y) FORMULA). A predicate may have several; any of them makes it true.
struct DerivedPredicate {
  PredicateId predicate = 0;
  std::int32_t parameter_count = 0;
  Array<TypeSet> slots;
  Formula body;
};

struct Domain {
  std::string name;
  Arena arena;                                 // where what follows lies
  SymbolTable types;                           // 0 is "object"
  std::vector<std::vector<TypeId>> ancestors;  // by type: itself and all above, sorted
  SymbolTable constants;
  std::vector<TypeId> constant_types;
  SymbolTable predicates;
  std::vector<PredicateSchema> predicate_schemas;
  SymbolTable functions;
  std::vector<FunctionSchema> function_schemas;
  SymbolTable action_names;
  Chunks<ActionSchema> actions;
  std::vector<DerivedPredicate> derived;
  // By predicate: the layer of a derived predicate that is computed in every state, or one of these; see
  // derived_layers.h.
  static constexpr std::int32_t kGiven = -1;  // not derived
  static constexpr std::int32_t kWrittenOut =
      -2;  // derived, and replaced by its definition wherever it is used
  std::vector<std::int32_t> layer;

  bool is_derived(PredicateId predicate) const {
    return layer[static_cast<std::size_t>(predicate)] != kGiven;
  }
  // Derived and computed.
  bool recursive(PredicateId predicate) const { return layer[static_cast<std::size_t>(predicate)] >= 0; }
  bool has_recursion() const;

  bool is_a(TypeId type, TypeId ancestor) const;
  bool is_a(TypeId type, const TypeSet& any_of) const;
};

// Parses a PDDL 2.1 domain (the ADL part, derived predicates and action costs). `filename` is for messages
// only: every error is kInvalidRequest and starts with "filename:line:column: ", but for kCancelled, soon
// after `stop` asks.
Expected<Domain> parse_domain(std::string_view text, std::string_view filename,
                              const std::stop_token& stop = {});

// Reads and parses a file.
Expected<Domain> load_domain(const std::string& path, const std::stop_token& stop = {});

}  // namespace goalnet::planner
