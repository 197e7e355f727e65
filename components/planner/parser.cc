#include "components/planner/parser.h"

#include <array>

namespace goalnet::planner {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

}  // namespace

Parser::Parser(std::string_view text, std::string_view filename, const std::stop_token& stop)
    : lexer_(text.size() <= kLargestText ? text : std::string_view{}, stop),
      filename_(filename),
      stop_(stop),
      stoppable_(stop.stop_possible()) {
  if (text.size() > kLargestText) {
    fail_at(0, "the text has " + std::to_string(text.size() >> 20) + " MB; at most " +
                   std::to_string(kLargestText >> 20) + " MB are read");
  }
}

bool Parser::stop_asked() {
  if (!error_ && stop_.stop_requested())
    error_ = Error{Outcome::kCancelled, filename_ + ": reading was cancelled"};
  return error_ && error_->outcome == Outcome::kCancelled;
}

bool Parser::fail_at(std::size_t offset, const std::string& message) {
  if (!error_) {
    error_ = Error{Outcome::kInvalidRequest, filename_ + ":" + lexer_.position(offset) + ": " + message};
  }
  return false;
}

std::string Parser::quoted(const Token& token) const {
  switch (token.kind) {
    case Token::Kind::kEnd:
      return "the end of the text (is a ')' missing?)";
    case Token::Kind::kOpen:
      return "'('";
    case Token::Kind::kClose:
      return "')'";
    case Token::Kind::kBad: {
      const auto c = static_cast<unsigned char>(token.text.front());
      if (c > 0x20 && c < 0x7f) return std::string("the character '") + static_cast<char>(c) + "'";
      return "the byte " + std::to_string(c) + ", which PDDL does not have";
    }
    case Token::Kind::kWord:
      break;
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

bool Parser::check_name(const Token& word, const char* what, bool digits) {
  if (failed()) return false;
  const char first = word.text.front();
  if (is_letter(first) || (digits && first >= '0' && first <= '9')) return true;
  return fail_at(word.offset, std::string(what) + " " + quoted(word) + " does not start with a letter");
}

bool Parser::expect_header(std::string_view kind, std::string* name) {
  Token word;
  if (!expect_open("the definition") || !expect_word("'define'", &word)) return false;
  if (!is(word, "define")) return fail_at(word.offset, "expected 'define', found " + quoted(word));
  if (!expect_open("the name of the definition") || !expect_word("'domain' or 'problem'", &word))
    return false;
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
  return fail_at(word.offset,
                 "unknown type " + quoted(word) + did_you_mean(word.text, domain.types.first_names()));
}

bool Parser::typed_list(const Domain& domain, bool variables, const char* what, TypedNames* result) {
  std::size_t untyped = 0;  // first of those still waiting for "- type"
  while (!failed() && peek().kind != Token::Kind::kClose) {
    Token word;
    if (!expect_word(what, &word)) return false;
    if (word.text != "-") {
      if (variables) {
        if (word.text.size() < 2 || word.text.front() != '?') {
          return fail_at(word.offset, "expected a variable like ?x, found " + quoted(word));
        }
      } else if (!check_name(word, what, true)) {  // objects are often numbered
        return false;
      }
      result->push_back({word.text, word.offset, {}});
      continue;
    }
    if (untyped == result->size()) return fail_at(word.offset, "'-' follows no name");
    std::vector<TypeId> types;
    if (peek().kind == Token::Kind::kOpen) {
      next();
      if (!expect_word("'either'", &word)) return false;
      if (!is(word, "either"))
        return fail_at(word.offset, "expected (either TYPE ...), found " + quoted(word));
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
    const TypeSet shared = arena_.copy(types);
    for (; untyped < result->size() && !stop_asked(); ++untyped) (*result)[untyped].types = shared;
  }
  if (untyped == result->size()) return !failed();
  const TypeSet anything = arena_.copy(std::array<TypeId, 1>{0});
  for (; untyped < result->size() && !stop_asked(); ++untyped) (*result)[untyped].types = anything;
  return !failed();
}

bool Parser::find_predicate(const Domain& domain, const Token& name, PredicateId* predicate) {
  *predicate = domain.predicates.find(name.text);
  if (*predicate != SymbolTable::kNone) return true;
  return fail_at(name.offset, "unknown predicate " + quoted(name) +
                                  did_you_mean(name.text, domain.predicates.first_names()));
}

}  // namespace goalnet::planner
