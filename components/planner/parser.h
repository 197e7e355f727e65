// What the parsers of domains and problems share: expecting tokens, names, typed lists and formulas. The
// first error sticks; every function then returns false (or something empty) at once, so that callers need
// one check each. Internal to the planner.
#pragma once

#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "components/core/outcome.h"
#include "components/planner/domain.h"
#include "components/planner/lexer.h"
#include "components/planner/problem.h"
#include "components/planner/text_file.h"

namespace goalnet::planner {

// A name of a typed list, and its type.
struct TypedName {
  std::string_view name;
  std::size_t offset = 0;
  TypeSet types;
};
using TypedNames = Chunks<TypedName>;

// The variables visible at one place of a formula, and where their types are collected.
struct Scope {
  std::vector<TypeSet>* slots = nullptr;
  std::vector<std::pair<std::string_view, std::int32_t>> visible;  // innermost last
};

class Parser {
 public:
  static constexpr int kDeepest = 400;  // nesting of parentheses

  // Everything fails with kCancelled soon after `stop` asks.
  Parser(std::string_view text, std::string_view filename, const std::stop_token& stop);

 protected:
  bool failed() const { return error_.has_value(); }
  Error error() const { return *error_; }
  // Records the first error; returns false.
  bool fail_at(std::size_t offset, const std::string& message);
  // For loops that read no tokens. True once it is time to stop; the parser has failed then.
  bool stop_asked();

  const Token& peek() const { return lexer_.peek(); }
  Token next() {
    const Token token = lexer_.next();
    return stoppable_ && stop_asked() ? Token{Token::Kind::kEnd, {}, token.offset} : token;
  }
  bool expect_open(const char* what);
  bool expect_close(const char* what);
  bool expect_word(const char* what, Token* word);
  // "(define (KIND NAME)"; sets name.
  bool expect_header(std::string_view kind, std::string* name);
  bool expect_end();
  // A name of ours: letters, digits, '-', '_'..., starting with a letter, or with a digit where `digits`.
  bool check_name(const Token& word, const char* what, bool digits = false);
  // Skips to the closing parenthesis of what was opened.
  bool skip_rest();

  // "a b - t c - (either t u)". `allow_types`: unknown types are added with parent object instead of refused.
  bool typed_list(const Domain& domain, bool variables, const char* what, TypedNames* result);
  bool type_name(const Domain& domain, TypeId* type);

  // A formula in NNF order as written: not, and, or, imply, forall, exists, =, atoms.
  bool formula(const Domain& domain, const Problem* problem, Scope& scope, int depth, Formula* result);
  // After "(" NAME has been read: the arguments up to ")". The schema is checked.
  bool atom_arguments(const Domain& domain, const Problem* problem, const Scope& scope, const Token& name,
                      std::span<const TypeSet> schema, TermList* arguments);
  bool term(const Domain& domain, const Problem* problem, const Scope& scope, Term* result,
            std::size_t* offset);
  // Reads "(?x ?y - t)" and makes the variables visible.
  bool quantified(const Domain& domain, Scope& scope, Array<std::int32_t>* slots);
  bool find_predicate(const Domain& domain, const Token& name, PredicateId* predicate);
  bool too_deep(int depth);
  static bool is(const Token& token, std::string_view word) {
    return token.kind == Token::Kind::kWord && equal_ignoring_case(token.text, word);
  }
  std::string quoted(const Token& token) const;

  Lexer lexer_;
  Arena arena_;  // where trees are built; the result takes it along
  std::string filename_;
  std::stop_token stop_;
  bool stoppable_;
  std::optional<Error> error_;
};

}  // namespace goalnet::planner
