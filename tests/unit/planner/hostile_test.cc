// Bad input of every kind: one clear message or a typed limit, in bounded time and memory. Also: cancelling
// at any moment.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pthread.h>

#include <chrono>
#include <cmath>
#include <ctime>
#include <random>
#include <thread>

#include "components/planner/planner.h"
#include "components/planner/validator.h"
#include "components/planner/world.h"

namespace goalnet::planner {
namespace {

using testing::HasSubstr;

std::string path(const std::string& relative) { return std::string(GOALNET_SOURCE_DIR) + "/" + relative; }

const char* const kDomain =
    "(define (domain d) (:requirements :adl) (:types cup table - object)\n"
    "(:predicates (on ?c - cup ?t - table) (clean ?c - cup))\n"
    "(:action put :parameters (?c - cup ?t - table) :effect (on ?c ?t))\n"
    "(:action wash :parameters (?c - cup) :effect (clean ?c)))";

Expected<Plan> solve_text(const std::string& objects, const std::string& init, const std::string& goal,
                          const SolveOptions& options = {}) {
  auto domain = parse_domain(kDomain, "d");
  if (!domain) return tl::unexpected(domain.error());
  auto problem = parse_problem(
      "(define (problem p) (:domain d) (:objects " + objects + ") (:init " + init + ") (:goal " + goal + "))",
      "p", *domain);
  if (!problem) return tl::unexpected(problem.error());
  auto plan = solve(*domain, *problem, options);
  if (plan && !validate(*problem, plan->actions)) return fail(Outcome::kInternal, "the plan is not valid");
  return plan;
}

std::string many(int count, const std::string& before, const std::string& after) {
  std::string text;
  for (int i = 0; i < count; ++i) text += before + std::to_string(i) + after;
  return text;
}

TEST(Hostile, AMillionObjectsAreNoReasonToThinkLong) {
  const auto plan =
      solve_text(many(1'000'000, " c", "") + " - cup t - table", "", "(and (on c7 t) (clean c999999))");
  ASSERT_TRUE(plan) << plan.error().message;
  EXPECT_EQ(plan->actions.size(), 2u);
  EXPECT_TRUE(plan->optimal);
}

TEST(Hostile, AMillionObjectsThatAllMatterEndInATypedLimit) {
  SolveOptions options;
  options.time_limit = std::chrono::milliseconds(500);
  options.memory_limit = 64 << 20;
  const auto plan = solve_text(many(1'000'000, " c", "") + " - cup t - table", "",
                               "(forall (?c - cup) (clean ?c))", options);
  ASSERT_FALSE(plan);
  EXPECT_TRUE(plan.error().outcome == Outcome::kTimeLimit || plan.error().outcome == Outcome::kStepLimit)
      << plan.error().message;
}

TEST(Hostile, TenThousandLiterals) {
  SolveOptions options;
  options.satisficing = true;
  const auto plan = solve_text(many(10'000, " c", "") + " - cup t - table", "",
                               "(and" + many(10'000, " (clean c", ")") + ")", options);
  ASSERT_TRUE(plan) << plan.error().message;
  EXPECT_EQ(plan->actions.size(), 10'000u);
  const auto impossible = solve_text(many(10'000, " c", "") + " - cup t - table", "",
                                     "(and" + many(10'000, " (clean c", ")") + " (not (clean c77)))");
  ASSERT_FALSE(impossible);
  EXPECT_EQ(impossible.error().outcome, Outcome::kNoPlan);
  EXPECT_THAT(impossible.error().message, HasSubstr("(clean c77) and (not (clean c77))"));
}

TEST(Hostile, DeepNestingInAGoal) {
  std::string deep;
  for (int i = 0; i < 100'000; ++i) deep += "(not ";
  const auto plan = solve_text("c - cup", "", deep);
  ASSERT_FALSE(plan);
  EXPECT_THAT(plan.error().message, HasSubstr("more than 400 nested"));
  // As deep as allowed: understood, and right.
  std::string nested = "(clean c)";
  for (int i = 0; i < 300; ++i) nested = "(not " + nested + ")";
  const auto right = solve_text("c - cup", "", nested);
  ASSERT_TRUE(right) << right.error().message;
  EXPECT_EQ(right->actions.size(), 1u);
}

// Each disjunction doubles what multiplying out would give.
TEST(Hostile, DisjunctionsAreNotMultipliedOut) {
  std::string goal = "(and";
  for (int i = 0; i < 60; ++i)
    goal += " (or (clean c" + std::to_string(i) + ") (on c" + std::to_string(i) + " t))";
  SolveOptions options;
  options.satisficing = true;
  const auto plan = solve_text(many(60, " c", "") + " - cup t - table", "", goal + ")", options);
  ASSERT_TRUE(plan) << plan.error().message;
  EXPECT_EQ(plan->actions.size(), 60u);
}

TEST(Hostile, ActionsWithManyParametersEndInATypedLimit) {
  std::string parameters, condition;
  for (int i = 0; i < 12; ++i) {
    parameters += " ?x" + std::to_string(i);
    condition += " (p ?x" + std::to_string(i) + ")";
  }
  const auto domain = parse_domain("(define (domain d) (:predicates (p ?x) (q)) (:action a :parameters (" +
                                       parameters + ") :precondition (and" + condition +
                                       ") :effect (q))"
                                       "(:action b :parameters (?x ?y) :precondition (p ?y) :effect (p ?x)))",
                                   "d");
  ASSERT_TRUE(domain) << domain.error().message;
  const auto problem = parse_problem(
      "(define (problem p) (:domain d) (:objects" + many(30, " o", "") + ") (:init (p o1)) (:goal (q)))", "p",
      *domain);
  ASSERT_TRUE(problem) << problem.error().message;
  SolveOptions options;
  options.time_limit = std::chrono::seconds(1);
  const auto plan = solve(*domain, *problem, options);
  if (plan) {
    EXPECT_TRUE(validate(*problem, plan->actions));
  } else {
    EXPECT_TRUE(plan.error().outcome == Outcome::kTimeLimit || plan.error().outcome == Outcome::kStepLimit)
        << plan.error().message;
  }
}

TEST(Hostile, GarbageIsRefusedWithAPlace) {
  std::mt19937_64 random(1);
  const std::string alphabet = "()?-:;= abcdefdefineproblemdomain\n\t\"\\\x01\xff";
  for (int i = 0; i < 2000; ++i) {
    std::string text = i % 2 == 0 ? "" : "(define (domain d) (:predicates (p ?x))";
    const int length = static_cast<int>(random() % 200);
    for (int k = 0; k < length; ++k) text += alphabet[random() % alphabet.size()];
    const auto domain = parse_domain(text, "garbage.pddl");
    if (domain) continue;
    EXPECT_EQ(domain.error().outcome, Outcome::kInvalidRequest);
    EXPECT_THAT(domain.error().message, testing::ContainsRegex("^garbage.pddl:[0-9]+:[0-9]+: "));
    EXPECT_LT(domain.error().message.size(), 400u) << domain.error().message;
  }
}

// Every prefix of a good file, and every file with one character gone, is refused or understood, never worse.
TEST(Hostile, DamagedFiles) {
  const std::string good = kDomain;
  for (std::size_t i = 0; i < good.size(); ++i) {
    EXPECT_FALSE(parse_domain(good.substr(0, i), "d")) << i;
    std::string damaged = good;
    damaged.erase(i, 1);
    (void)parse_domain(damaged, "d");
  }
}

TEST(Hostile, AProblemForAnotherDomain) {
  const auto one = parse_domain(kDomain, "d");
  const auto other = parse_domain(kDomain, "d");
  const auto problem =
      parse_problem("(define (problem p) (:domain d) (:objects c - cup) (:goal (clean c)))", "p", *one);
  ASSERT_TRUE(problem);
  const auto plan = Planner(*other).solve(*problem);
  ASSERT_FALSE(plan);
  EXPECT_EQ(plan.error().outcome, Outcome::kInvalidRequest);
}

// The CPU time that the searching thread uses after it was told to stop, at random moments from the first
// microseconds on: wall time would measure what else the machine does. The promise is 5 ms.
TEST(Cancelling, IsQuickAtAnyMoment) {
  const auto domain = load_domain(path("config/domains/benchmark.pddl"));
  ASSERT_TRUE(domain) << domain.error().message;
  const auto crowd = [](int cups, int wanted, const char* relation) {
    WorldState world{
        {"Robot", "Shelf_1", "Sink", "SinkKnob", "Stove", "Microwave", "StoveFire_1", "StoveFire_2"}, {}};
    std::vector<Predicate> facts;
    Goal goal;
    for (int i = 0; i < cups; ++i) {
      const std::string cup = "Mug_" + std::to_string(i + 1);
      world.objects.push_back(cup);
      facts.push_back({"IsGraspable", cup, ""});
      if (i < wanted) {
        goal.positive.push_back(std::string(relation) == "On" ? Predicate{"On", cup, "Shelf_1"}
                                                              : Predicate{"state", cup, relation});
      }
    }
    world.facts = FactSet(std::move(facts));
    return std::pair{world, goal};
  };
  std::mt19937_64 random(7);
  double worst = 0.0;
  int cancelled = 0;
  for (const auto& [world, goal] :
       {crowd(12, 12, "temperatureHigh"), crowd(2000, 30, "Water"), crowd(3000, 2000, "On")}) {
    const auto problem = make_problem(*domain, world, goal);
    ASSERT_TRUE(problem) << problem.error().message;
    Planner planner(*domain);
    for (int i = 0; i < 12; ++i) {
      const double delay_us = 10.0 * std::pow(10.0, 4.0 * static_cast<double>(random() % 1000) / 1000.0);
      std::stop_source source;
      SolveOptions options;
      options.stop = source.get_token();
      clockid_t clock{};
      ASSERT_EQ(pthread_getcpuclockid(pthread_self(), &clock), 0);
      const auto used_us = [clock] {
        timespec now{};
        clock_gettime(clock, &now);
        return static_cast<double>(now.tv_sec) * 1e6 + static_cast<double>(now.tv_nsec) / 1e3;
      };
      double asked = 0.0;
      std::thread canceller([&] {
        std::this_thread::sleep_for(std::chrono::duration<double, std::micro>(delay_us));
        asked = used_us();
        source.request_stop();
      });
      const auto plan = planner.solve(*problem, options);
      const double answered = used_us();
      canceller.join();
      if (plan) continue;  // it was quicker
      ASSERT_EQ(plan.error().outcome, Outcome::kCancelled) << plan.error().message;
      worst = std::max(worst, answered - asked);
      ++cancelled;
    }
  }
  EXPECT_GT(cancelled, 10);
  std::cout << cancelled << " cancelled, the slowest after " << worst << " us\n";
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  EXPECT_LT(worst, 20'000.0);  // four times the promise, for slow machines
#endif
}

}  // namespace
}  // namespace goalnet::planner
