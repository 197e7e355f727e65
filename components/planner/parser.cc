#include "components/planner/parser.h"

#include <fstream>
#include <sstream>

namespace goalnet::planner {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

// True if a thing of one of `types` can be something of `wanted`: one is above the other.
bool compatible(const Domain& domain, const TypeSet& types, const TypeSet& wanted) {
  for (const TypeId type : types) {
    if (domain.is_a(type, wanted)) return true;
    for (const TypeId other : wanted) {
      if (domain.is_a(other, type)) return true;
    }
  }
  return false;
}

std::string names_of(const Domain& domain, const TypeSet& types) {
  std::string text;
  for (const TypeId type : types) text += (text.empty() ? "" : " or ") + domain.types.name(type);
  return text;
}

}  // namespace

Parser::Parser(std::string_view text, std::string_view filename)
    : lexer_(text.size() <= kLargest ? text : std::string_view{}), filename_(filename) {
  if (text.size() > kLargest) {
    fail_at(0, "the text has " + std::to_string(text.size() >> 20) + " MB; at most " +
                   std::to_string(kLargest >> 20) + " MB are read");
  }
}

bool Parser::fail_at(std::size_t offset, const std::string& message) {
  if (!error_) {
    error_ = Error{Outcome::kInvalidRequest, filename_ + ":" + lexer_.position(offset) + ": " + message};
  }
  return false;
}

std::string Parser::quoted(const Token& token) const {
  switch (token.kind) {
    case Token::Kind::kEnd: return "the end of the text (is a ')' missing?)";
    case Token::Kind::kOpen: return "'('";
    case Token::Kind::kClose: return "')'";
    case Token::Kind::kBad: {
      const auto c = static_cast<unsigned char>(token.text.front());
      if (c > 0x20 && c < 0x7f) return std::string("the character '") + static_cast<char>(c) + "'";
      return "the byte " + std::to_string(c) + ", which PDDL does not have";
    }
    case Token::Kind::kWord: break;
  }
  constexpr std::size_t kShown = 60;
  return "'" + std::string(token.text.substr(0, kShown)) + (token.text.size() > kShown ? "...'" : "'");
}

bool Parser::expect_open(const char* what) {
  if (failed()) return false;
  const Token token = next();
  if (token.kind == Token::Kind::kOpen) return true;
  return fail_at(token.offset, std::string("expected '(' to begin ") + what + ", found " + quoted(token));
}

bool Parser::expect_close(const char* what) {
  if (failed()) return false;
  const Token token = next();
  if (token.kind == Token::Kind::kClose) return true;
  return fail_at(token.offset, std::string("expected ')' to end ") + what + ", found " + quoted(token));
}

bool Parser::expect_word(const char* what, Token* word) {
  if (failed()) return false;
  *word = next();
  if (word->kind == Token::Kind::kWord) return true;
  return fail_at(word->offset, std::string("expected ") + what + ", found " + quoted(*word));
}

bool Parser::check_name(const Token& word, const char* what) {
  if (failed()) return false;
  if (is_letter(word.text.front())) return true;
  return fail_at(word.offset, std::string(what) + " " + quoted(word) + " does not start with a letter");
}

bool Parser::expect_header(std::string_view kind, std::string* name) {
  Token word;
  if (!expect_open("the definition") || !expect_word("'define'", &word)) return false;
  if (!is(word, "define")) return fail_at(word.offset, "expected 'define', found " + quoted(word));
  if (!expect_open("the name of the definition") || !expect_word("'domain' or 'problem'", &word)) return false;
  if (!is(word, kind)) {
    const bool other = is(word, "domain") || is(word, "problem");
    return fail_at(word.offset, "expected a " + std::string(kind) + ", found " +
                                    (other ? "a " + std::string(word.text) + "; are the two files swapped?"
                                           : quoted(word)));
  }
  if (!expect_word("a name", &word)) return false;
  *name = std::string(word.text);
  return expect_close("the name of the definition");
}

bool Parser::expect_end() {
  if (failed()) return false;
  if (peek().kind == Token::Kind::kEnd) return true;
  return fail_at(peek().offset, "nothing may follow the definition, found " + quoted(peek()) +
                                    " (is there a ')' too many before?)");
}

bool Parser::skip_rest() {
  for (int depth = 1; depth > 0;) {
    const Token token = next();
    if (token.kind == Token::Kind::kOpen) ++depth;
    if (token.kind == Token::Kind::kClose) --depth;
    if (token.kind == Token::Kind::kEnd || token.kind == Token::Kind::kBad) {
      return fail_at(token.offset, "expected ')', found " + quoted(token));
    }
  }
  return true;
}

bool Parser::too_deep(int depth) {
  if (depth <= kDeepest) return false;
  fail_at(peek().offset, "more than " + std::to_string(kDeepest) + " nested parentheses");
  return true;
}

