#include "tools/goalnet/run_options.h"

#include <gmock/gmock-matchers.h>

namespace goalnet::tools {
namespace {

using testing::HasSubstr;

ParsedRun parse(std::vector<std::string> words) {
  words.insert(words.begin(), "goalnet run");
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  return parse_run_options(static_cast<int>(argv.size()), argv.data());
}

std::string refusal(const std::vector<std::string>& words) {
  const ParsedRun parsed = parse(words);
  if (!parsed.refused) return "";
  EXPECT_EQ(parsed.refused->outcome, Outcome::kInvalidRequest);
  return parsed.refused->message;
}

TEST(RunOptions, AnInstructionWithDefaults) {
  const ParsedRun parsed = parse({"fill the mug with water"});
  ASSERT_FALSE(parsed.refused);
  EXPECT_EQ(parsed.options.instruction, "fill the mug with water");
  EXPECT_EQ(parsed.options.scene, "kitchen");
  EXPECT_EQ(parsed.options.seed, 1u);
  EXPECT_FALSE(parsed.options.json);
}

TEST(RunOptions, ForgottenQuotesAreForgiven) {
  EXPECT_EQ(parse({"open", "the", "microwave", "--seed", "3"}).options.instruction, "open the microwave");
}

TEST(RunOptions, GoalsRepeatAndMayBeNegative) {
  const ParsedRun parsed =
      parse({"--goal", "(On Mug_1 Sink)", "--goal", "not (state SinkKnob TapIsOn)", "--json"});
  ASSERT_FALSE(parsed.refused) << parsed.refused->message;
  EXPECT_EQ(parsed.options.goal.positive, (std::vector<Predicate>{{"On", "Mug_1", "Sink"}}));
  EXPECT_EQ(parsed.options.goal.negative, (std::vector<Predicate>{{"state", "SinkKnob", "TapIsOn"}}));
  EXPECT_TRUE(parsed.options.json);
}

TEST(RunOptions, RosArgumentsAreLeftToTheNodes) {
  const ParsedRun parsed = parse({"open the fridge", "--ros-args", "-p", "seed:=3"});
  ASSERT_FALSE(parsed.refused);
  EXPECT_THAT(parsed.options.ros_arguments, testing::ElementsAre("--ros-args", "-p", "seed:=3"));
}

TEST(RunOptions, SlipsAreNamed) {
  EXPECT_THAT(refusal({""}), HasSubstr("empty"));
  EXPECT_THAT(refusal({}), HasSubstr("empty"));
  EXPECT_THAT(refusal({"--goal", "(On Mug_1"}), HasSubstr("unbalanced"));
  EXPECT_THAT(refusal({"--goal", "(On Mug_1 Sink)", "open the fridge"}), HasSubstr("not both"));
  EXPECT_THAT(refusal({"--seed", "minus one", "open the fridge"}), HasSubstr("--seed"));
  EXPECT_THAT(refusal({"--no-such-option", "open the fridge"}), HasSubstr("--help"));
  EXPECT_THAT(refusal({"--max-steps", "0", "open the fridge"}), HasSubstr("max-steps"));
  EXPECT_TRUE(parse({"--json", "--no-such-option"}).options.json) << "a refusal is told as JSON, too";
}

}  // namespace
}  // namespace goalnet::tools
