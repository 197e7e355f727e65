// A domain as a whole, and its short sections.
#include <algorithm>

#include "components/planner/domain_parser.h"

namespace goalnet::planner {

Expected<Domain> DomainParser::parse() {
  if (!failed()) read();
  if (failed()) return tl::unexpected(error());
  domain_.arena = std::move(arena_);
  return std::move(domain_);
}

bool DomainParser::read() {
  domain_.types.add("object");
  domain_.ancestors = {{0}};
  if (!expect_header("domain", &domain_.name)) return false;
  while (!failed() && peek().kind == Token::Kind::kOpen) {
    next();
    if (!section()) return false;
  }
  return expect_close("the domain") && expect_end() && check_numeric_requirement() && check_derived();
}

bool DomainParser::section() {
  Token word;
  if (!expect_word("a section like :action", &word)) return false;
  if (is(word, ":requirements")) return requirements();
  if (is(word, ":types")) return types(word);
  if (is(word, ":constants")) return constants(word);
  if (is(word, ":predicates")) return predicates(word);
  if (is(word, ":functions")) return functions(word);
  if (is(word, ":action")) return action();
  if (is(word, ":derived")) return derived();
  if (is(word, ":durative-action")) {
    return fail_at(word.offset, "durative actions (:durative-actions) are not supported");
  }
  if (is(word, ":constraints"))
    return fail_at(word.offset, "trajectory constraints (:constraints) are not supported");
  return fail_at(word.offset,
                 "unknown section " + quoted(word) +
                     did_you_mean(word.text, {":requirements", ":types", ":constants", ":predicates",
                                              ":functions", ":derived", ":action"}));
}

bool DomainParser::requirements() {
  static const char* const kSupported[] = {":strips",
                                           ":typing",
                                           ":equality",
                                           ":negative-preconditions",
                                           ":disjunctive-preconditions",
                                           ":existential-preconditions",
                                           ":universal-preconditions",
                                           ":quantified-preconditions",
                                           ":conditional-effects",
                                           ":adl",
                                           ":action-costs",
                                           ":derived-predicates",
                                           ":domain-axioms"};
  while (!failed() && peek().kind != Token::Kind::kClose) {
    Token word;
    if (!expect_word("a requirement", &word)) return false;
    if (is(word, ":fluents") || is(word, ":numeric-fluents")) {
      numeric_requirement_ = word;  // judged when it is known what numbers there are
      continue;
    }
    if (std::none_of(std::begin(kSupported), std::end(kSupported),
                     [&](const char* r) { return is(word, r); })) {
      return unsupported(word);
    }
  }
  return expect_close(":requirements");
}

bool DomainParser::unsupported(const Token& requirement) {
  return fail_at(requirement.offset, "requirement " + quoted(requirement) +
                                         " is not supported (supported: PDDL 2.1's ADL part, :action-costs "
                                         "and :derived-predicates)");
}

// PDDL 2.1 has no :action-costs: there a domain with a total-cost asks for numbers.
bool DomainParser::check_numeric_requirement() {
  if (numeric_requirement_.kind != Token::Kind::kWord) return true;
  return domain_.functions.find("total-cost") != SymbolTable::kNone || unsupported(numeric_requirement_);
}

bool DomainParser::once(bool* seen, const Token& word) {
  if (*seen) return fail_at(word.offset, "a second section " + quoted(word));
  *seen = true;
  return true;
}

bool DomainParser::constants(const Token& section_word) {
  if (!once(&seen_constants_, section_word)) return false;
  TypedNames names;
  if (!typed_list(domain_, false, "a constant", &names) || !expect_close(":constants")) return false;
  for (const TypedName& entry : names) {
    if (stop_asked()) return false;
    if (domain_.constants.find(entry.name) != SymbolTable::kNone) {
      return fail_at(entry.offset, "constant '" + std::string(entry.name) + "' is declared twice");
    }
    if (entry.types.size() > 1) {
      return fail_at(entry.offset, "a constant has one type; declare a type below both");
    }
    domain_.constants.add(entry.name);
    domain_.constant_types.push_back(entry.types.front());
  }
  return true;
}

template <class Schema>
bool DomainParser::signature(const std::string& kind, SymbolTable& names, std::vector<Schema>& schemas) {
  const std::string what = "a " + kind, end = "the " + kind;
  Token name;
  TypedNames parameters;
  if (!expect_open(what.c_str()) || !expect_word(what.c_str(), &name) || !check_name(name, what.c_str()) ||
      !typed_list(domain_, true, "a variable", &parameters) || !expect_close(end.c_str())) {
    return false;
  }
  if (names.find(name.text) != SymbolTable::kNone) {
    return fail_at(name.offset, kind + " " + quoted(name) + " is declared twice");
  }
  if (parameters.size() > TermList::kMost) return fail_at(name.offset, what + " with more than 16 arguments");
  names.add(name.text);
  std::vector<TypeSet> types;
  for (const TypedName& p : parameters) types.push_back(p.types);
  schemas.push_back({arena_.copy(types)});
  return true;
}

bool DomainParser::predicates(const Token& section_word) {
  if (!once(&seen_predicates_, section_word)) return false;
  while (!failed() && peek().kind != Token::Kind::kClose) {
    if (!signature("predicate", domain_.predicates, domain_.predicate_schemas)) return false;
  }
  return expect_close(":predicates");
}

bool DomainParser::functions(const Token& section_word) {
  if (!once(&seen_functions_, section_word)) return false;
  while (!failed() && peek().kind != Token::Kind::kClose) {
    if (peek().kind == Token::Kind::kWord) {  // "- number"
      Token dash, number;
      if (!expect_word("'-'", &dash) || !expect_word("'number'", &number)) return false;
      if (dash.text != "-") return fail_at(dash.offset, "expected '(' or '- number', found " + quoted(dash));
      if (!is(number, "number")) {
        return fail_at(number.offset,
                       "functions to " + quoted(number) + " (:object-fluents) are not supported");
      }
      continue;
    }
    if (!signature("function", domain_.functions, domain_.function_schemas)) return false;
  }
  return expect_close(":functions");
}

Expected<Domain> parse_domain(std::string_view text, std::string_view filename, const std::stop_token& stop) {
  return DomainParser(text, filename, stop).parse();
}

Expected<Domain> load_domain(const std::string& path, const std::stop_token& stop) {
  const auto text = read_text_file(path, stop);
  if (!text) return tl::unexpected(text.error());
  return parse_domain(text->text, path, stop);
}

}  // namespace goalnet::planner