bool Parser::type_name(const Domain& domain, TypeId* type) {
  Token word;
  if (!expect_word("a type", &word)) return false;
  *type = domain.types.find(word.text);
  if (*type != SymbolTable::kNone) return true;
  return fail_at(word.offset, "unknown type " + quoted(word) + did_you_mean(word.text, domain.types.names()));
}

bool Parser::typed_list(const Domain& domain, bool variables, const char* what, std::vector<TypedName>* result) {
  std::size_t untyped = 0;  // first of those still waiting for "- type"
  while (!failed() && peek().kind != Token::Kind::kClose) {
    Token word;
    if (!expect_word(what, &word)) return false;
    if (word.text != "-") {
      if (variables) {
        if (word.text.size() < 2 || word.text.front() != '?') {
          return fail_at(word.offset, "expected a variable like ?x, found " + quoted(word));
        }
      } else if (!check_name(word, what)) {
        return false;
      }
      result->push_back({word.text, word.offset, {}});
      continue;
    }
    if (untyped == result->size()) return fail_at(word.offset, "'-' follows no name");
    TypeSet types;
    if (peek().kind == Token::Kind::kOpen) {
      next();
      if (!expect_word("'either'", &word)) return false;
      if (!is(word, "either")) return fail_at(word.offset, "expected (either TYPE ...), found " + quoted(word));
      while (!failed() && peek().kind != Token::Kind::kClose) {
        TypeId type = 0;
        if (!type_name(domain, &type)) return false;
        types.push_back(type);
      }
      if (types.empty()) return fail_at(word.offset, "(either) names no type");
      if (!expect_close("(either ...)")) return false;
    } else {
      TypeId type = 0;
      if (!type_name(domain, &type)) return false;
      types.push_back(type);
    }
    for (; untyped < result->size(); ++untyped) (*result)[untyped].types = types;
  }
  for (; untyped < result->size(); ++untyped) (*result)[untyped].types = {0};
  return !failed();
}

bool Parser::find_predicate(const Domain& domain, const Token& name, PredicateId* predicate) {
  *predicate = domain.predicates.find(name.text);
  if (*predicate != SymbolTable::kNone) return true;
  return fail_at(name.offset,
                 "unknown predicate " + quoted(name) + did_you_mean(name.text, domain.predicates.names()));
}

bool Parser::term(const Domain& domain, const Problem* problem, const Scope& scope, Term* result,
                  std::size_t* offset) {
  Token word;
  if (!expect_word("an object or a variable", &word)) return false;
  *offset = word.offset;
  if (word.text.front() == '?') {
    for (std::size_t i = scope.visible.size(); i-- > 0;) {
      if (equal_ignoring_case(scope.visible[i].first, word.text)) {
        *result = Term::variable(scope.visible[i].second);
        return true;
      }
    }
    std::vector<std::string> names;
    for (const auto& entry : scope.visible) names.emplace_back(entry.first);
    return fail_at(word.offset, "variable " + quoted(word) + " is not bound here" + did_you_mean(word.text, names));
  }
  const ObjectId id = problem != nullptr ? problem->find_object(word.text) : domain.constants.find(word.text);
  if (id == SymbolTable::kNone) {
    return fail_at(word.offset, "unknown " + std::string(problem != nullptr ? "object " : "constant ") + quoted(word) +
                                    did_you_mean(word.text, problem != nullptr ? problem->object_names()
                                                                               : domain.constants.names()));
  }
  *result = Term::object(id);
  return true;
}

bool Parser::atom_arguments(const Domain& domain, const Problem* problem, const Scope& scope, const Token& name,
                            const std::vector<TypeSet>& schema, TermList* arguments) {
  bool too_many = false;
  while (!failed() && peek().kind != Token::Kind::kClose) {
    Term argument;
    std::size_t offset = 0;
    if (!term(domain, problem, scope, &argument, &offset)) return false;
    const std::size_t index = arguments->size();
    if (index == schema.size()) {
      too_many = true;
      break;
    }
    {
      TypeSet object_type;
      const TypeSet* types = nullptr;
      if (argument.is_variable()) {
        types = &(*scope.slots)[static_cast<std::size_t>(argument.slot())];
      } else {
        object_type = {problem != nullptr ? problem->object_type(argument.value)
                                          : domain.constant_types[static_cast<std::size_t>(argument.value)]};
        types = &object_type;
      }
      const bool fits = argument.is_variable() ? compatible(domain, *types, schema[index])
                                               : domain.is_a(types->front(), schema[index]);
      if (!fits) {
        return fail_at(offset, "argument " + std::to_string(index + 1) + " of " + quoted(name) + " must be a " +
                                   names_of(domain, schema[index]) + ", not a " + names_of(domain, *types));
      }
    }
    arguments->push_back(argument);
  }
  if (failed()) return false;
  if (too_many || arguments->size() != schema.size()) {
    return fail_at(name.offset, quoted(name) + " takes " + std::to_string(schema.size()) + " arguments, not " +
                                    (too_many ? "more" : std::to_string(arguments->size())));
  }
  return expect_close("the arguments");
}

