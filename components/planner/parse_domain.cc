#include <algorithm>
#include <charconv>

#include "components/planner/derived_layers.h"
#include "components/planner/parser.h"
#include "components/planner/type_hierarchy.h"

namespace goalnet::planner {
namespace {

constexpr std::size_t kMostTypes = 4096;

class DomainParser : public Parser {
 public:
  using Parser::Parser;

  Expected<Domain> parse() {
    if (!failed()) read();
    if (failed()) return tl::unexpected(error());
    return std::move(domain_);
  }

 private:
  bool read() {
    domain_.types.add("object");
    domain_.ancestors = {{0}};
    if (!expect_header("domain", &domain_.name)) return false;
    while (!failed() && peek().kind == Token::Kind::kOpen) {
      next();
      if (!section()) return false;
    }
    return expect_close("the domain") && expect_end() && check_derived();
  }

  bool section() {
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
    if (is(word, ":constraints")) return fail_at(word.offset, "trajectory constraints (:constraints) are not supported");
    return fail_at(word.offset, "unknown section " + quoted(word) +
                                    did_you_mean(word.text, {":requirements", ":types", ":constants", ":predicates",
                                                             ":functions", ":derived", ":action"}));
  }

  bool requirements() {
    static const char* const kSupported[] = {
        ":strips", ":typing", ":equality", ":negative-preconditions", ":disjunctive-preconditions",
        ":existential-preconditions", ":universal-preconditions", ":quantified-preconditions",
        ":conditional-effects", ":adl", ":action-costs", ":derived-predicates", ":domain-axioms"};
    while (!failed() && peek().kind != Token::Kind::kClose) {
      Token word;
      if (!expect_word("a requirement", &word)) return false;
      if (std::none_of(std::begin(kSupported), std::end(kSupported), [&](const char* r) { return is(word, r); })) {
        return fail_at(word.offset, "requirement " + quoted(word) +
                                        " is not supported (supported: PDDL 2.1's ADL part, :action-costs and "
                                        ":derived-predicates)");
      }
    }
    return expect_close(":requirements");
  }

  bool once(bool* seen, const Token& word) {
    if (*seen) return fail_at(word.offset, "a second section " + quoted(word));
    *seen = true;
    return true;
  }

  // "a b - c (…)": parents may be declared later, or not at all (then they are below object).
  bool types(const Token& section_word) {
    if (!once(&seen_types_, section_word)) return false;
    struct Declared {
      Token name;
      std::vector<Token> parents;
    };
    std::vector<Declared> declared;
    std::size_t untyped = 0;
    while (!failed() && peek().kind != Token::Kind::kClose) {
      Token word;
      if (!expect_word("a type", &word)) return false;
      if (word.text != "-") {
        if (!check_name(word, "a type")) return false;
        declared.push_back({word, {}});
        continue;
      }
      if (untyped == declared.size()) return fail_at(word.offset, "'-' follows no type");
      std::vector<Token> parents;
      if (peek().kind == Token::Kind::kOpen) {
        next();
        if (!expect_word("'either'", &word)) return false;
        if (!is(word, "either")) return fail_at(word.offset, "expected (either TYPE ...), found " + quoted(word));
        while (!failed() && peek().kind == Token::Kind::kWord) parents.push_back(next());
        if (!expect_close("(either ...)")) return false;
        if (parents.empty()) return fail_at(word.offset, "(either) names no type");
      } else {
        if (!expect_word("a type", &word)) return false;
        parents.push_back(word);
      }
      for (; untyped < declared.size(); ++untyped) declared[untyped].parents = parents;
    }
    if (!expect_close(":types")) return false;
    std::vector<std::uint8_t> defined = {0};
    std::vector<std::vector<TypeId>> parents(1);
    for (const Declared& entry : declared) {
      const TypeId id = domain_.types.add(entry.name.text);
      parents.resize(static_cast<std::size_t>(domain_.types.size()));
      defined.resize(parents.size());
      const bool again = id != 0 && defined[static_cast<std::size_t>(id)] != 0;
      bool adds = false;
      defined[static_cast<std::size_t>(id)] = 1;
      for (const Token& parent : entry.parents) {
        const TypeId above = domain_.types.add(parent.text);
        parents.resize(static_cast<std::size_t>(domain_.types.size()));
        defined.resize(parents.size());
        if (id == 0 && above == 0) continue;  // "object - object" is harmless
        auto& mine = parents[static_cast<std::size_t>(id)];
        if (std::find(mine.begin(), mine.end(), above) != mine.end()) continue;
        mine.push_back(above);
        adds = true;
      }
      // A type below two others is sometimes written as two declarations; one that says nothing new is a slip.
      if (again && !adds) return fail_at(entry.name.offset, "type " + quoted(entry.name) + " is declared twice");
      if (parents.size() > kMostTypes) {
        return fail_at(entry.name.offset, "more than " + std::to_string(kMostTypes) + " types");
      }
    }
    return close_types(parents, declared.empty() ? section_word : declared.front().name);
  }

