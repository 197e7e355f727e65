// The parser of domains, one file for each kind of section. Internal to the planner.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "components/planner/parser.h"

namespace goalnet::planner {

class DomainParser : public Parser {
 public:
  using Parser::Parser;

  Expected<Domain> parse();

 private:
  static constexpr std::int64_t kHighestCost = 1'000'000'000;

  bool read();
  bool section();
  bool requirements();
  bool unsupported(const Token& requirement);
  bool check_numeric_requirement();
  bool once(bool* seen, const Token& word);
  // "a b - c (…)": parents may be declared later, or not at all (then they are below object).
  bool types(const Token& section_word);
  bool close_types(const std::vector<std::vector<TypeId>>& parents, const Token& where);
  bool constants(const Token& section_word);
  bool predicates(const Token& section_word);
  bool functions(const Token& section_word);
  // "(name ?x - type)" of a predicate or function, as `kind` says.
  template <class Schema>
  bool signature(const std::string& kind, SymbolTable& names, std::vector<Schema>& schemas);
  bool action();
  bool read_effect(Scope& scope, ActionSchema& schema, int depth, bool conditional, Effect* effect);
  bool increase(Scope& scope, ActionSchema& schema, const Token& word, bool conditional);
  bool derived();
  bool check_derived();
  bool integer(const Token& number, std::int64_t* value);

  Domain domain_;
  bool seen_types_ = false, seen_constants_ = false, seen_predicates_ = false, seen_functions_ = false;
  Chunks<std::pair<PredicateId, Token>> changed_;  // where effects change which predicate
  std::vector<AtomPattern> cost_functions_;        // of the action at hand
  std::vector<Token> derived_names_;
  Token numeric_requirement_;
};

}  // namespace goalnet::planner
