#include "components/coordinator/request.h"

#include <gmock/gmock-matchers.h>

namespace goalnet::coordinator {
namespace {

using testing::HasSubstr;

std::string refusal(const std::string& text) {
  const auto checked = check_instruction(text);
  if (checked) return "";
  EXPECT_EQ(checked.error().outcome, Outcome::kInvalidRequest);
  return checked.error().message;
}

TEST(CheckInstruction, TakesPlainEnglish) {
  EXPECT_TRUE(check_instruction("fill the mug with water"));
  EXPECT_TRUE(check_instruction("caf\u00e9 au lait, s'il vous pla\u00eet \U0001F916"));
  EXPECT_TRUE(check_instruction(std::string(kMaxInstructionBytes, 'a')));
}

TEST(CheckInstruction, RefusesNothing) {
  EXPECT_THAT(refusal(""), HasSubstr("empty"));
  EXPECT_THAT(refusal(" \t\n"), HasSubstr("empty"));
}

TEST(CheckInstruction, RefusesTooMuch) {
  EXPECT_THAT(refusal(std::string(kMaxInstructionBytes + 1, 'a')), HasSubstr("4097 bytes"));
}

TEST(CheckInstruction, RefusesWhatIsNotText) {
  EXPECT_THAT(refusal("fill\xff the mug"), HasSubstr("UTF-8"));
  EXPECT_THAT(refusal(std::string("fill\0mug", 8)), HasSubstr("control"));
  EXPECT_THAT(refusal("fill \x1b[31m mug"), HasSubstr("control"));
}

TEST(IsUtf8, FollowsTheRfc) {
  EXPECT_TRUE(is_utf8(""));
  EXPECT_TRUE(
      is_utf8("\xc2\x80\xdf\xbf\xe0\xa0\x80\xed\x9f\xbf\xef\xbf\xbf\xf0\x90\x80\x80\xf4\x8f\xbf\xbf"));
  for (const char* bad :
       {"\x80", "\xc0\x80", "\xc1\xbf", "\xc2", "\xe0\x9f\xbf", "\xed\xa0\x80", "\xf0\x8f\xbf\xbf",
        "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xe2\x82", "\xe2\x28\xa1"}) {
    EXPECT_FALSE(is_utf8(bad)) << testing::PrintToString(bad);
  }
}

TEST(CheckGoal, NamesWhatIsWrong) {
  Goal goal;
  EXPECT_THAT(check_goal(goal).error().message, HasSubstr("empty"));
  goal.positive = {{"On", "Mug_1", "Sink"}};
  EXPECT_TRUE(check_goal(goal));
  goal.negative = goal.positive;
  EXPECT_THAT(check_goal(goal).error().message, HasSubstr("(On Mug_1 Sink) and excludes it"));
  goal.negative = {{"On", "Mug 1", "Sink"}};
  EXPECT_FALSE(check_goal(goal));
  goal.negative = {{"On", "", ""}};
  EXPECT_FALSE(check_goal(goal));
  goal.negative.clear();
  goal.positive.assign(kMaxGoalPredicates + 1, {"On", "Mug_1", "Sink"});
  EXPECT_THAT(check_goal(goal).error().message, HasSubstr("257 predicates"));
}

}  // namespace
}  // namespace goalnet::coordinator
