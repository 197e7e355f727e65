// The planner on its own domains and on other people's kind of domains: right costs, typed refusals, limits,
// cancelling.
#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "components/planner/household_goal.h"
#include "components/planner/planner.h"
#include "components/planner/validator.h"
#include "components/planner/world.h"

namespace goalnet::planner {
namespace {

using testing::HasSubstr;

std::string path(const std::string& relative) { return std::string(GOALNET_SOURCE_DIR) + "/" + relative; }

struct Known {
  const char* domain;
  const char* problem;
  std::int64_t cost;
};

class OtherDomains : public testing::TestWithParam<Known> {};

TEST_P(OtherDomains, AreSolvedOptimally) {
  const auto domain = load_domain(path(std::string("tests/data/pddl/") + GetParam().domain + ".pddl"));
  ASSERT_TRUE(domain) << domain.error().message;
  const auto problem =
      load_problem(path(std::string("tests/data/pddl/") + GetParam().problem + ".pddl"), *domain);
  ASSERT_TRUE(problem) << problem.error().message;
  Planner planner(*domain);
  const auto plan = planner.solve(*problem);
  ASSERT_TRUE(plan) << plan.error().message;
  EXPECT_TRUE(plan->optimal);
  EXPECT_EQ(plan->cost, GetParam().cost);
  const auto valid = validate(*problem, plan->actions);
  ASSERT_TRUE(valid) << valid.error().message;
  EXPECT_EQ(valid->cost, plan->cost);

  SolveOptions quick;
  quick.satisficing = true;
  const auto some = planner.solve(*problem, quick);
  ASSERT_TRUE(some) << some.error().message;
  EXPECT_TRUE(validate(*problem, some->actions));
  EXPECT_GE(some->cost, plan->cost);
  EXPECT_LE(some->lower_bound, plan->cost);
}

INSTANTIATE_TEST_SUITE_P(All, OtherDomains,
                         testing::Values(Known{"blocks", "blocks-8", 16}, Known{"gripper", "gripper-6", 17},
                                         Known{"logistics", "logistics-4", 48}, Known{"lift", "lift-5", 11},
                                         Known{"rovers", "rovers-2", 14},
                                         Known{"satellite", "satellite-3", 11}),
                         [](const auto& test) { return std::string(test.param.domain); });

class Household : public testing::Test {
 protected:
  void SetUp() override {
    auto loaded = load_domain(path("config/domains/household.pddl"));
    ASSERT_TRUE(loaded) << loaded.error().message;
    domain_ = std::move(*loaded);
    world_.objects = {"Robot",    "Mug_1", "Kettle",      "Coke_1",      "Plate_1",   "Plate_2",   "Sink",
                      "SinkKnob", "Stove", "StoveFire_1", "StoveFire_2", "Counter_1", "Microwave", "Fridge"};
    for (const char* item : {"Mug_1", "Kettle", "Coke_1", "Plate_1", "Plate_2"}) {
      world_.facts.insert({"IsGraspable", item, ""});
      world_.facts.insert({"On", item, "Counter_1"});
    }
  }

  // Plans, then carries the plan out with apply() and checks the goal.
  Expected<Plan> achieve(const Goal& goal) {
    Planner planner(domain_);
    auto plan = planner.solve(world_, goal);
    if (!plan) return plan;
    WorldState state = world_;
    for (const Action& action : plan->actions) {
      auto next = apply(domain_, state, action);
      EXPECT_TRUE(next) << next.error().message;
      if (!next) return plan;
      state.facts = std::move(*next);
      // Manipulation chooses a hand; the world then says which.
    }
    EXPECT_TRUE(satisfied(goal, state.facts));
    return plan;
  }