  bool close_types(const std::vector<std::vector<TypeId>>& parents, const Token& where) {
    const auto circular = find_ancestors(parents, &domain_.ancestors);
    if (!circular) return true;
    return fail_at(where.offset, "type '" + domain_.types.name(*circular) + "' is above itself: the types form a cycle");
  }

  bool constants(const Token& section_word) {
    if (!once(&seen_constants_, section_word)) return false;
    std::vector<TypedName> names;
    if (!typed_list(domain_, false, "a constant", &names) || !expect_close(":constants")) return false;
    for (const TypedName& entry : names) {
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

  bool predicates(const Token& section_word) {
    if (!once(&seen_predicates_, section_word)) return false;
    while (!failed() && peek().kind != Token::Kind::kClose) {
      Token name;
      std::vector<TypedName> parameters;
      if (!expect_open("a predicate") || !expect_word("a predicate", &name) || !check_name(name, "a predicate") ||
          !typed_list(domain_, true, "a variable", &parameters) || !expect_close("the predicate")) {
        return false;
      }
      if (domain_.predicates.find(name.text) != SymbolTable::kNone) {
        return fail_at(name.offset, "predicate " + quoted(name) + " is declared twice");
      }
      if (parameters.size() > TermList::kMost) return fail_at(name.offset, "a predicate with more than 16 arguments");
      domain_.predicates.add(name.text);
      domain_.predicate_schemas.emplace_back();
      for (TypedName& p : parameters) domain_.predicate_schemas.back().parameters.push_back(std::move(p.types));
    }
    return expect_close(":predicates");
  }

  bool functions(const Token& section_word) {
    if (!once(&seen_functions_, section_word)) return false;
    while (!failed() && peek().kind != Token::Kind::kClose) {
      if (peek().kind == Token::Kind::kWord) {  // "- number"
        Token dash, number;
        if (!expect_word("'-'", &dash) || !expect_word("'number'", &number)) return false;
        if (dash.text != "-") return fail_at(dash.offset, "expected '(' or '- number', found " + quoted(dash));
        if (!is(number, "number")) {
          return fail_at(number.offset, "functions to " + quoted(number) + " (:object-fluents) are not supported");
        }
        continue;
      }
      Token name;
      std::vector<TypedName> parameters;
      if (!expect_open("a function") || !expect_word("a function", &name) || !check_name(name, "a function") ||
          !typed_list(domain_, true, "a variable", &parameters) || !expect_close("the function")) {
        return false;
      }
      if (domain_.functions.find(name.text) != SymbolTable::kNone) {
        return fail_at(name.offset, "function " + quoted(name) + " is declared twice");
      }
      if (parameters.size() > TermList::kMost) return fail_at(name.offset, "a function with more than 16 arguments");
      domain_.functions.add(name.text);
      domain_.function_schemas.emplace_back();
      for (TypedName& p : parameters) domain_.function_schemas.back().parameters.push_back(std::move(p.types));
    }
    return expect_close(":functions");
  }

  bool action() {
    Token name;
    if (!expect_word("the action's name", &name) || !check_name(name, "an action")) return false;
    if (domain_.action_names.find(name.text) != SymbolTable::kNone) {
      return fail_at(name.offset, "action " + quoted(name) + " is declared twice");
    }
    ActionSchema schema;
    schema.name = std::string(name.text);
    Scope scope{&schema.slots, &schema.slot_names, {}};
    bool parameters = false, precondition = false, effect = false;
    while (!failed() && peek().kind == Token::Kind::kWord) {
      const Token word = next();
      if (is(word, ":parameters")) {
        if (precondition || effect) return fail_at(word.offset, ":parameters must come first");
        std::vector<std::int32_t> slots;
        if (!once(&parameters, word) || !quantified(domain_, scope, &slots)) return false;
        schema.parameter_count = static_cast<std::int32_t>(slots.size());
      } else if (is(word, ":precondition")) {
        if (!once(&precondition, word) || !formula(domain_, nullptr, scope, 0, &schema.precondition)) return false;
      } else if (is(word, ":effect")) {
        if (!once(&effect, word) || !read_effect(scope, schema, 0, false, &schema.effect)) return false;
      } else {
        return fail_at(word.offset, "expected :parameters, :precondition or :effect, found " + quoted(word));
      }
    }
    if (!expect_close(("action " + schema.name).c_str())) return false;
    domain_.action_names.add(schema.name);
    domain_.actions.push_back(std::move(schema));
    return true;
  }

  bool read_effect(Scope& scope, ActionSchema& schema, int depth, bool conditional, Effect* effect) {
    if (failed() || too_deep(depth) || !expect_open("an effect")) return false;
    if (peek().kind == Token::Kind::kClose) {
      next();
      return true;
    }
    Token word;
    if (!expect_word("an effect", &word)) return false;
    if (is(word, "and")) {
      while (!failed() && peek().kind != Token::Kind::kClose) {
        effect->children.emplace_back();
        if (!read_effect(scope, schema, depth + 1, conditional, &effect->children.back())) return false;
      }
      return expect_close("'and'");
    }
    if (is(word, "forall")) {
      effect->kind = Effect::Kind::kForall;
      const std::size_t outer = scope.visible.size();
      if (!quantified(domain_, scope, &effect->slots)) return false;
      effect->children.resize(1);
      const bool good = read_effect(scope, schema, depth + 1, true, &effect->children[0]);
      scope.visible.resize(outer);
      return good && expect_close("'forall'");
    }
    if (is(word, "when")) {
      effect->kind = Effect::Kind::kWhen;
      effect->children.resize(1);
      return formula(domain_, nullptr, scope, depth + 1, &effect->condition) &&
             read_effect(scope, schema, depth + 1, true, &effect->children[0]) && expect_close("'when'");
    }
    if (is(word, "increase")) return increase(scope, schema, word, conditional);
    for (const char* other : {"assign", "decrease", "scale-up", "scale-down"}) {
      if (is(word, other)) {
        return fail_at(word.offset, std::string(quoted(word)) + " (:numeric-fluents) is not supported; only "
                                                                "(increase (total-cost) ...) is");
      }
    }
    Token name = word;
    effect->kind = Effect::Kind::kAdd;
    const bool negated = is(word, "not");
    if (negated) {
      effect->kind = Effect::Kind::kDelete;
      if (!expect_open("the fact to delete") || !expect_word("a predicate", &name)) return false;
    }
    if (!find_predicate(domain_, name, &effect->atom.predicate)) return false;
    const auto& parameters = domain_.predicate_schemas[static_cast<std::size_t>(effect->atom.predicate)].parameters;
    changed_.push_back({effect->atom.predicate, name});
    return atom_arguments(domain_, nullptr, scope, name, parameters, &effect->atom.arguments) &&
           (!negated || expect_close("'not'"));
  }

  bool increase(Scope& scope, ActionSchema& schema, const Token& word, bool conditional) {
    Token name;
    if (!expect_open("(total-cost)") || !expect_word("total-cost", &name)) return false;
    if (!is(name, "total-cost")) {
      return fail_at(name.offset, "only total-cost may be increased (numeric fluents are not supported), not " +
                                      quoted(name));
    }
    if (conditional) return fail_at(word.offset, "a cost that depends on a condition is not supported");
    if (!expect_close("(total-cost)")) return false;
    if (peek().kind == Token::Kind::kWord) {
      const Token number = next();
      std::int64_t value = 0;
      if (!integer(number, &value)) return false;
      if (value > kHighestCost - schema.cost.constant) return fail_at(number.offset, "a cost above 1000000000");
      schema.cost.constant += value;
      return expect_close("'increase'");
    }
    AtomPattern cost;
    if (!expect_open("a function") || !expect_word("a function", &name)) return false;
    cost.predicate = domain_.functions.find(name.text);
    if (cost.predicate == SymbolTable::kNone) {
      return fail_at(name.offset,
                     "unknown function " + quoted(name) + did_you_mean(name.text, domain_.functions.names()));
    }
    const auto& parameters = domain_.function_schemas[static_cast<std::size_t>(cost.predicate)].parameters;
    if (!atom_arguments(domain_, nullptr, scope, name, parameters, &cost.arguments)) return false;
    schema.cost.functions.push_back(std::move(cost));
    return expect_close("'increase'");
  }

  bool derived() {
    DerivedPredicate definition;
    Scope scope{&definition.slots, nullptr, {}};
    Token name;
    std::vector<TypedName> parameters;
    if (!expect_open("a predicate") || !expect_word("a predicate", &name) ||
        !find_predicate(domain_, name, &definition.predicate) ||
        !typed_list(domain_, true, "a variable", &parameters) || !expect_close("the predicate")) {
      return false;
    }
    const auto& schema = domain_.predicate_schemas[static_cast<std::size_t>(definition.predicate)].parameters;
    if (schema.size() != parameters.size()) {
      return fail_at(name.offset, quoted(name) + " takes " + std::to_string(schema.size()) + " arguments, not " +
                                      std::to_string(parameters.size()));
    }
    for (TypedName& parameter : parameters) {
      scope.visible.emplace_back(parameter.name, static_cast<std::int32_t>(definition.slots.size()));
      definition.slots.push_back(std::move(parameter.types));
    }
    definition.parameter_count = static_cast<std::int32_t>(parameters.size());
    if (!formula(domain_, nullptr, scope, 0, &definition.body)) return false;
    domain_.derived.push_back(std::move(definition));
    derived_names_.push_back(name);
    return expect_close(":derived");
  }

  bool check_derived() {
    for (std::size_t i = 0; i < domain_.derived.size(); ++i) {
      for (const auto& [predicate, token] : changed_) {
        if (predicate == domain_.derived[i].predicate) {
          return fail_at(token.offset, quoted(token) + " is derived; no action may change it");
        }
      }
    }
    if (const auto circular = assign_layers(domain_)) {
      const auto same = [&](const DerivedPredicate& definition) { return definition.predicate == *circular; };
      const auto place = std::find_if(domain_.derived.begin(), domain_.derived.end(), same) - domain_.derived.begin();
      const Token& name = derived_names_[static_cast<std::size_t>(place)];
      return fail_at(name.offset, "derived predicate " + quoted(name) +
                                      " depends on its own opposite, directly or through others; that defines nothing");
    }
    return true;
  }

 public:
  static constexpr std::int64_t kHighestCost = 1'000'000'000;

 private:
  bool integer(const Token& number, std::int64_t* value) {
    std::string_view text = number.text;
    if (const std::size_t point = text.find('.'); point != std::string_view::npos) {
      if (text.find_first_not_of('0', point + 1) == std::string_view::npos) text = text.substr(0, point);  // "3.0"
    }
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), *value);
    if (code != std::errc{} || end != text.data() + text.size() || *value < 0 || *value > kHighestCost) {
      return fail_at(number.offset, "a cost must be a whole number from 0 to 1000000000, not " + quoted(number));
    }
    return true;
  }

  Domain domain_;
  bool seen_types_ = false, seen_constants_ = false, seen_predicates_ = false, seen_functions_ = false;
  std::vector<std::pair<PredicateId, Token>> changed_;  // where effects change which predicate
  std::vector<Token> derived_names_;
};

}  // namespace

bool Domain::has_recursion() const {
  return std::any_of(layer.begin(), layer.end(), [](std::int32_t l) { return l >= 0; });
}

bool Domain::is_a(TypeId type, TypeId ancestor) const {
  if (ancestor == 0 || type == ancestor) return true;
  const auto& above = ancestors[static_cast<std::size_t>(type)];
  return std::binary_search(above.begin(), above.end(), ancestor);
}

bool Domain::is_a(TypeId type, const TypeSet& any_of) const {
  return std::any_of(any_of.begin(), any_of.end(), [&](TypeId ancestor) { return is_a(type, ancestor); });
}

Expected<Domain> parse_domain(std::string_view text, std::string_view filename) {
  return DomainParser(text, filename).parse();
}

Expected<Domain> load_domain(const std::string& path) {
  const auto text = read_text_file(path);
  if (!text) return tl::unexpected(text.error());
  return parse_domain(*text, path);
}

}  // namespace goalnet::planner
