// Dead ends found backwards from the goal: right on random problems, where every state is looked at, and
// found where a person sees them.
#include "components/planner/dead_pairs.h"

#include <gtest/gtest.h>

#include <iostream>
#include <map>

#include "components/planner/grounder.h"
#include "components/planner/normal_form.h"
#include "tests/unit/planner/random_problems.h"

namespace goalnet::planner {
namespace {

struct Grounded {
  Grounded(const Domain& domain, const Problem& problem)
      : compiled(domain), index(compiled), slots(problem.goal_slots) {
    index.restart(problem, budget);
    const Formula goal = Normaliser(domain, slots, arena).normalise(problem.goal);
    usable = Grounder(compiled).ground(index, goal, slots, budget, task) == Grounder::Result::kDone &&
             !task.goal_impossible;
    if (!usable) return;
    PairReachability forwards;
    forwards.compute(task, budget);
    dead.compute(task, forwards, budget);
  }
  CompiledDomain compiled;
  Budget budget;
  ProblemIndex index;
  Arena arena;
  std::vector<TypeSet> slots;
  GroundTask task;
  DeadPairs dead;
  bool usable = false;
};

// Every state that can be reached, up to a number: whether it is called dead must not be so if a goal state
// can be reached from it. Returns how many were called dead.
int check_all_states(const Grounded& grounded) {
  constexpr std::size_t kMostStates = 3000;
  const GroundTask& task = grounded.task;
  std::vector<std::vector<Word>> states(1);
  std::map<std::vector<Word>, std::size_t> known;
  std::vector<std::vector<std::size_t>> before(1);
  Budget budget;
  initial_state(task, budget, &states[0]);
  known[states[0]] = 0;
  std::vector<bool> called_dead = {grounded.dead.dead(states[0].data())};
  for (std::size_t i = 0; i < states.size() && states.size() < kMostStates; ++i) {
    for (const GroundAction& action : task.actions) {
      if (!action_applies(task, states[i].data(), action)) continue;
      std::vector<Word> next(states[i].size());
      apply_action(task, states[i].data(), action, next.data());
      const auto [place, is_new] = known.emplace(next, states.size());
      if (is_new) {
        called_dead.push_back(grounded.dead.dead(next.data()));
        if (!called_dead[i]) {
          EXPECT_EQ(grounded.dead.dead_after(task, action, next.data()), called_dead.back());
        }
        states.push_back(std::move(next));
        before.emplace_back();
      }
      before[place->second].push_back(i);
    }
  }
  std::vector<bool> alive(states.size(), false);
  std::vector<std::size_t> open;
  const auto reach = [&](std::size_t i) {
    if (alive[i]) return;
    alive[i] = true;
    open.push_back(i);
  };
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (all_hold(task, states[i].data(), task.goal)) reach(i);
  }
  while (!open.empty()) {
    const std::size_t i = open.back();
    open.pop_back();
    for (const std::size_t j : before[i]) reach(j);
  }
  int dead = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    EXPECT_FALSE(alive[i] && called_dead[i]) << "the goal can be reached from state " << i;
    dead += called_dead[i] ? 1 : 0;
  }
  return dead;
}

TEST(DeadPairs, NeverCondemnAStateThatLeadsToTheGoal) {
  int usable = 0, dead = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    const RandomText text = random_problem(seed, false);
    const auto domain = parse_domain(text.domain, "random");
    ASSERT_TRUE(domain) << domain.error().message;
    auto problem = parse_problem(text.problem, "random", *domain);
    ASSERT_TRUE(problem) << problem.error().message;
    if (seed % 4 != 0) set_reachable_goal(seed, 12, *problem);
    const Grounded grounded(*domain, *problem);
    if (!grounded.usable) continue;
    ++usable;
    dead += check_all_states(grounded);
  }
  EXPECT_GT(usable, 100);
  EXPECT_GT(dead, 0);
  std::cout << dead << " dead ends found in " << usable << " problems\n";
}

// A painter in a column paints the cell above and cannot enter what is painted: whoever paints a cell before
// those above it never gets there.
TEST(DeadPairs, SeeACellPaintedTooEarly) {
  const auto domain = parse_domain(
      "(define (domain column) (:predicates (above ?a ?b) (at ?a) (free ?a) (painted ?a))"
      "(:action up :parameters (?a ?b) :precondition (and (above ?b ?a) (at ?a) (free ?b))"
      " :effect (and (at ?b) (not (at ?a)) (free ?a) (not (free ?b))))"
      "(:action down :parameters (?a ?b) :precondition (and (above ?a ?b) (at ?a) (free ?b))"
      " :effect (and (at ?b) (not (at ?a)) (free ?a) (not (free ?b))))"
      "(:action paint :parameters (?a ?b) :precondition (and (above ?b ?a) (at ?a) (free ?b))"
      " :effect (and (painted ?b) (not (free ?b)))))",
      "column");
  ASSERT_TRUE(domain) << domain.error().message;
  const auto problem = parse_problem(
      "(define (problem p) (:domain column) (:objects a b c d) (:init (above b a) (above c b) (above d c)"
      " (at a) (free b) (free c) (free d)) (:goal (and (painted b) (painted c) (painted d))))",
      "column", *domain);
  ASSERT_TRUE(problem) << problem.error().message;
  const Grounded grounded(*domain, *problem);
  ASSERT_TRUE(grounded.usable);
  // b painted too early with c free, or c with d free, the painter being anywhere below or at b.
  EXPECT_GE(check_all_states(grounded), 4);
}

}  // namespace
}  // namespace goalnet::planner