  Domain domain_;
  WorldState world_;
};

TEST_F(Household, EverydayGoals) {
  EXPECT_EQ(achieve({{{"On", "Mug_1", "Sink"}}, {}})->actions.size(), 4u);
  EXPECT_EQ(achieve({{{"state", "SinkKnob", "TapIsOn"}}, {}})->actions.size(), 2u);
  EXPECT_EQ(achieve({{{"state", "Mug_1", "Water"}, {"On", "Mug_1", "Sink"}}, {}})->actions.size(), 5u);
  // One hand holds the mug, the other opens the door.
  EXPECT_EQ(achieve({{{"In", "Mug_1", "Microwave"}}, {}})->actions.size(), 5u);
  EXPECT_EQ(achieve({{{"In", "Coke_1", "Fridge"}}, {}})->actions.size(), 5u);
  EXPECT_TRUE(achieve({{{"On", "Plate_1", "Sink"}, {"On", "Plate_2", "Sink"}}, {}})->optimal);
  EXPECT_TRUE(
      achieve(
          {{{"state", "Kettle", "Water"}, {"On", "Kettle", "StoveFire_1"}, {"state", "Stove", "StoveFire1"}},
           {}})
          ->optimal);
  EXPECT_TRUE(achieve({{{"Grasping", "Robot", "Mug_1"}}, {{"On", "Kettle", "Counter_1"}}})->optimal);
}

TEST_F(Household, AGoalAlreadyTrueIsAnEmptyPlan) {
  const auto plan = achieve({{{"On", "Mug_1", "Counter_1"}}, {{"On", "Mug_1", "Sink"}}});
  ASSERT_TRUE(plan);
  EXPECT_TRUE(plan->actions.empty());
  EXPECT_TRUE(plan->optimal);
}

TEST_F(Household, RefusalsSayWhy) {
  const auto refuse = [&](const Goal& goal) { return achieve(goal).error(); };
  const Error contradiction = refuse({{{"On", "Mug_1", "Sink"}}, {{"On", "Mug_1", "Sink"}}});
  EXPECT_EQ(contradiction.outcome, Outcome::kInvalidRequest);
  EXPECT_THAT(contradiction.message, HasSubstr("(On Mug_1 Sink) and (not (On Mug_1 Sink))"));
  const Error unknown = refuse({{{"On", "Mag_1", "Sink"}}, {}});
  EXPECT_EQ(unknown.outcome, Outcome::kUnknownObject);
  EXPECT_THAT(unknown.message, HasSubstr("did you mean Mug_1?"));
  EXPECT_EQ(refuse({{{"Onto", "Mug_1", "Sink"}}, {}}).outcome, Outcome::kInvalidRequest);
  EXPECT_THAT(refuse({{{"On", "Mug_1", ""}}, {}}).message, HasSubstr("takes 2 arguments, not 1"));
  const Error impossible = refuse({{{"Grasping", "Robot", "Sink"}}, {}});
  EXPECT_EQ(impossible.outcome, Outcome::kNoPlan);
  EXPECT_THAT(impossible.message, HasSubstr("(Grasping Robot Sink)"));
  const Error exclusive = refuse({{{"On", "Mug_1", "Sink"}, {"Grasping", "Robot", "Mug_1"}}, {}});
  EXPECT_EQ(exclusive.outcome, Outcome::kNoPlan);
}

TEST_F(Household, WhatIsTooLargeGoesElsewhereOrNowhere) {
  const Goal goal{{{"In", "Coke_1", "Fridge"}}, {}};
  const auto opens = [&](const char* door) {
    const auto plan = achieve(goal);
    return plan && std::find(plan->actions.begin(), plan->actions.end(), Action{"open", {door}}) !=
                       plan->actions.end();
  };
  for (const auto& [side, other_door] :
       {std::pair{"FridgeLeft", "FridgeRightDoor"}, {"FridgeRight", "FridgeLeftDoor"}}) {
    const WorldState before = world_;
    world_.facts.insert({"Unfit", "Coke_1", side});
    EXPECT_TRUE(opens(other_door)) << side;
    EXPECT_EQ(misfit(goal, world_.facts), "");
    world_ = before;
  }
  for (const char* place : {"Fridge", "FridgeLeft", "FridgeRight"})
    world_.facts.insert({"Unfit", "Coke_1", place});
  const auto plan = achieve(goal);
  ASSERT_FALSE(plan);
  EXPECT_EQ(plan.error().outcome, Outcome::kNoPlan);
  EXPECT_THAT(misfit(goal, world_.facts), HasSubstr("Coke_1 does not fit into Fridge"));
  EXPECT_THAT(misfit({{{"state", "Glass_1", "Ramen"}}, {}}, FactSet({{"Unfit", "Ramen_1", "Glass_1"}})),
              HasSubstr("Ramen_1 does not fit into Glass_1"));
}

TEST_F(Household, PreconditionsAreNamed) {
  const auto problem = applicable(domain_, world_, {"grasp", {"Mug_1"}});
  ASSERT_FALSE(problem);
  EXPECT_THAT(problem.error().message, HasSubstr("(Near Robot Mug_1) does not hold"));
  EXPECT_EQ(applicable(domain_, world_, {"fly", {"Mug_1"}}).error().outcome, Outcome::kInvalidRequest);
  EXPECT_TRUE(applicable(domain_, world_, {"moveto", {"Mug_1"}}));
}

TEST_F(Household, NearIsAMeans) {
  const auto goals = normalise_household_goal({{{"Near", "Robot", "Sink"}, {"On", "Mug_1", "Sink"}}, {}});
  ASSERT_EQ(goals.size(), 1u);
  EXPECT_EQ(goals[0].positive, (std::vector<Predicate>{{"On", "Mug_1", "Sink"}}));
  EXPECT_EQ(normalise_household_goal({{{"Near", "Robot", "Sink"}, {"Near", "Robot", "Stove"}}, {}}).size(),
            2u);
}

// The state of the recording that no planner may accept: two facts that exclude each other.
TEST(Benchmark, ExclusiveGoalsAreRecognised) {
  const auto domain = load_domain(path("config/domains/benchmark.pddl"));
  WorldState world{{"Robot", "Ramen_1", "Plate_2", "Sink"},
                   FactSet({{"IsGraspable", "Ramen_1", ""}, {"IsGraspable", "Plate_2", ""}})};
  const auto plan =
      Planner(*domain).solve(world, {{{"Grasping", "Robot", "Ramen_1"}, {"In", "Ramen_1", "Plate_2"}}, {}});
  ASSERT_FALSE(plan);
  EXPECT_EQ(plan.error().outcome, Outcome::kNoPlan);
  EXPECT_THAT(plan.error().message, HasSubstr("exclude each other"));
}

TEST(Classical, ExclusiveGoalsAreNamedHoweverLargeTheProblem) {
  const auto domain = load_domain(path("tests/data/pddl/blocks.pddl"));
  for (const int blocks : {4, 12}) {
    std::string objects, init = "(hand-empty)";
    for (int i = 0; i < blocks; ++i) {
      const std::string name = " b" + std::to_string(i);
      objects += name;
      init += " (on-table" + name + ") (clear" + name + ")";
    }
    const auto problem =
        parse_problem("(define (problem p) (:domain blocks) (:objects" + objects + " - block) (:init " +
                          init + ") (:goal (and (on b1 b0) (on b3 b2) (on b2 b0))))",
                      "p", *domain);
    ASSERT_TRUE(problem) << problem.error().message;
    const auto plan = solve(*domain, *problem);
    ASSERT_FALSE(plan);
    EXPECT_EQ(plan.error().outcome, Outcome::kNoPlan);
    EXPECT_THAT(plan.error().message, HasSubstr("(on b1 b0) and (on b2 b0) exclude each other")) << blocks;
  }
}

// Blocks world with fifty blocks: far too large for an optimal plan.
std::string towers(int blocks) {
  std::string objects, init = "(hand-empty)", goal;
  for (int i = 0; i < blocks; ++i) {
    const std::string name = "b" + std::to_string(i), next = "b" + std::to_string((i * 7 + 3) % blocks);
    objects += " " + name;
    init += i % 5 == 0 ? " (on-table " + name + ")" : " (on " + name + " b" + std::to_string(i - 1) + ")";
    if (i % 5 == 4 || i + 1 == blocks) init += " (clear " + name + ")";
    if (i + 1 < blocks)
      goal +=
          " (on b" + std::to_string((i * 7) % blocks) + " b" + std::to_string(((i + 1) * 7) % blocks) + ")";
  }
  return "(define (problem t) (:domain blocks) (:objects" + objects + " - block) (:init " + init +
         ") (:goal (and" + goal + ")))";
}

TEST(Limits, ATimeLimitGivesAPlanOrSaysSo) {
  const auto domain = load_domain(path("tests/data/pddl/blocks.pddl"));
  const auto problem = parse_problem(towers(24), "towers", *domain);
  ASSERT_TRUE(problem) << problem.error().message;
  SolveOptions options;
  options.time_limit = std::chrono::milliseconds(300);
  const auto start = std::chrono::steady_clock::now();
  const auto plan = solve(*domain, *problem, options);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::milliseconds(600));
  if (plan) {
    EXPECT_TRUE(validate(*problem, plan->actions));
    EXPECT_LE(plan->lower_bound, plan->cost);
  } else {
    EXPECT_EQ(plan.error().outcome, Outcome::kTimeLimit);
  }
}

TEST(Limits, CancelIsQuickAtAnyStage) {
  const auto domain = load_domain(path("tests/data/pddl/blocks.pddl"));
  const auto problem = parse_problem(towers(60), "towers", *domain);
  Planner planner(*domain);
  for (const int delay_us : {0, 200, 1000, 5000, 30'000}) {
    std::stop_source source;
    SolveOptions options;
    options.stop = source.get_token();
    std::chrono::steady_clock::time_point asked;
    std::jthread canceller([&] {
      std::this_thread::sleep_for(std::chrono::microseconds(delay_us));
      asked = std::chrono::steady_clock::now();
      source.request_stop();
    });
    const auto plan = planner.solve(*problem, options);
    const auto answered = std::chrono::steady_clock::now();
    canceller.join();
    ASSERT_FALSE(plan);
    EXPECT_EQ(plan.error().outcome, Outcome::kCancelled);
    // The promise is 5 ms; a loaded machine may add a time slice or two.
    EXPECT_LT(answered - asked, std::chrono::milliseconds(50));
  }
}

TEST(Limits, WhoStopsTheProofHasTheBestPlanSoFar) {
  const auto domain = load_domain(path("tests/data/pddl/qubits.pddl"));
  ASSERT_TRUE(domain) << domain.error().message;
  const auto problem = load_problem(path("tests/data/pddl/qubits-middle.pddl"), *domain);
  ASSERT_TRUE(problem) << problem.error().message;
  std::vector<Plan> told;
  std::stop_source source;
  SolveOptions options;
  options.stop = source.get_token();
  options.on_plan = [&](const Plan& plan) {
    told.push_back(plan);
    source.request_stop();
  };
  const auto plan = solve(*domain, *problem, options);
  ASSERT_FALSE(plan);
  EXPECT_EQ(plan.error().outcome, Outcome::kCancelled);
  ASSERT_EQ(told.size(), 1u);
  const auto valid = validate(*problem, told[0].actions);
  ASSERT_TRUE(valid) << valid.error().message;
  EXPECT_EQ(valid->cost, told[0].cost);
  EXPECT_LT(told[0].lower_bound, told[0].cost);
  EXPECT_FALSE(told[0].optimal);
}

TEST(Limits, AGoalWithTenThousandLiterals) {
  const auto domain = load_domain(path("config/domains/benchmark.pddl"));
  WorldState world{{"Robot", "Shelf_1"}, {}};
  std::vector<Predicate> facts;
  Goal goal;
  for (int i = 0; i < 10'000; ++i) {
    const std::string cup = "Cup_" + std::to_string(i);
    world.objects.push_back(cup);
    facts.push_back({"IsGraspable", cup, ""});
    goal.positive.push_back({"On", cup, "Shelf_1"});
  }
  world.facts = FactSet(std::move(facts));
  SolveOptions options;
  options.time_limit = std::chrono::seconds(1);
  const auto plan = Planner(*domain).solve(world, goal, options);
  if (!plan) {
    EXPECT_EQ(plan.error().outcome, Outcome::kTimeLimit);
  } else {
    EXPECT_GE(plan->actions.size(), 30'000u);
  }
}

}  // namespace
}  // namespace goalnet::planner
