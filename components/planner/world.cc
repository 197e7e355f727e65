#include "components/planner/world.h"

#include <algorithm>
#include <array>
#include <set>

#include "components/planner/interpreter.h"

namespace goalnet::planner {
namespace {

// "Mug_12" → "Mug".
std::string_view class_of(std::string_view name) {
  const std::size_t last = name.find_last_not_of("0123456789");
  if (last == std::string_view::npos || last + 1 == name.size() || name[last] != '_') return name;
  return name.substr(0, last);
}

TypeId type_for(const Domain& domain, std::string_view name) {
  const std::string_view wanted = class_of(name);
  const TypeId thing = std::max<TypeId>(domain.types.find("thing"), 0);
  for (std::int32_t id = 0; id < domain.constants.size(); ++id) {
    const TypeId type = domain.constant_types[static_cast<std::size_t>(id)];
    // Only things: the class of Coke_1 is not that of the content Coke.
    if (domain.is_a(type, thing) && equal_ignoring_case(class_of(domain.constants.view(id)), wanted))
      return type;
  }
  return thing;
}

// Household bookkeeping: how many objects are in the hands and on the tray, as (HandsHold One), (TrayHolds
// Zero). Domains without these predicates are not touched.
constexpr std::array<const char*, 5> kCounts = {"Zero", "One", "Two", "Three", "Four"};

void add_count(Problem& problem, const char* predicate_name, std::size_t count, std::size_t most) {
  const Domain& domain = problem.domain();
  const PredicateId predicate = domain.predicates.find(predicate_name);
  if (predicate == SymbolTable::kNone) return;
  const ObjectId id = domain.constants.find(kCounts[std::min(count, most)]);
  if (id != SymbolTable::kNone) problem.initial.add(predicate, &id, 1);
}

void add_counts(const FactSet& facts, Problem& problem) {
  if (problem.domain().predicates.find("HandsHold") == SymbolTable::kNone) return;
  std::size_t held = 0, on_tray = 0;
  for (const Predicate& fact : facts) {
    if (fact.relation == "Grasping") ++held;
    if (fact.relation == "Held" && fact.object == "Tray") ++on_tray;
  }
  add_count(problem, "HandsHold", held - std::min(held, on_tray), 2);
  add_count(problem, "TrayHolds", on_tray, 4);
}

bool is_bookkeeping(const Domain& domain, PredicateId predicate) {
  const std::string_view name = domain.predicates.view(predicate);
  return name == "HandsHold" || name == "TrayHolds";
}

// The fact's arguments as objects of the problem; false if some name or the relation is unknown, or the shape
// differs.
bool intern(const Problem& problem, const Predicate& fact, PredicateId* predicate,
            std::array<ObjectId, 2>* ids, std::size_t* count) {
  *predicate = problem.domain().predicates.find(fact.relation);
  if (*predicate == SymbolTable::kNone) return false;
  const auto& schema = problem.domain().predicate_schemas[static_cast<std::size_t>(*predicate)].parameters;
  *count = fact.object.empty() ? 1 : 2;
  if (schema.size() != *count) return false;
  (*ids)[0] = problem.find_object(fact.subject);
  (*ids)[1] = *count == 2 ? problem.find_object(fact.object) : 0;
  for (std::size_t i = 0; i < *count; ++i) {
    if ((*ids)[i] == SymbolTable::kNone || !problem.object_is_a((*ids)[i], schema[i])) return false;
  }
  return true;
}

void load_objects(const WorldState& state, Problem& problem) {
  const Domain& domain = problem.domain();
  const TypeId thing = domain.types.find("thing");
  if (thing != SymbolTable::kNone && !state.objects.empty()) {
    for (ObjectId id = 0; id < domain.constants.size(); ++id) {
      if (domain.is_a(problem.object_type(id), thing)) problem.set_present(id, false);
    }
  }
  const auto add = [&](const std::string& name) {
    const ObjectId known = problem.find_object(name);
    if (known == SymbolTable::kNone) {
      problem.add_object(name, type_for(domain, name));
    } else {
      problem.set_present(known, true);
    }
  };
  for (const std::string& name : state.objects) add(name);
  if (!state.objects.empty()) return;
  for (const Predicate& fact : state.facts) {  // no list: what the facts speak of exists
    add(fact.subject);
    if (!fact.object.empty() && fact.relation != "state") add(fact.object);
  }
}

void load_facts(const WorldState& state, Problem& problem) {
  PredicateId predicate = 0;
  std::array<ObjectId, 2> ids{};
  std::size_t count = 0;
  for (const Predicate& fact : state.facts) {
    if (intern(problem, fact, &predicate, &ids, &count)) problem.initial.add(predicate, ids.data(), count);
  }
  add_counts(state.facts, problem);
}

Expected<Formula> goal_literal(const Problem& problem, const Predicate& fact) {
  const Domain& domain = problem.domain();
  const PredicateId predicate = domain.predicates.find(fact.relation);
  if (predicate == SymbolTable::kNone) {
    return fail(Outcome::kInvalidRequest, "goal " + to_string(fact) + ": unknown relation '" + fact.relation +
                                              "'" +
                                              did_you_mean(fact.relation, domain.predicates.first_names()));
  }
  const auto& schema = domain.predicate_schemas[static_cast<std::size_t>(predicate)].parameters;
  const std::size_t count = fact.object.empty() ? 1 : 2;
  if (schema.size() != count) {
    return fail(Outcome::kInvalidRequest, "goal " + to_string(fact) + ": " + fact.relation + " takes " +
                                              std::to_string(schema.size()) + " arguments, not " +
                                              std::to_string(count));
  }
  Formula literal;
  literal.kind = Formula::Kind::kAtom;
  literal.atom.predicate = predicate;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string& name = i == 0 ? fact.subject : fact.object;
    const ObjectId id = problem.find_object(name);
    if (id == SymbolTable::kNone || !problem.present(id)) {
      std::vector<std::string> names;  // only what could stand there
      for (ObjectId other = 0; other < problem.object_count(); ++other) {
        if (problem.object_is_a(other, schema[i])) names.push_back(problem.object_name(other));
      }
      return fail(Outcome::kUnknownObject, "goal " + to_string(fact) + ": unknown " +
                                               (fact.relation == "state" && i == 1 ? "state '" : "object '") +
                                               name + "'" + did_you_mean(name, names));
    }
    if (!problem.object_is_a(id, schema[i])) {
      return fail(Outcome::kInvalidRequest, "goal " + to_string(fact) + ": " + name + ", a " +
                                                domain.types.name(problem.object_type(id)) +
                                                ", cannot stand in place " + std::to_string(i + 1) + " of " +
                                                fact.relation);
    }
    literal.atom.arguments.push_back(Term::object(id));
  }
  return literal;
}

Expected<void> load_goal(const Goal& goal, Problem& problem) {
  problem.goal.kind = Formula::Kind::kAnd;
  List<Formula>& parts = problem.goal.children;
  for (const Predicate& fact : goal.positive) {
    const auto literal = goal_literal(problem, fact);
    if (!literal) return tl::unexpected(literal.error());
    parts.push_back(problem.arena(), *literal);
  }
  const std::size_t positives = parts.size();
  for (const Predicate& fact : goal.negative) {
    const auto literal = goal_literal(problem, fact);
    if (!literal) return tl::unexpected(literal.error());
    std::size_t i = 0;
    for (const Formula& part : parts) {
      if (i == positives) break;
      if (part.atom == literal->atom) {
        return fail(Outcome::kInvalidRequest, "the goal contradicts itself: " + to_string(goal.positive[i]) +
                                                  " and (not " + to_string(fact) + ")");
      }
      ++i;
    }
    Formula negated;
    negated.kind = Formula::Kind::kNot;
    negated.children.push_back(problem.arena(), *literal);
    parts.push_back(problem.arena(), negated);
  }
  if (parts.empty()) problem.goal.kind = Formula::Kind::kTrue;
  return {};
}

// What apply and applicable share: the state as a problem, the action bound, the precondition checked.
struct Prepared {
  Problem problem;
  AtomSet atoms;
  std::vector<ObjectId> binding;
  const ActionSchema* schema = nullptr;
  explicit Prepared(const Domain& domain) : problem(domain) {}
};

Expected<void> prepare(const WorldState& state, const Action& action, Prepared& prepared) {
  load_objects(state, prepared.problem);
  load_facts(state, prepared.problem);
  const Interpreter interpreter(prepared.problem);
  const auto schema = interpreter.bind(action, prepared.binding);
  if (!schema) return tl::unexpected(schema.error());
  prepared.schema = *schema;
  prepared.atoms.assign(prepared.problem.initial);
  interpreter.complete(prepared.atoms);
  const ActionSchema& s = *prepared.schema;
  if (interpreter.holds(s.precondition, s.slots, prepared.binding, prepared.atoms)) return {};
  return fail(Outcome::kNoPlan,
              "(" + to_string(action) + ") is not possible: " +
                  interpreter.why_not(s.precondition, s.slots, prepared.binding, prepared.atoms));
}

}  // namespace

