// (:action …)
#include <charconv>

#include "components/planner/domain_parser.h"

namespace goalnet::planner {

bool DomainParser::action() {
  Token name;
  if (!expect_word("the action's name", &name) || !check_name(name, "an action")) return false;
  if (domain_.action_names.find(name.text) != SymbolTable::kNone) {
    return fail_at(name.offset, "action " + quoted(name) + " is declared twice");
  }
  ActionSchema schema;
  schema.name = arena_.copy_text(name.text);
  std::vector<TypeSet> types;
  Scope scope{&types, {}};
  bool parameters = false, precondition = false, effect = false;
  while (!failed() && peek().kind == Token::Kind::kWord) {
    const Token word = next();
    if (is(word, ":parameters")) {
      if (precondition || effect) return fail_at(word.offset, ":parameters must come first");
      Array<std::int32_t> slots;
      if (!once(&parameters, word) || !quantified(domain_, scope, &slots)) return false;
      schema.parameter_count = static_cast<std::int32_t>(slots.size());
    } else if (is(word, ":precondition")) {
      if (!once(&precondition, word) || !formula(domain_, nullptr, scope, 0, &schema.precondition))
        return false;
    } else if (is(word, ":effect")) {
      if (!once(&effect, word) || !read_effect(scope, schema, 0, false, &schema.effect)) return false;
    } else {
      return fail_at(word.offset, "expected :parameters, :precondition or :effect, found " + quoted(word));
    }
  }
  if (!expect_close("the action")) return false;
  schema.slots = arena_.copy(types);
  schema.cost.functions = arena_.copy(cost_functions_);
  cost_functions_.clear();
  domain_.action_names.add(schema.name);
  domain_.actions.push_back(schema);
  return true;
}

bool DomainParser::read_effect(Scope& scope, ActionSchema& schema, int depth, bool conditional,
                               Effect* effect) {
  if (failed() || too_deep(depth) || !expect_open("an effect")) return false;
  if (peek().kind == Token::Kind::kClose) {
    next();
    return true;
  }
  Token word;
  if (!expect_word("an effect", &word)) return false;
  if (is(word, "and")) {
    while (!failed() && peek().kind != Token::Kind::kClose) {
      Effect& child = effect->children.push_back(arena_, {});
      if (!read_effect(scope, schema, depth + 1, conditional, &child)) return false;
    }
    return expect_close("'and'");
  }
  if (is(word, "forall")) {
    effect->kind = Effect::Kind::kForall;
    const std::size_t outer = scope.visible.size();
    if (!quantified(domain_, scope, &effect->slots)) return false;
    const bool good = read_effect(scope, schema, depth + 1, true, &effect->children.push_back(arena_, {}));
    scope.visible.resize(outer);
    return good && expect_close("'forall'");
  }
  if (is(word, "when")) {
    effect->kind = Effect::Kind::kWhen;
    return formula(domain_, nullptr, scope, depth + 1, &effect->condition) &&
           read_effect(scope, schema, depth + 1, true, &effect->children.push_back(arena_, {})) &&
           expect_close("'when'");
  }
  if (is(word, "increase")) return increase(scope, schema, word, conditional);
  for (const char* other : {"assign", "decrease", "scale-up", "scale-down"}) {
    if (is(word, other)) {
      return fail_at(word.offset, std::string(quoted(word)) +
                                      " (:numeric-fluents) is not supported; only "
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
  const auto& parameters =
      domain_.predicate_schemas[static_cast<std::size_t>(effect->atom.predicate)].parameters;
  changed_.push_back({effect->atom.predicate, name});
  return atom_arguments(domain_, nullptr, scope, name, parameters, &effect->atom.arguments) &&
         (!negated || expect_close("'not'"));
}

bool DomainParser::increase(Scope& scope, ActionSchema& schema, const Token& word, bool conditional) {
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
    return fail_at(name.offset, "unknown function " + quoted(name) +
                                    did_you_mean(name.text, domain_.functions.first_names()));
  }
  const auto& parameters = domain_.function_schemas[static_cast<std::size_t>(cost.predicate)].parameters;
  if (!atom_arguments(domain_, nullptr, scope, name, parameters, &cost.arguments)) return false;
  cost_functions_.push_back(cost);
  return expect_close("'increase'");
}

bool DomainParser::integer(const Token& number, std::int64_t* value) {
  std::string_view text = number.text;
  if (const std::size_t point = text.find('.'); point != std::string_view::npos) {
    if (text.find_first_not_of('0', point + 1) == std::string_view::npos)
      text = text.substr(0, point);  // "3.0"
  }
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), *value);
  if (code != std::errc{} || end != text.data() + text.size() || *value < 0 || *value > kHighestCost) {
    return fail_at(number.offset,
                   "a cost must be a whole number from 0 to 1000000000, not " + quoted(number));
  }
  return true;
}

}  // namespace goalnet::planner