bool Parser::quantified(const Domain& domain, Scope& scope, std::vector<std::int32_t>* slots) {
  std::vector<TypedName> variables;
  if (!expect_open("the list of variables") || !typed_list(domain, true, "a variable", &variables) ||
      !expect_close("the list of variables")) {
    return false;
  }
  for (TypedName& variable : variables) {
    for (std::size_t i = scope.visible.size() - slots->size(); i < scope.visible.size(); ++i) {
      if (equal_ignoring_case(scope.visible[i].first, variable.name)) {
        return fail_at(variable.offset, "variable '" + std::string(variable.name) + "' is listed twice");
      }
    }
    const auto slot = static_cast<std::int32_t>(scope.slots->size());
    if (slot >= 64) return fail_at(variable.offset, "more than 64 variables in one action");
    scope.slots->push_back(std::move(variable.types));
    if (scope.slot_names != nullptr) scope.slot_names->emplace_back(variable.name);
    scope.visible.emplace_back(variable.name, slot);
    slots->push_back(slot);
  }
  return true;
}

bool Parser::formula(const Domain& domain, const Problem* problem, Scope& scope, int depth, Formula* result) {
  if (failed() || too_deep(depth) || !expect_open("a condition")) return false;
  if (peek().kind == Token::Kind::kClose) {  // "()" is true
    next();
    result->kind = Formula::Kind::kTrue;
    return true;
  }
  Token word;
  if (!expect_word("a predicate, 'and', 'or', 'not', 'imply', 'forall' or 'exists'", &word)) return false;
  const bool conjunction = is(word, "and");
  if (conjunction || is(word, "or")) {
    result->kind = conjunction ? Formula::Kind::kAnd : Formula::Kind::kOr;
    while (!failed() && peek().kind != Token::Kind::kClose) {
      result->children.emplace_back();
      if (!formula(domain, problem, scope, depth + 1, &result->children.back())) return false;
    }
    if (result->children.empty()) result->kind = conjunction ? Formula::Kind::kTrue : Formula::Kind::kFalse;
    return expect_close(conjunction ? "'and'" : "'or'");
  }
  if (is(word, "not")) {
    result->kind = Formula::Kind::kNot;
    result->children.resize(1);
    return formula(domain, problem, scope, depth + 1, &result->children[0]) && expect_close("'not'");
  }
  if (is(word, "imply")) {  // (imply a b) is (or (not a) b)
    result->kind = Formula::Kind::kOr;
    result->children.resize(2);
    result->children[0].kind = Formula::Kind::kNot;
    result->children[0].children.resize(1);
    return formula(domain, problem, scope, depth + 1, &result->children[0].children[0]) &&
           formula(domain, problem, scope, depth + 1, &result->children[1]) && expect_close("'imply'");
  }
  if (is(word, "forall") || is(word, "exists")) {
    result->kind = is(word, "forall") ? Formula::Kind::kForall : Formula::Kind::kExists;
    const std::size_t outer = scope.visible.size();
    if (!quantified(domain, scope, &result->slots)) return false;
    result->children.resize(1);
    const bool good = formula(domain, problem, scope, depth + 1, &result->children[0]);
    scope.visible.resize(outer);
    return good && expect_close("the quantified condition");
  }
  if (is(word, "preference")) return fail_at(word.offset, "preferences (:preferences) are not supported");
  if (word.text == "<" || word.text == ">" || word.text == "<=" || word.text == ">=") {
    return fail_at(word.offset, "comparisons of numbers (:numeric-fluents) are not supported");
  }
  if (word.text == "=") {
    if (peek().kind == Token::Kind::kOpen) {
      return fail_at(peek().offset, "comparisons of numbers (:numeric-fluents) are not supported");
    }
    result->kind = Formula::Kind::kEqual;
    return atom_arguments(domain, problem, scope, word, {{0}, {0}}, &result->atom.arguments);
  }
  result->kind = Formula::Kind::kAtom;
  if (!find_predicate(domain, word, &result->atom.predicate)) return false;
  return atom_arguments(domain, problem, scope, word,
                        domain.predicate_schemas[static_cast<std::size_t>(result->atom.predicate)].parameters,
                        &result->atom.arguments);
}

Expected<std::string> read_text_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return fail(Outcome::kInvalidRequest, path + ": cannot be opened; does it exist and may it be read?");
  std::ostringstream text;
  text << file.rdbuf();
  if (file.bad() || text.fail()) return fail(Outcome::kInvalidRequest, path + ": cannot be read");
  return std::move(text).str();
}

}  // namespace goalnet::planner
