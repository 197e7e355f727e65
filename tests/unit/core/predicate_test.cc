#include "components/core/predicate.h"

#include <gtest/gtest.h>

namespace goalnet {
namespace {

TEST(ParsePredicate, TakesTwoAndThreeWords) {
  EXPECT_EQ(parse_predicate("(On Mug_1 Sink)").value(), (Predicate{"On", "Mug_1", "Sink"}));
  EXPECT_EQ(parse_predicate(" state  SinkKnob TapIsOn ").value(), (Predicate{"state", "SinkKnob", "TapIsOn"}));
  EXPECT_EQ(parse_predicate("(IsGraspable Mug_1)").value(), (Predicate{"IsGraspable", "Mug_1", ""}));
}

TEST(ParsePredicate, RefusesEverythingElseWithAMessage) {
  for (const char* text : {"", "(", ")", "()", "(On)", "On Mug_1 Sink)", "(On a b c)", "(On Mug\n Sink)", "(Ön a b)"}) {
    const auto result = parse_predicate(text);
    ASSERT_FALSE(result.has_value()) << text;
    EXPECT_EQ(result.error().outcome, Outcome::kInvalidRequest);
    EXPECT_NE(result.error().message.find("predicate"), std::string::npos);
  }
}

TEST(ParsePredicate, RoundTrips) {
  const Predicate fact{"Near", "Robot", "Tv_1"};
  EXPECT_EQ(parse_predicate(to_string(fact)).value(), fact);
}

TEST(ParsePredicate, MessageStaysShortForHugeInput) {
  const auto result = parse_predicate(std::string(100000, '!'));
  ASSERT_FALSE(result.has_value());
  EXPECT_LT(result.error().message.size(), 300u);
}

TEST(FactSet, BehavesAsASet) {
  const Predicate a{"On", "A", "B"}, b{"On", "B", "C"};
  FactSet facts({b, a, a});
  EXPECT_EQ(facts.size(), 2u);
  facts.insert(a);
  EXPECT_EQ(facts.size(), 2u);
  facts.erase(a);
  EXPECT_FALSE(facts.contains(a));
  EXPECT_EQ(difference(FactSet({a, b}), facts), FactSet({a}));
}

TEST(Satisfied, NeedsAllPositiveAndNoNegative) {
  const Predicate a{"On", "A", "B"}, b{"On", "B", "C"};
  EXPECT_TRUE(satisfied(Goal{{a}, {b}}, FactSet({a})));
  EXPECT_FALSE(satisfied(Goal{{a}, {b}}, FactSet({a, b})));
  EXPECT_FALSE(satisfied(Goal{{a}, {}}, FactSet()));
  EXPECT_TRUE(satisfied(Goal{}, FactSet()));
}

TEST(Outcome, NamesAndNumbersAgree) {
  for (int code = -5; code < 50; ++code) {
    const Outcome outcome = outcome_from_int(code);
    if (outcome != Outcome::kInternal) {
      EXPECT_EQ(static_cast<int>(outcome), code);
    }
  }
  EXPECT_EQ(to_string(Outcome::kNoPlan), "no_plan");
  EXPECT_EQ(outcome_from_int(12), Outcome::kNoPlan);
  EXPECT_EQ(outcome_from_int(77), Outcome::kInternal);
}

}  // namespace
}  // namespace goalnet
