// Conditions: terms, atoms, quantifiers.
#include <array>

#include "components/planner/parser.h"

namespace goalnet::planner {
namespace {

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
    return fail_at(word.offset,
                   "variable " + quoted(word) + " is not bound here" + did_you_mean(word.text, names));
  }
  const ObjectId id = problem != nullptr ? problem->find_object(word.text) : domain.constants.find(word.text);
  if (id == SymbolTable::kNone) {
    return fail_at(word.offset,
                   "unknown " + std::string(problem != nullptr ? "object " : "constant ") + quoted(word) +
                       did_you_mean(word.text, problem != nullptr ? problem->first_object_names()
                                                                  : domain.constants.first_names()));
  }
  *result = Term::object(id);
  return true;
}

bool Parser::atom_arguments(const Domain& domain, const Problem* problem, const Scope& scope,
                            const Token& name, std::span<const TypeSet> schema, TermList* arguments) {
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
      TypeId object_type = 0;
      TypeSet types;
      if (argument.is_variable()) {
        types = (*scope.slots)[static_cast<std::size_t>(argument.slot())];
      } else {
        object_type = problem != nullptr ? problem->object_type(argument.value)
                                         : domain.constant_types[static_cast<std::size_t>(argument.value)];
        types = {&object_type, 1};
      }
      const bool fits = argument.is_variable() ? compatible(domain, types, schema[index])
                                               : domain.is_a(object_type, schema[index]);
      if (!fits) {
        return fail_at(offset, "argument " + std::to_string(index + 1) + " of " + quoted(name) +
                                   " must be a " + names_of(domain, schema[index]) + ", not a " +
                                   names_of(domain, types));
      }
    }
    arguments->push_back(argument);
  }
  if (failed()) return false;
  if (too_many || arguments->size() != schema.size()) {
    return fail_at(name.offset, quoted(name) + " takes " + std::to_string(schema.size()) +
                                    " arguments, not " +
                                    (too_many ? "more" : std::to_string(arguments->size())));
  }
  return expect_close("the arguments");
}

bool Parser::quantified(const Domain& domain, Scope& scope, Array<std::int32_t>* slots) {
  TypedNames variables;
  if (!expect_open("the list of variables") || !typed_list(domain, true, "a variable", &variables) ||
      !expect_close("the list of variables")) {
    return false;
  }
  std::vector<std::int32_t> bound;
  for (const TypedName& variable : variables) {
    for (std::size_t i = scope.visible.size() - bound.size(); i < scope.visible.size(); ++i) {
      if (equal_ignoring_case(scope.visible[i].first, variable.name)) {
        return fail_at(variable.offset, "variable '" + std::string(variable.name) + "' is listed twice");
      }
    }
    const auto slot = static_cast<std::int32_t>(scope.slots->size());
    if (slot >= 64) return fail_at(variable.offset, "more than 64 variables in one action");
    scope.slots->push_back(variable.types);
    scope.visible.emplace_back(variable.name, slot);
    bound.push_back(slot);
  }
  *slots = arena_.copy(bound);
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
      if (!formula(domain, problem, scope, depth + 1, &result->children.push_back(arena_, {}))) return false;
    }
    if (result->children.empty()) result->kind = conjunction ? Formula::Kind::kTrue : Formula::Kind::kFalse;
    return expect_close(conjunction ? "'and'" : "'or'");
  }
  if (is(word, "not")) {
    result->kind = Formula::Kind::kNot;
    return formula(domain, problem, scope, depth + 1, &result->children.push_back(arena_, {})) &&
           expect_close("'not'");
  }
  if (is(word, "imply")) {  // (imply a b) is (or (not a) b)
    result->kind = Formula::Kind::kOr;
    Formula& opposite = result->children.push_back(arena_, {});
    opposite.kind = Formula::Kind::kNot;
    return formula(domain, problem, scope, depth + 1, &opposite.children.push_back(arena_, {})) &&
           formula(domain, problem, scope, depth + 1, &result->children.push_back(arena_, {})) &&
           expect_close("'imply'");
  }
  if (is(word, "forall") || is(word, "exists")) {
    result->kind = is(word, "forall") ? Formula::Kind::kForall : Formula::Kind::kExists;
    const std::size_t outer = scope.visible.size();
    if (!quantified(domain, scope, &result->slots)) return false;
    const bool good = formula(domain, problem, scope, depth + 1, &result->children.push_back(arena_, {}));
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
    TypeId object = 0;
    const std::array<TypeSet, 2> two{TypeSet{&object, 1}, TypeSet{&object, 1}};
    return atom_arguments(domain, problem, scope, word, two, &result->atom.arguments);
  }
  result->kind = Formula::Kind::kAtom;
  if (!find_predicate(domain, word, &result->atom.predicate)) return false;
  return atom_arguments(domain, problem, scope, word,
                        domain.predicate_schemas[static_cast<std::size_t>(result->atom.predicate)].parameters,
                        &result->atom.arguments);
}

}  // namespace goalnet::planner
