// Atoms found forwards: never too few on random problems, where every state is looked at, and no more than a
// person sees.
#include "components/planner/reachable_atoms.h"

#include <gtest/gtest.h>

#include <iostream>
#include <set>

#include "components/planner/grounder.h"
#include "components/planner/normal_form.h"
#include "tests/unit/planner/random_problems.h"

namespace goalnet::planner {
namespace {

constexpr std::int64_t kFirings = 1'000'000;

// Every atom that holds in a state that can be reached, up to a number of states, must be among `reachable`.
// Returns how many atoms were looked for.
int check_all_states(const GroundTask& task, const AtomLists& reachable) {
  constexpr std::size_t kMostStates = 500;
  Budget budget;
  std::vector<std::vector<Word>> states(1);
  initial_state(task, budget, &states[0]);
  std::set<std::vector<Word>> known = {states[0]};
  for (std::size_t i = 0; i < states.size() && states.size() < kMostStates; ++i) {
    for (const GroundAction& action : task.actions) {
      if (!action_applies(task, states[i].data(), action)) continue;
      std::vector<Word> next(states[i].size());
      apply_action(task, states[i].data(), action, next.data());
      if (known.insert(next).second) states.push_back(std::move(next));
    }
  }
  std::set<std::int32_t> found;
  for (const auto& state : states) {
    for (std::int32_t atom = 0; atom < task.atoms.size(); ++atom) {
      if (literal_holds(state.data(), 2 * atom) && reachable.covers(task.atoms.predicate(atom)))
        found.insert(atom);
    }
  }
  for (const std::int32_t atom : found) {
    const auto arguments = task.atoms.arguments(atom);
    EXPECT_TRUE(reachable.contains(task.atoms.predicate(atom), arguments.data(), arguments.size()));
  }
  return static_cast<int>(found.size());
}

TEST(ReachableAtoms, LeaveOutNothingThatCanHold) {
  int atoms = 0;
  for (std::uint64_t seed = 1; seed <= 1500; ++seed) {
    const RandomText text = random_problem(seed, false);
    const auto domain = parse_domain(text.domain, "random");
    ASSERT_TRUE(domain) << domain.error().message;
    auto problem = parse_problem(text.problem, "random", *domain);
    ASSERT_TRUE(problem) << problem.error().message;
    const CompiledDomain compiled(*domain);
    Budget budget;
    ProblemIndex index(compiled);
    index.restart(*problem, budget);
    ReachableAtoms forwards(compiled);
    const AtomLists* const reachable = forwards.compute(index, kFirings, budget);
    ASSERT_NE(reachable, nullptr);
    Arena arena;
    std::vector<TypeSet> slots = problem->goal_slots;
    const Formula goal = Normaliser(*domain, slots, arena).normalise(problem->goal);
    GroundTask task;
    if (Grounder(compiled).ground(index, goal, slots, budget, task) != Grounder::Result::kDone) continue;
    atoms += check_all_states(task, *reachable);
    if (testing::Test::HasFailure()) FAIL() << "seed " << seed << "\n" << text.domain << text.problem;
  }
  EXPECT_GT(atoms, 1000);
  std::cout << atoms << " atoms looked for\n";
}

struct Line {
  Line()
      : domain(*parse_domain("(define (domain line) (:requirements :adl) (:predicates (next ?a ?b) (at ?a) "
                             "(marked ?a) (lit ?a))"
                             "(:action go :parameters (?a ?b) :precondition (and (at ?a) (next ?a ?b))"
                             " :effect (and (at ?b) (not (at ?a))))"
                             "(:action mark :parameters (?a) :precondition (at ?a) :effect (and (marked ?a)"
                             " (forall (?b) (when (and (next ?a ?b) (marked ?b)) (lit ?b))))))",
                             "line")),
        problem(*parse_problem("(define (problem p) (:domain line) (:objects a b c d e)"
                               " (:init (next a b) (next b c) (next d e) (at a)) (:goal (lit c)))",
                               "line", domain)),
        compiled(domain),
        index(compiled) {
    index.restart(problem, budget);
  }
  Domain domain;
  Problem problem;
  CompiledDomain compiled;
  Budget budget;
  ProblemIndex index;
};

TEST(ReachableAtoms, AreNoMoreThanAPersonSees) {
  Line line;
  ReachableAtoms forwards(line.compiled);
  const AtomLists* const reachable = forwards.compute(line.index, kFirings, line.budget);
  ASSERT_NE(reachable, nullptr);
  EXPECT_EQ(reachable->size(), 3 + 3 + 2) << "at and marked a, b and c; lit b and c";
}

TEST(ReachableAtoms, EndWhereThereIsTooMuchOrTheyAreStopped) {
  Line line;
  EXPECT_EQ(ReachableAtoms(line.compiled).compute(line.index, 3, line.budget), nullptr);
  std::stop_source source;
  source.request_stop();
  Budget stopped(source.get_token(), {});
  stopped.check();
  EXPECT_EQ(ReachableAtoms(line.compiled).compute(line.index, kFirings, stopped), nullptr);
}

}  // namespace
}  // namespace goalnet::planner
