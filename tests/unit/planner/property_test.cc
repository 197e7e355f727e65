// Thousands of random small problems: the planner's plans are valid and as cheap as those of breadth-first
// search, and it says "no plan" exactly where that finds none.
#include <gtest/gtest.h>

#include <cstdlib>

#include "components/planner/planner.h"
#include "components/planner/validator.h"
#include "tests/unit/planner/random_problems.h"

namespace goalnet::planner {
namespace {

struct Tally {
  int solved = 0, unsolvable = 0, long_plans = 0, gave_up = 0;
};

void compare(std::uint64_t seed, bool with_costs, Tally* tally) {
  const RandomText text = random_problem(seed, with_costs);
  const auto context = [&] {
    return "seed " + std::to_string(seed) + "\n" + text.domain + "\n" + text.problem;
  };
  const auto domain = parse_domain(text.domain, "random domain");
  ASSERT_TRUE(domain) << domain.error().message << "\n" << context();
  auto problem = parse_problem(text.problem, "random problem", *domain);
  ASSERT_TRUE(problem) << problem.error().message << "\n" << context();
  if (seed % 4 != 0) set_reachable_goal(seed, 12, *problem);
  const Reference reference = breadth_first(*problem, 600);
  if (reference.gave_up) {
    ++tally->gave_up;
    return;
  }
  const auto plan = solve(*domain, *problem);
  if (!reference.solvable) {
    ++tally->unsolvable;
    ASSERT_FALSE(plan) << context();
    ASSERT_EQ(plan.error().outcome, Outcome::kNoPlan) << plan.error().message << context();
    return;
  }
  ASSERT_TRUE(plan) << plan.error().message << "\n" << context();
  const auto valid = validate(*problem, plan->actions);
  ASSERT_TRUE(valid) << valid.error().message << "\n" << context();
  ASSERT_EQ(valid->cost, plan->cost) << context();
  ASSERT_EQ(plan->cost, reference.cost) << plan->statistics.method << "\n" << context();
  ASSERT_TRUE(plan->optimal) << context();
  if (seed % 8 == 0) {  // the other searches: any valid plan
    SolveOptions quick;
    quick.satisficing = true;
    const auto some = solve(*domain, *problem, quick);
    ASSERT_TRUE(some) << some.error().message << "\n" << context();
    ASSERT_TRUE(validate(*problem, some->actions)) << some->statistics.method << "\n" << context();
    ASSERT_GE(some->cost, reference.cost) << context();
    ASSERT_LE(some->lower_bound, reference.cost) << context();
  }
  ++tally->solved;
  tally->long_plans += plan->actions.size() >= 3 ? 1 : 0;
}

// GOALNET_RANDOM_PROBLEMS and GOALNET_RANDOM_SEED make a campaign of it.
int problem_count() {
  const char* wanted = std::getenv("GOALNET_RANDOM_PROBLEMS");
  return wanted == nullptr ? 1500 : std::atoi(wanted);
}

std::uint64_t first_seed() {
  const char* wanted = std::getenv("GOALNET_RANDOM_SEED");
  return wanted == nullptr ? 0 : std::strtoull(wanted, nullptr, 10);
}

TEST(RandomProblems, PlansAreAsShortAsBreadthFirst) {
  Tally tally;
  for (int seed = 0; seed < problem_count(); ++seed) {
    compare(first_seed() + static_cast<std::uint64_t>(seed), false, &tally);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(tally.solved, problem_count() / 5);
  EXPECT_GT(tally.long_plans, problem_count() / 100);
  EXPECT_GT(tally.unsolvable, problem_count() / 20);
  std::cout << tally.solved << " solved (" << tally.long_plans << " with 3 actions and more), "
            << tally.unsolvable << " without a plan, " << tally.gave_up << " too large to compare\n";
}

TEST(RandomProblems, PlansAreAsCheapAsUniformCostSearch) {
  Tally tally;
  for (int seed = 0; seed < problem_count() / 2; ++seed) {
    compare(first_seed() + 1'000'000 + static_cast<std::uint64_t>(seed), true, &tally);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(tally.solved, problem_count() / 10);
  std::cout << tally.solved << " solved (" << tally.long_plans << " with 3 actions and more), "
            << tally.unsolvable << " without a plan, " << tally.gave_up << " too large to compare\n";
}

}  // namespace
}  // namespace goalnet::planner