Expected<void> make_problem(const WorldState& state, const Goal& goal, Problem& problem) {
  problem.restart();
  problem.minimise_cost = problem.domain().functions.find("total-cost") != SymbolTable::kNone;
  load_objects(state, problem);
  load_facts(state, problem);
  return load_goal(goal, problem);
}

Expected<Problem> make_problem(const Domain& domain, const WorldState& state, const Goal& goal) {
  Problem problem(domain);
  if (auto made = make_problem(state, goal, problem); !made) return tl::unexpected(made.error());
  return problem;
}

Expected<void> applicable(const Domain& domain, const WorldState& state, const Action& action) {
  Prepared prepared(domain);
  return prepare(state, action, prepared);
}

Expected<FactSet> apply(const Domain& domain, const WorldState& state, const Action& action) {
  Prepared prepared(domain);
  if (auto ready = prepare(state, action, prepared); !ready) return tl::unexpected(ready.error());
  const Interpreter interpreter(prepared.problem);
  FactSet facts = state.facts;
  const ActionSchema& schema = *prepared.schema;
  for (const AtomChange& change :
       interpreter.changes(schema.effect, schema.slots, prepared.binding, prepared.atoms)) {
    if (is_bookkeeping(domain, change.predicate)) continue;
    Predicate fact{domain.predicates.name(change.predicate),
                   prepared.problem.object_name(change.arguments[0]),
                   change.arguments.size() > 1 ? prepared.problem.object_name(change.arguments[1]) : ""};
    change.added ? facts.insert(fact) : facts.erase(fact);
  }
  return facts;
}

}  // namespace goalnet::planner
