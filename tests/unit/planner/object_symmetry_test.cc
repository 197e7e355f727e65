// Interchangeable objects are found, and only those.
#include <gtest/gtest.h>

#include "components/planner/planner.h"
#include "components/planner/validator.h"

namespace goalnet::planner {
namespace {

const char* const kMinimal =
    "(define (domain nuts) (:requirements :typing)\n"
    "(:types spanner nut place)\n"
    "(:predicates (at ?s - spanner ?p - place) (held ?s - spanner) (used ?s - spanner) (tight ?n - nut)\n"
    " (here ?p - place) (link ?a ?b - place) (fits ?s - spanner ?n - nut))\n"
    "(:action walk :parameters (?a ?b - place) :precondition (and (here ?a) (link ?a ?b))\n"
    " :effect (and (not (here ?a)) (here ?b)))\n"
    "(:action take :parameters (?s - spanner ?p - place) :precondition (and (at ?s ?p) (here ?p))\n"
    " :effect (and (not (at ?s ?p)) (held ?s)))\n"
    "(:action turn :parameters (?s - spanner ?n - nut) :precondition (and (held ?s) (fits ?s ?n) (not (used "
    "?s)) (here gate))\n"
    " :effect (and (tight ?n) (used ?s)))";

// `spanners` of them lie on the way to the gate, where as many nuts wait; the first fits only the first nut
// if `odd`. Not all can be left behind, and which of them is used for which nut does not matter.
Expected<Plan> solve_nuts(int spanners, bool odd) {
  std::string text = kMinimal;
  text.insert(text.find("(:predicates"), "(:constants gate - place)\n");
  const auto domain = parse_domain(text + ")", "nuts");
  if (!domain) return tl::unexpected(domain.error());
  std::string objects, init = "(here p0) (link p0 gate)", goal;
  for (int i = 0; i < spanners; ++i) {
    const std::string number = std::to_string(i);
    objects += " s" + number + " - spanner n" + number + " - nut";
    init += " (at s" + number + " p0)";
    goal += " (tight n" + number + ")";
    for (int n = 0; n < spanners; ++n) {
      if (!odd || i != 0 || n == 0) init += " (fits s" + number + " n" + std::to_string(n) + ")";
    }
  }
  const auto problem = parse_problem("(define (problem p) (:domain nuts) (:objects p0 - place" + objects +
                                         ") (:init " + init + ") (:goal (and" + goal + ")))",
                                     "p", *domain);
  if (!problem) return tl::unexpected(problem.error());
  SolveOptions options;
  options.satisficing = true;
  auto plan = solve(*domain, *problem, options);
  if (plan) {
    const auto valid = validate(*problem, plan->actions);
    if (!valid) return tl::unexpected(valid.error());
  }
  return plan;
}

TEST(ObjectSymmetry, MakesUsedUpToolsCheap) {
  const auto plan = solve_nuts(9, false);
  ASSERT_TRUE(plan) << plan.error().message;
  EXPECT_EQ(plan->actions.size(), 19u);
  // Without it there are 2^9 ways to be halfway, and ten thousands of states are made.
  EXPECT_GE(plan->statistics.symmetries, 18);
  EXPECT_LT(plan->statistics.generated, 40'000);
}

TEST(ObjectSymmetry, TellsApartWhatDiffers) {
  const auto plan = solve_nuts(6, true);
  ASSERT_TRUE(plan) << plan.error().message;
  EXPECT_EQ(plan->actions.size(), 13u);
}

}  // namespace
}  // namespace goalnet::planner
