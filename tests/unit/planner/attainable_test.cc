// What can never come true is known before anything is ground; what is said to be impossible is.
#include "components/planner/attainable.h"

#include <gtest/gtest.h>

#include "components/planner/planner.h"

namespace goalnet::planner {
namespace {

// Only what is light can be lifted, only what was lifted can be painted, only what is painted can be shown.
constexpr const char* kGallery = R"((define (domain gallery) (:requirements :strips :negative-preconditions)
  (:predicates (light ?x) (held ?x) (painted ?x) (shown ?x) (dusty ?x) (egg ?x) (hen ?x))
  (:action lift :parameters (?x) :precondition (light ?x) :effect (held ?x))
  (:action paint :parameters (?x) :precondition (held ?x) :effect (painted ?x))
  (:action show :parameters (?x) :precondition (and (painted ?x) (not (dusty ?x))) :effect (shown ?x))
  (:action dust :parameters (?x) :precondition (held ?x) :effect (not (dusty ?x)))
  (:action lay :parameters (?x) :precondition (hen ?x) :effect (egg ?x))
  (:action hatch :parameters (?x) :precondition (egg ?x) :effect (hen ?x))))";

class AttainableTest : public testing::Test {
 protected:
  AttainableTest()
      : domain_(parse_domain(kGallery, "gallery").value()),
        problem_(parse_problem("(define (problem p) (:domain gallery) (:objects cup rock) (:init (light cup) "
                               "(dusty cup) (dusty rock)) (:goal (shown cup)))",
                               "p", domain_)
                     .value()),
        compiled_(domain_),
        index_(compiled_),
        attainable_(compiled_) {
    index_.restart(problem_, budget_);
    attainable_.restart(index_, budget_);
  }
  bool can_hold(const std::string& predicate, const std::string& object, bool negative = false) {
    LiteralPattern literal;
    literal.atom.predicate = domain_.predicates.find(predicate);
    literal.atom.arguments = {Term::object(problem_.find_object(object))};
    literal.negative = negative;
    return attainable_.can_hold(std::span(&literal, 1), nullptr);
  }

  Domain domain_;
  Problem problem_;
  CompiledDomain compiled_;
  Budget budget_;
  ProblemIndex index_;
  Attainable attainable_;
};

TEST_F(AttainableTest, LooksSeveralActionsBack) {
  for (const char* predicate : {"held", "painted", "shown"}) {
    EXPECT_TRUE(can_hold(predicate, "cup")) << predicate;
    EXPECT_FALSE(can_hold(predicate, "rock")) << predicate;
  }
}

TEST_F(AttainableTest, AlsoWhatMustNotHold) {
  EXPECT_TRUE(can_hold("dusty", "cup", true));
  EXPECT_FALSE(can_hold("dusty", "rock", true));
  EXPECT_TRUE(can_hold("shown", "rock", true)) << "it is not shown at first";
}

TEST_F(AttainableTest, WhatOnlyFollowsFromItselfIsLeftOpen) {
  EXPECT_TRUE(can_hold("egg", "cup")) << "\"no\" must be certain, \"yes\" need not be";
}

// Actions that nobody can ever carry out are not ground: rocks cost nothing.
TEST(Attainability, KeepsTheTaskSmall) {
  const auto domain = parse_domain(R"((define (domain hall) (:requirements :strips :negative-preconditions)
    (:predicates (light ?x) (held ?x) (free) (placed ?x))
    (:action lift :parameters (?x) :precondition (and (light ?x) (free)) :effect (and (held ?x) (not (free))))
    (:action place :parameters (?x) :precondition (held ?x) :effect (and (placed ?x) (free) (not (held ?x))))))",
                                   "hall");
  ASSERT_TRUE(domain) << domain.error().message;
  std::string objects;
  for (int i = 0; i < 100; ++i) objects += " rock" + std::to_string(i);
  const auto problem =
      parse_problem("(define (problem p) (:domain hall) (:objects cup mug" + objects +
                        ") (:init (light cup) (light mug) (free)) (:goal (and (placed cup) (placed mug))))",
                    "p", *domain);
  ASSERT_TRUE(problem) << problem.error().message;
  const auto plan = solve(*domain, *problem);
  ASSERT_TRUE(plan) << plan.error().message;
  EXPECT_EQ(plan->cost, 4);
  EXPECT_TRUE(plan->optimal);
  EXPECT_EQ(plan->statistics.ground_actions, 4);
}

}  // namespace
}  // namespace goalnet::planner
