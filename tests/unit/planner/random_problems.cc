#include "tests/unit/planner/random_problems.h"

#include <algorithm>
#include <map>
#include <queue>
#include <set>
#include <vector>

#include "components/planner/interpreter.h"

namespace goalnet::planner {
namespace {

class Writer {
 public:
  Writer(std::uint64_t seed, bool with_costs) : random_(seed), with_costs_(with_costs) {}

  RandomText write() {
    const int predicates = 3 + below(3);
    for (int i = 0; i < predicates; ++i)
      arity_.push_back(below(5) == 0 ? 2 : below(2) + (below(3) == 0 ? 1 : 0));
    // p0 is static: no effect mentions it.
    std::string domain =
        "(define (domain d) (:requirements :adl :derived-predicates)\n(:types t u - object)\n";
    domain += "(:constants k - t)\n(:predicates";
    for (std::size_t p = 0; p < arity_.size(); ++p) {
      domain += " (p" + std::to_string(p);
      for (int i = 0; i < arity_[p]; ++i) domain += " ?x" + std::to_string(i);
      domain += ")";
    }
    domain += " (derived ?x) (chain ?x ?y))\n(:functions (total-cost) - number (price ?x) - number)\n";
    variables_ = {"?x"};
    derived_allowed_ = false;
    domain += "(:derived (derived ?x) " + formula(1) + ")\n";
    if (below(3) ==
        0) {  // a chain of links that hold at the time; sometimes two definitions, sometimes with a negation
      chain_ = true;
      variables_ = {"?x", "?y"};
      const std::string link = formula(1);
      domain += below(2) == 0 ? "(:derived (chain ?x ?y) (or " + link +
                                    " (exists (?z) (and (chain ?x ?z) (chain ?z ?y)))))\n"
                              : "(:derived (chain ?x ?y - (either t u)) " + link +
                                    ")\n(:derived (chain ?x ?y) (exists (?z) (and (chain ?x ?z) (chain ?z "
                                    "?y) (not (derived ?z)))))\n";
    }
    derived_allowed_ = true;
    const int actions = 2 + below(4);
    for (int a = 0; a < actions; ++a) domain += action(a);
    domain += ")";
    variables_.clear();
    std::string problem = "(define (problem q) (:domain d) (:objects a b - t c - u)\n(:init";
    for (std::size_t p = 0; p < arity_.size(); ++p) {
      for (const std::string& atom : atoms(p)) {
        if (below(4) == 0) problem += " " + atom;
      }
    }
    if (with_costs_) {
      for (const char* object : {"k", "a", "b", "c"}) {
        problem += " (= (price " + std::string(object) + ") " + std::to_string(below(4)) + ")";
      }
    }
    objects_only_ = true;
    problem += ")\n(:goal (and";
    const int goals = 2 + below(4);
    for (int g = 0; g < goals; ++g) {
      const auto p = 1 + static_cast<std::size_t>(below(static_cast<int>(arity_.size()) - 1));
      problem += " " + (below(6) == 0 ? formula(1) : below(3) == 0 ? "(not " + atom(p) + ")" : atom(p));
    }
    problem += "))" + std::string(with_costs_ ? "(:metric minimize (total-cost))" : "") + ")";
    return {domain, problem};
  }

 private:
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }

  std::vector<std::string> atoms(std::size_t p) {
    const std::vector<std::string> objects = {"k", "a", "b", "c"};
    std::vector<std::string> result = {"(p" + std::to_string(p)};
    for (int i = 0; i < arity_[p]; ++i) {
      std::vector<std::string> longer;
      for (const auto& prefix : result) {
        for (const auto& object : objects) longer.push_back(prefix + " " + object);
      }
      result = longer;
    }
    for (auto& atom : result) atom += ")";
    return result;
  }

  std::string term() {
    if (!variables_.empty() && below(5) != 0)
      return variables_[static_cast<std::size_t>(below(static_cast<int>(variables_.size())))];
    if (!objects_only_) return "k";
    return std::vector<std::string>{"k", "a", "b", "c"}[static_cast<std::size_t>(below(4))];
  }

