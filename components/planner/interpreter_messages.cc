// What the interpreter says to people: names looked up, and why a condition does not hold.
#include <string>
#include <vector>

#include "components/planner/interpreter.h"

namespace goalnet::planner {

std::string Interpreter::text(const AtomPattern& atom, const std::vector<ObjectId>& binding) const {
  std::string result = "(" + problem_.domain().predicates.name(atom.predicate);
  for (const Term argument : atom.arguments) {
    const ObjectId id = argument.resolve(binding.data());
    result += " " + (id < 0 ? std::string("?") : problem_.object_name(id));
  }
  return result + ")";
}

std::string Interpreter::why_not(const Formula& formula, std::span<const TypeSet> slots,
                                 std::vector<ObjectId>& binding, const AtomSet& state) const {
  const auto name = [&](Term term) { return problem_.object_name(term.resolve(binding.data())); };
  switch (formula.kind) {
    case Formula::Kind::kTrue:
      return "";
    case Formula::Kind::kFalse:
      return "it never applies";
    case Formula::Kind::kAtom:
      return text(formula.atom, binding) + " does not hold";
    case Formula::Kind::kEqual:
      return name(formula.atom.arguments[0]) + " is not " + name(formula.atom.arguments[1]);
    case Formula::Kind::kNot: {
      const Formula& inner = formula.children.front();
      if (inner.kind == Formula::Kind::kAtom) return text(inner.atom, binding) + " holds";
      if (inner.kind == Formula::Kind::kEqual)
        return name(inner.atom.arguments[0]) + " may not be used with itself";
      return "what must not hold holds";
    }
    case Formula::Kind::kAnd:
      for (const Formula& child : formula.children) {
        if (!holds(child, slots, binding, state)) return why_not(child, slots, binding, state);
      }
      return "";
    case Formula::Kind::kOr: {
      // Alternatives that equality rules out are not worth telling ("MicrowaveButton is not FridgeButton").
      std::string result;
      for (const Formula& child : formula.children) {
        if (const std::string reason = why_not(child, slots, binding, state);
            reason.find(" is not ") == std::string::npos && reason.find(" itself") == std::string::npos) {
          result += (result.empty() ? "" : ", and ") + reason;
        }
      }
      return result.empty() ? "it does not apply to these arguments" : result;
    }
    case Formula::Kind::kForall: {
      std::string result;
      for_each_binding(formula.slots, 0, slots, binding, [&] {
        if (holds(formula.children.front(), slots, binding, state)) return true;
        result = why_not(formula.children.front(), slots, binding, state);
        return false;
      });
      return result;
    }
    case Formula::Kind::kExists:
      return "nothing fits a condition of the kind 'exists'";
  }
  return "";
}

Expected<const ActionSchema*> Interpreter::bind(const Action& action, std::vector<ObjectId>& binding) const {
  const Domain& domain = problem_.domain();
  const std::int32_t index = domain.action_names.find(action.name);
  if (index == SymbolTable::kNone) {
    return fail(Outcome::kInvalidRequest, "domain " + domain.name + " has no action '" + action.name + "'" +
                                              did_you_mean(action.name, domain.action_names.first_names()));
  }
  const ActionSchema& schema = domain.actions[static_cast<std::size_t>(index)];
  if (static_cast<std::int32_t>(action.arguments.size()) != schema.parameter_count) {
    return fail(Outcome::kInvalidRequest, "action " + std::string(schema.name) + " takes " +
                                              std::to_string(schema.parameter_count) + " arguments, not " +
                                              std::to_string(action.arguments.size()) + ": (" +
                                              to_string(action) + ")");
  }
  binding.assign(schema.slots.size(), 0);
  for (std::size_t i = 0; i < action.arguments.size(); ++i) {
    const ObjectId id = problem_.find_object(action.arguments[i]);
    if (id == SymbolTable::kNone || !problem_.present(id)) {
      return fail(Outcome::kUnknownObject,
                  "(" + to_string(action) + "): unknown object '" + action.arguments[i] + "'" +
                      did_you_mean(action.arguments[i], problem_.first_object_names()));
    }
    if (!problem_.object_is_a(id, schema.slots[i])) {
      std::string types;
      for (const TypeId type : schema.slots[i])
        types += (types.empty() ? "" : " or ") + domain.types.name(type);
      return fail(Outcome::kInvalidRequest, "(" + to_string(action) + "): " + problem_.object_name(id) +
                                                " is a " + domain.types.name(problem_.object_type(id)) +
                                                ", not a " + types);
    }
    binding[i] = id;
  }
  return &schema;
}

}  // namespace goalnet::planner
