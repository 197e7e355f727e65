// (:derived …)
#include <algorithm>

#include "components/planner/derived_layers.h"
#include "components/planner/domain_parser.h"

namespace goalnet::planner {
namespace {

constexpr std::size_t kMostDerived = 4096;

}  // namespace

bool DomainParser::derived() {
  DerivedPredicate definition;
  std::vector<TypeSet> types;
  Scope scope{&types, {}};
  Token name;
  TypedNames parameters;
  if (!expect_open("a predicate") || !expect_word("a predicate", &name) ||
      !find_predicate(domain_, name, &definition.predicate) ||
      !typed_list(domain_, true, "a variable", &parameters) || !expect_close("the predicate")) {
    return false;
  }
  const auto schema = domain_.predicate_schemas[static_cast<std::size_t>(definition.predicate)].parameters;
  if (schema.size() != parameters.size()) {
    return fail_at(name.offset, quoted(name) + " takes " + std::to_string(schema.size()) +
                                    " arguments, not " + std::to_string(parameters.size()));
  }
  for (const TypedName& parameter : parameters) {
    scope.visible.emplace_back(parameter.name, static_cast<std::int32_t>(types.size()));
    types.push_back(parameter.types);
  }
  definition.parameter_count = static_cast<std::int32_t>(parameters.size());
  if (!formula(domain_, nullptr, scope, 0, &definition.body)) return false;
  definition.slots = arena_.copy(types);
  if (domain_.derived.size() == kMostDerived) {
    return fail_at(name.offset,
                   "more than " + std::to_string(kMostDerived) + " definitions of derived predicates");
  }
  domain_.derived.push_back(definition);
  derived_names_.push_back(name);
  return expect_close(":derived");
}

bool DomainParser::check_derived() {
  const auto circular = assign_layers(domain_, stop_);
  if (stop_asked()) return false;
  for (const auto& [predicate, token] : changed_) {
    if (domain_.is_derived(predicate)) {
      return fail_at(token.offset, quoted(token) + " is derived; no action may change it");
    }
  }
  if (circular) {
    const auto same = [&](const DerivedPredicate& definition) { return definition.predicate == *circular; };
    const auto place =
        std::find_if(domain_.derived.begin(), domain_.derived.end(), same) - domain_.derived.begin();
    const Token& name = derived_names_[static_cast<std::size_t>(place)];
    return fail_at(name.offset,
                   "derived predicate " + quoted(name) +
                       " depends on its own opposite, directly or through others; that defines nothing");
  }
  return true;
}

}  // namespace goalnet::planner