  std::string atom(std::size_t p) {
    std::string text = "(p" + std::to_string(p);
    for (int i = 0; i < arity_[p]; ++i) text += " " + term();
    return text + ")";
  }

  std::string literal() {
    std::string text = derived_allowed_ && below(8) == 0
                           ? "(derived " + term() + ")"
                           : atom(static_cast<std::size_t>(below(static_cast<int>(arity_.size()))));
    if (chain_ && derived_allowed_ && below(5) == 0) text = "(chain " + term() + " " + term() + ")";
    if (below(6) == 0) text = "(= " + term() + " " + term() + ")";
    return below(3) == 0 ? "(not " + text + ")" : text;
  }

  std::string formula(int depth) {
    const int choice = depth == 0 ? 0 : below(8);
    if (choice < 3) return literal();
    if (choice == 3) return "(and " + formula(depth - 1) + " " + formula(depth - 1) + ")";
    if (choice == 4) return "(or " + formula(depth - 1) + " " + formula(depth - 1) + ")";
    if (choice == 5) return "(imply " + formula(depth - 1) + " " + formula(depth - 1) + ")";
    const std::string variable = "?q" + std::to_string(quantified_++);
    variables_.push_back(variable);
    const std::string inner = formula(depth - 1);
    variables_.pop_back();
    return std::string(choice == 6 ? "(forall (" : "(exists (") + variable +
           (below(2) == 0 ? " - t) " : ") ") + inner + ")";
  }

  std::string effect(int depth) {
    const int choice = depth == 0 ? 0 : below(7);
    if (choice < 4) {
      const auto p = 1 + static_cast<std::size_t>(below(static_cast<int>(arity_.size()) - 1));
      const std::string text = atom(p);
      return below(2) == 0 ? "(not " + text + ")" : text;
    }
    if (choice == 4) return "(and " + effect(depth - 1) + " " + effect(depth - 1) + ")";
    if (choice == 5) return "(when " + formula(1) + " " + effect(depth - 1) + ")";
    const std::string variable = "?e" + std::to_string(quantified_++);
    variables_.push_back(variable);
    const std::string inner = effect(depth - 1);
    variables_.pop_back();
    return "(forall (" + variable + (below(2) == 0 ? " - t) " : ") ") + inner + ")";
  }

  std::string action(int index) {
    variables_.clear();
    std::string text = "(:action a" + std::to_string(index) + " :parameters (";
    const int parameters = below(4) == 0 ? 0 : 1 + below(2);
    for (int i = 0; i < parameters; ++i) {
      variables_.push_back("?v" + std::to_string(i));
      text += variables_.back() + (below(2) == 0 ? " - t " : below(4) == 0 ? " - (either t u) " : " ");
    }
    text += ")\n :precondition (and";
    const int conditions = 1 + below(3);
    for (int i = 0; i < conditions; ++i) text += " " + (below(5) == 0 ? formula(2) : literal());
    text += ")\n :effect (and";
    const int effects = 1 + below(3);
    for (int i = 0; i < effects; ++i) text += " " + effect(2);
    if (with_costs_) {
      const bool priced = below(3) == 0;
      variables_.resize(static_cast<std::size_t>(parameters));
      text +=
          " (increase (total-cost) " + (priced ? "(price " + term() + ")" : std::to_string(below(4))) + ")";
    }
    return text + "))\n";
  }

