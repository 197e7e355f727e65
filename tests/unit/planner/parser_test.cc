// Every kind of slip in PDDL gives one message with file, line and column.
#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>

#include "components/planner/domain.h"
#include "components/planner/problem.h"

namespace goalnet::planner {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const char* const kRoom =
    "(define (domain room) (:requirements :adl :action-costs)\n"
    "(:types cup table - thing)\n"
    "(:constants desk - table)\n"
    "(:predicates (on ?c - cup ?t - table) (clean ?x - thing))\n"
    "(:functions (total-cost) - number)\n"
    "(:action put :parameters (?c - cup ?t - table)\n"
    " :precondition (not (on ?c ?t)) :effect (and (on ?c ?t) (increase (total-cost) 2))))";

std::string domain_error(const std::string& text) {
  const auto domain = parse_domain(text, "room.pddl");
  if (domain) return "parsed";
  EXPECT_EQ(domain.error().outcome, Outcome::kInvalidRequest);
  EXPECT_THAT(domain.error().message, StartsWith("room.pddl:"));
  return domain.error().message;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(DomainParser, ReadsAWholeDomain) {
  const auto domain = parse_domain(kRoom, "room.pddl");
  ASSERT_TRUE(domain) << domain.error().message;
  EXPECT_EQ(domain->actions.size(), 1u);
  EXPECT_EQ(domain->actions[0].cost.constant, 2);
  EXPECT_TRUE(domain->is_a(domain->types.find("CUP"), domain->types.find("thing")));
}

TEST(DomainParser, NamesWhatIsWrongAndWhere) {
  const auto with = [](const char* from, const char* to) { return domain_error(replaced(kRoom, from, to)); };
  EXPECT_THAT(with(":adl", ":durative-actions"),
              HasSubstr("1:38: requirement ':durative-actions' is not supported"));
  EXPECT_THAT(with(":adl", ":preferences"), HasSubstr("':preferences' is not supported"));
  EXPECT_THAT(domain_error("(define (domain d) (:requirements :numeric-fluents) (:predicates (p)))"),
              HasSubstr("1:35: requirement ':numeric-fluents' is not supported"));
  EXPECT_THAT(with("(not (on ?c ?t))", "(not (onn ?c ?t))"),
              HasSubstr("7:22: unknown predicate 'onn' (did you mean on?)"));
  EXPECT_THAT(with("(not (on ?c ?t))", "(not (on ?c))"), HasSubstr("'on' takes 2 arguments, not 1"));
  EXPECT_THAT(with("(not (on ?c ?t))", "(not (on ?t ?c))"), HasSubstr("must be a cup, not a table"));
  EXPECT_THAT(with("(not (on ?c ?t))", "(not (on ?c ?z))"), HasSubstr("variable '?z' is not bound"));
  EXPECT_THAT(with("(not (on ?c ?t))", "(not (on ?c dusk))"),
              HasSubstr("unknown constant 'dusk' (did you mean desk?)"));
  EXPECT_THAT(with("(not (on ?c ?t))", "(> (on ?c ?t) 3)"), HasSubstr(":numeric-fluents"));
  EXPECT_THAT(with("- thing)\n", "- thing thing - cup)\n"), HasSubstr("cycle"));
  EXPECT_THAT(with("desk - table", "desk - tabel"), HasSubstr("unknown type 'tabel' (did you mean table?)"));
  EXPECT_THAT(with("desk - table", "desk desk - table"), HasSubstr("declared twice"));
  EXPECT_THAT(with("(clean ?x - thing)", "(on ?x - thing)"), HasSubstr("predicate 'on' is declared twice"));
  EXPECT_THAT(with("(total-cost) 2", "(total-cost) -2"), HasSubstr("whole number"));
  EXPECT_THAT(with("(increase", "(assign"), HasSubstr("not supported"));
  EXPECT_THAT(with(":action put", ":durative-action put"), HasSubstr("durative actions"));
  EXPECT_THAT(with("(define (domain", "(define (problem"), HasSubstr("swapped"));
  EXPECT_THAT(with("2))))", "2)))"), HasSubstr("is a ')' missing?"));
  EXPECT_THAT(with("2))))", "2)))))"), HasSubstr("nothing may follow"));
  EXPECT_THAT(with("desk - table", "de\x01sk - table"), HasSubstr("the byte 1"));
  EXPECT_THAT(domain_error(""), HasSubstr("1:1: expected '('"));
  EXPECT_THAT(domain_error("(define (domain a) (:derived (p) (p)))"), HasSubstr("unknown predicate"));
  EXPECT_THAT(
      domain_error("(define (domain a) (:predicates (p) (q)) (:derived (p) (q)) (:derived (q) (not (p))))"),
      HasSubstr("'q' depends on its own opposite"));
  EXPECT_THAT(with("- thing)\n", "- thing cup - thing)\n"), HasSubstr("type 'cup' is declared twice"));
}

// What real competition files contain, each seen in one of them.
TEST(DomainParser, TakesWhatPeopleWrite) {
  const auto parses = [](const std::string& text) {
    const auto domain = parse_domain(text, "d");
    return domain ? "parsed" : domain.error().message;
  };
  // A type with two parents, declared twice; a type that is only named as a parent; "object" itself.
  EXPECT_EQ(parses("(define (domain d) (:types place area - object storearea - area area crate - surface))"),
            "parsed");
  EXPECT_EQ(parses("(define (domain d) (:types object a b - c))"), "parsed");
  EXPECT_EQ(
      parses("(DEFINE (DOMAIN D) (:REQUIREMENTS :STRIPS :ADL :Quantified-Preconditions :DERIVED-PREDICATES)"
             "(:PREDICATES (P ?X) (q ?x)) (:ACTION A :PARAMETERS (?X) :PRECONDITION (p ?x) :EFFECT (Q ?x)))"),
      "parsed");
  EXPECT_EQ(
      parses("(define (domain d) (:predicates (p) (q)) (:action a :effect (p)) (:action b :parameters ()"
             " :precondition () :effect (and (not (p)) (q))) (:action c :parameters () :precondition (and)"
             " :effect (and)))"),
      "parsed");
  EXPECT_EQ(
      parses(
          "(define (domain d) (:types a b) (:predicates (at ?x - (either a b) ?y)) (:functions (total-cost)"
          " - number (dist ?x ?y - a) - number) (:action m :parameters (?x ?y - a) :precondition"
          " (forall (?z - b) (imply (at ?z ?x) (exists (?w - a) (and (not (= ?w ?x)) (at ?z ?w)))))"
          " :effect (and (forall (?z - b) (when (at ?z ?x) (and (not (at ?z ?x)) (at ?z ?y))))"
          " (increase (total-cost) (dist ?x ?y)))))"),
      "parsed");
  EXPECT_EQ(parses("(define (domain d) (:predicates (on ?x ?y) (above ?x ?y)) (:derived (above ?x ?y)"
                   " (or (on ?x ?y) (exists (?z) (and (on ?x ?z) (above ?z ?y))))))"),
            "parsed");
}

// Before there was :action-costs, who wanted a total-cost asked for numbers.
TEST(DomainParser, TakesTheNumbersOfPlanCosts) {
  for (const char* requirement : {":fluents", ":numeric-fluents"}) {
    const auto domain = parse_domain(replaced(kRoom, ":adl", requirement), "d");
    EXPECT_TRUE(domain) << domain.error().message;
  }
}

TEST(DomainParser, IgnoresTheByteOrderMark) {
  const std::string mark = "\xEF\xBB\xBF";
  const auto domain = parse_domain(mark + kRoom, "d");
  ASSERT_TRUE(domain) << domain.error().message;
  const auto problem = parse_problem(
      mark + "(define (problem p) (:domain room) (:objects 7 - cup) (:goal (on 7 desk)))", "p", *domain);
  ASSERT_TRUE(problem) << problem.error().message;
  EXPECT_EQ(problem->object_name(problem->find_object("7")), "7");
  EXPECT_THAT(domain_error(mark + "(define (domain d)"), HasSubstr("1:19:"));
  EXPECT_THAT(domain_error("(define (domain d) (:action 7 :effect ()))"), HasSubstr("start with a letter"));
}

TEST(DomainParser, SurvivesHostileText) {
  const std::string deep(200'000, '(');
  EXPECT_THAT(domain_error(deep), HasSubstr("expected"));
  std::string nested = "(define (domain a) (:predicates (p)) (:action x :precondition ";
  for (int i = 0; i < 100'000; ++i) nested += "(not ";
  EXPECT_THAT(domain_error(nested), HasSubstr("nested"));
  std::string chain = "(define (domain a) (:types";
  for (int i = 0; i < 20'000; ++i) chain += " t" + std::to_string(i) + " - t" + std::to_string(i + 1);
  EXPECT_THAT(domain_error(chain + "))"), HasSubstr("more than 4096 types"));
}

std::string problem_error(const std::string& text) {
  const auto domain = parse_domain(kRoom, "room.pddl");
  const auto problem = parse_problem(text, "p.pddl", *domain);
  if (problem) return "parsed";
  EXPECT_THAT(problem.error().message, StartsWith("p.pddl:"));
  return problem.error().message;
}

TEST(ProblemParser, NamesWhatIsWrongAndWhere) {
  const std::string good =
      "(define (problem p) (:domain room) (:objects mug - cup)\n(:init (clean mug))\n(:goal (on mug desk))\n"
      "(:metric minimize (total-cost)))";
  EXPECT_EQ(problem_error(good), "parsed");
  EXPECT_THAT(problem_error(replaced(good, "room", "garden")),
              HasSubstr("1:30: the problem is for domain 'garden'"));
  EXPECT_THAT(problem_error(replaced(good, "on mug", "on mag")),
              HasSubstr("3:12: unknown object 'mag' (did you mean mug?)"));
  EXPECT_THAT(problem_error(replaced(good, "mug - cup", "mug mug - cup")), HasSubstr("declared twice"));
  EXPECT_THAT(problem_error(replaced(good, "(clean mug)", "(clean mug desk)")),
              HasSubstr("takes 1 arguments"));
  EXPECT_THAT(problem_error(replaced(good, "minimize", "maximize")), HasSubstr("minimize"));
  EXPECT_THAT(problem_error("(define (problem p) (:domain room))"), HasSubstr("has no (:goal"));
}

TEST(ProblemParser, TakesAMillionObjects) {
  const auto domain = parse_domain(kRoom, "room.pddl");
  std::string text = "(define (problem p) (:domain room) (:objects";
  for (int i = 0; i < 1'000'000; ++i) text += " c" + std::to_string(i);
  const auto problem = parse_problem(text + " - cup) (:init) (:goal (on c7 desk)))", "p.pddl", *domain);
  ASSERT_TRUE(problem) << problem.error().message;
  EXPECT_EQ(problem->object_count(), 1'000'001);
}

}  // namespace
}  // namespace goalnet::planner