  std::mt19937_64 random_;
  bool with_costs_;
  bool derived_allowed_ = true;
  bool objects_only_ = false;
  bool chain_ = false;  // the recursive predicate is defined
  std::vector<int> arity_;
  std::vector<std::string> variables_;
  int quantified_ = 0;
};

using Atom = std::vector<std::int32_t>;  // predicate, arguments
using State = std::set<Atom>;

AtomSet set_of(const Problem& problem, const State& state) {
  AtomTable table;
  for (const Atom& atom : state) table.add(atom[0], atom.data() + 1, atom.size() - 1);
  AtomSet result;
  result.assign(table);
  Interpreter(problem).complete(result);
  return result;
}

State state_of(const Problem& problem) {
  State state;
  for (std::int32_t atom = 0; atom < problem.initial.size(); ++atom) {
    Atom entry = {problem.initial.predicate(atom)};
    for (const ObjectId id : problem.initial.arguments(atom)) entry.push_back(id);
    state.insert(entry);
  }
  return state;
}

// visit(state, cost) for every action that applies.
template <class Visit>
void for_each_successor(const Problem& problem, const State& state, const Visit& visit) {
  const Interpreter interpreter(problem);
  const AtomSet atoms = set_of(problem, state);
  for (const ActionSchema& action : problem.domain().actions) {
    std::vector<ObjectId> binding(action.slots.size(), 0);
    const auto expand = [&](const auto& self, std::int32_t parameter) -> void {
      if (parameter < action.parameter_count) {
        for (ObjectId id = 0; id < problem.object_count(); ++id) {
          if (!problem.object_is_a(id, action.slots[static_cast<std::size_t>(parameter)])) continue;
          binding[static_cast<std::size_t>(parameter)] = id;
          self(self, parameter + 1);
        }
        return;
      }
      std::vector<ObjectId> inner = binding;
      if (!interpreter.holds(action.precondition, action.slots, inner, atoms)) return;
      State next = state;
      for (const AtomChange& change : interpreter.changes(action.effect, action.slots, inner, atoms)) {
        Atom entry = {change.predicate};
        entry.insert(entry.end(), change.arguments.begin(), change.arguments.end());
        if (change.added) {
          next.insert(entry);
        } else {
          next.erase(entry);
        }
      }
      visit(std::move(next), *interpreter.cost(action, binding));
    };
    expand(expand, 0);
  }
}

}  // namespace

RandomText random_problem(std::uint64_t seed, bool with_costs) { return Writer(seed, with_costs).write(); }

void set_reachable_goal(std::uint64_t seed, int steps, Problem& problem) {
  std::mt19937_64 random(seed);
  const State start = state_of(problem);
  State state = start;
  for (int step = 0; step < steps; ++step) {
    std::vector<State> successors;
    for_each_successor(problem, state, [&](State next, std::int64_t) {
      if (next != state) successors.push_back(std::move(next));
    });
    if (successors.empty()) break;
    state = successors[random() % successors.size()];
  }
  problem.goal = Formula{};
  problem.goal.kind = Formula::Kind::kAnd;
  problem.goal_slots.clear();
  const auto want = [&](const Atom& atom, bool negative) {
    Formula literal;
    literal.kind = Formula::Kind::kAtom;
    literal.atom.predicate = atom[0];
    for (std::size_t i = 1; i < atom.size(); ++i) literal.atom.arguments.push_back(Term::object(atom[i]));
    if (negative) {
      const Formula inner = literal;
      literal = Formula{};
      literal.kind = Formula::Kind::kNot;
      literal.children.push_back(problem.arena(), inner);
    }
    problem.goal.children.push_back(problem.arena(), literal);
  };
  for (const Atom& atom : state) {
    if (random() % (start.count(atom) != 0 ? 6 : 2) == 0) want(atom, false);
  }
  for (const Atom& atom : start) {
    if (state.count(atom) == 0 && random() % 2 == 0) want(atom, true);
  }
  if (problem.goal.children.empty()) problem.goal.kind = Formula::Kind::kTrue;
}

Reference breadth_first(const Problem& problem, std::size_t most_states) {
  const Interpreter interpreter(problem);
  std::map<State, std::int64_t> best = {{state_of(problem), 0}};
  using Entry = std::pair<std::int64_t, const State*>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  open.emplace(0, &best.begin()->first);
  while (!open.empty()) {
    const auto [g, state] = open.top();
    open.pop();
    if (g > best.at(*state)) continue;
    std::vector<ObjectId> goal_binding(problem.goal_slots.size(), 0);
    if (interpreter.holds(problem.goal, problem.goal_slots, goal_binding, set_of(problem, *state)))
      return {true, false, g};
    if (best.size() > most_states) return {false, true, 0};
    for_each_successor(problem, *state, [&, from = g](State next, std::int64_t cost) {
      const auto [place, is_new] = best.emplace(std::move(next), from + cost);
      if (!is_new && place->second <= from + cost) return;
      place->second = from + cost;
      open.emplace(from + cost, &place->first);
    });
  }
  return {};
}

}  // namespace goalnet::planner
