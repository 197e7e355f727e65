// Plain instructions and nonsense (tests/data/instructions): does the shipped model do what any sane person
// would want, and refuse what means nothing? Only counts are asserted and printed, so that the held-out part
// stays held out.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string_view>

#include "components/goalnet/demonstration.h"
#include "components/goalnet/ranker/ranker_model.h"
#include "tests/unit/goalnet/instruction_runner.h"

namespace goalnet::inference {
namespace {

const std::string kFolder = GOALNET_SOURCE_DIR "/tests/data/instructions/";

class Instructions : public testing::Test {
 protected:
  static void SetUpTestSuite() { runner = std::make_unique<InstructionRunner>(); }
  static void TearDownTestSuite() { runner.reset(); }
  static Error refusal(const std::string& room, const std::string& sentence) {
    const std::vector<WorldState> states = {runner->room(room, "")};
    const auto goal =
        runner->model().infer({.sentence = sentence, .grounding = nullptr, .states = states, .goals = {}});
    EXPECT_FALSE(goal) << sentence;
    return goal ? Error{} : goal.error();
  }
  inline static std::unique_ptr<InstructionRunner> runner;
};

TEST_F(Instructions, SensibleOnesReachTheirGoals) {
  std::map<std::string, std::array<int, 3>> counts;          // set -> all, reached, refused
  std::map<std::string, std::array<double, 3>> confidences;  // set -> not refused, sum of confidence, reached
  for (const auto& row : read_rows(kFolder + "sensible.tsv")) {
    ASSERT_EQ(row.size(), 6u) << row[0];
    auto& [all, good, refused] = counts[row[1]];
    ++all;
    const auto run = runner->follow(runner->room(row[2], row[4]), row[3]);
    refused += run.refused;
    const bool ok = !run.refused && reached(row[5], run.facts);
    good += ok;
    if (!run.refused) {
      auto& [n, sum, right] = confidences[row[1]];
      n += 1, sum += run.confidence, right += ok;
    }
    if (!ok && row[1] == "tuning")
      std::printf("%s not reached: %s: %s\n", row[0].c_str(), row[3].c_str(), run.message.c_str());
  }
  // The confidence is that of people met for the first time; these sets have been known for long.
  for (const auto& [set, sure] : confidences) {
    std::printf("%s: mean confidence %.3f, %.3f of what was not refused is right\n", set.c_str(),
                sure[1] / sure[0], sure[2] / sure[0]);
    EXPECT_LT(sure[1] / sure[0], sure[2] / sure[0]) << set;
    EXPECT_GT(sure[1] / sure[0], 0.9) << set;
  }
  for (const auto& [set, count] : counts) {
    std::printf("%s: %d of %d reach their goal, %d refused\n", set.c_str(), count[1], count[0], count[2]);
    EXPECT_GE(count[1], 0.92 * count[0]) << set;
    EXPECT_LT(count[2], (set == "tuning" ? 0.06 : 0.03) * count[0]) << set;  // tuning collects what failed
  }
  EXPECT_EQ(counts["held_out"][0], 80);
  EXPECT_EQ(counts["blind"][0], 1282);
}

TEST_F(Instructions, NonsenseIsRefusedWithAReason) {
  std::map<std::string, std::array<int, 2>> counts;
  for (const auto& row : read_rows(kFolder + "nonsense.tsv")) {
    ASSERT_EQ(row.size(), 4u);
    const std::vector<WorldState> states = {runner->room(row[2], "")};
    const auto goal =
        runner->model().infer({.sentence = row[3], .grounding = nullptr, .states = states, .goals = {}});
    ++counts[row[1]][0];
    if (goal) continue;
    ++counts[row[1]][1];
    EXPECT_TRUE(goal.error().outcome == Outcome::kNotUnderstood ||
                goal.error().outcome == Outcome::kUnknownObject)
        << row[3];
    EXPECT_GT(goal.error().message.size(), 20u);
  }
  for (const auto& [set, count] : counts) {
    std::printf("%s: %d of %d nonsense sentences refused\n", set.c_str(), count[1], count[0]);
    EXPECT_GE(count[1], 0.95 * count[0]) << set;
  }
}

TEST_F(Instructions, AThingThatIsNotHereIsAnUnknownObject) {
  for (const char* sentence : {"bring me a pillow", "put the flurb in the sink", "take the mug and the torch",
                               "turn on the tv", "open the fridge and get the milk", "throw away the fork"})
    EXPECT_EQ(refusal("kitchen", sentence).outcome, Outcome::kUnknownObject) << sentence;
}

TEST_F(Instructions, WhatCannotBeReadIsNotUnderstood) {
  for (const char* sentence :
       {"flurb the mug", "flurb the gribble with wibble", "the mug", "what is the time?",
        "bring me the pillow and flurb the mug", "open the mug", "put the salt", "swap the plates"})
    EXPECT_EQ(refusal("kitchen", sentence).outcome, Outcome::kNotUnderstood) << sentence;
}

TEST_F(Instructions, OfAnEnglishWordTheThingsOfItsKindAreTold) {
  const std::string milk = refusal("kitchen", "get the milk out of the fridge").message;
  EXPECT_NE(milk.find("no milk here"), std::string::npos) << milk;
  EXPECT_NE(milk.find("Coke_1"), std::string::npos) << milk;
  EXPECT_EQ(milk.find("disk"), std::string::npos) << milk;
  const std::string bread = refusal("living_room", "bring me some bread").message;
  EXPECT_NE(bread.find("BagOfChips_1"), std::string::npos) << bread;
  const std::string slip = refusal("kitchen", "bring me the spooqqn").message;  // no English word
  EXPECT_NE(slip.find("\"spoon\""), std::string::npos) << slip;
}

TEST_F(Instructions, ANumberThatNothingHasIsToldWithWhatThereIs) {
  // Another spelling would turn to another channel.
  for (const char* sentence :
       {"switch to channel 9", "change the channel to 9", "let's watch channel eleven"}) {
    const std::string message = refusal("living_room", sentence).message;
    EXPECT_NE(message.find("channels 1 to 6"), std::string::npos) << sentence << ": " << message;
  }
  EXPECT_NE(refusal("living_room", "put the book on shelf 4").message.find("Shelf_1, Shelf_2"),
            std::string::npos);
  EXPECT_NE(refusal("kitchen", "turn on burner 7").message.find("StoveFire_4"), std::string::npos);
}

TEST_F(Instructions, WhatStandsElsewhereIsAnUnknownObjectAndToldWhere) {
  const Error error = refusal("living_room", "give me the pillow that's on the coffee table");
  EXPECT_EQ(error.outcome, Outcome::kUnknownObject);
  EXPECT_NE(error.message.find("Pillow_3 is at Shelf_1"), std::string::npos) << error.message;
}

TEST_F(Instructions, WhatIsNotAsToldIsNotSaidToBeDone) {
  for (const char* sentence :
       {"somebody left a burner on again, switch it off", "the tap is running, turn it off"}) {
    const Error error = refusal("kitchen", sentence);
    EXPECT_EQ(error.outcome, Outcome::kNotUnderstood);
    EXPECT_NE(error.message.find(" is not "), std::string::npos) << error.message;
  }
}

TEST_F(Instructions, HalfOfWhatWasAskedIsNoAnswer) {
  const std::map<std::string, std::string> half = {{"iron my shirt and bring me the mug", "shirt"},
                                                   {"order a pizza. Then bring me the mug", "pizza"},
                                                   {"clean my car and wash the plate", "car"},
                                                   {"sing us a song then bring the coke", "song"}};
  for (const auto& [sentence, cannot] : half) {
    const std::string message = refusal("kitchen", sentence).message;
    EXPECT_NE(message.find(cannot), std::string::npos) << sentence << ": " << message;
  }
}

// A sign of how sure to be of what was said last.
double sign(const GoalModel& model, std::string_view name) {
  const auto at = std::find(kSignNames.begin(), kSignNames.end(), name);
  return dynamic_cast<const RankerModel&>(model).signs().at(
      static_cast<std::size_t>(at - kSignNames.begin()));
}

TEST_F(Instructions, WhatAReadingLeavesUnusedIsASignOfDoubt) {
  struct Case {
    const char *sign, *with, *without;  // a sentence that shows the sign, and one like it that does not
  };
  for (const Case& c : std::vector<Case>{
           {"unused_things", "I have the plate already, now I just need the fork",
            "put the fork on the plate"},
           {"unused_places", "the tap is dripping all day long, bring me the fork",
            "put the fork in the sink"},
           {"unused_numbers", "I have asked four times, bring me the fork", "turn on burner four"},
           {"unheard_turns", "tip out the coffee and put water in the mug instead",
            "bring me the fork, not the spoon"},
           {"idle", "the left door of the fridge should please be closed now", "close the left fridge door"},
           {"corrected_itself", "put the lid... no, the plate on the counter", "the fork"},
           {"conditions", "if the tap is off, turn it on", "turn on the tap"}}) {
    const auto infer = [&](const char* sentence) {
      const std::vector<WorldState> states = {runner->room("kitchen", "")};
      (void)runner->model().infer(
          {.sentence = sentence, .grounding = nullptr, .states = states, .goals = {}});
      return sign(runner->model(), c.sign);
    };
    EXPECT_EQ(infer(c.without), 0) << c.sign << ": " << c.without;
    EXPECT_GT(infer(c.with), 0) << c.sign << ": " << c.with;
  }
}

TEST_F(Instructions, WhatIsNotSureIsToldAndNotDone) {
  const Error error = refusal("kitchen", "I have the plate already, now I just need the fork");
  EXPECT_EQ(error.outcome, Outcome::kNotUnderstood);
  for (const char* part : {"not sure", "grasp Fork_1", "unclear: \"plate\"", "in other words"})
    EXPECT_NE(error.message.find(part), std::string::npos) << error.message;
}

// Of readings of what people said before the grammar was mended for it: a confidence of p is right in about
// that share of them, and most of those below the least are wrong.
TEST(ReadingConfidence, SaysHowOftenFirstReadingsAreRight) {
  std::ifstream file(GOALNET_SOURCE_DIR "/config/language/confidence.json");
  const std::string text(std::istreambuf_iterator<char>(file), {});
  const auto confidence = ReadingConfidence::parse(text, "confidence.json");
  ASSERT_TRUE(confidence) << confidence.error().message;
  double all = 0, sum = 0, right = 0, low = 0, low_right = 0;
  for (const auto& row : read_rows(kFolder + "first_met.tsv")) {
    if (row.at(1) != "people") continue;
    Signs signs{};
    ASSERT_EQ(row.size(), 3 + signs.size());
    for (std::size_t i = 0; i < signs.size(); ++i) signs[i] = std::stod(row[3 + i]);
    const double p = confidence->of(signs), ok = row[2] == "1" ? 1 : 0;
    all += 1, sum += p, right += ok;
    if (p < confidence->least()) low += 1, low_right += ok;
  }
  EXPECT_NEAR(sum / all, right / all, 0.02);
  EXPECT_LT(low_right, 0.35 * low);
  EXPECT_GT(low - low_right, 0.1 * (all - right)) << "of the wrong ones";
  EXPECT_LT(low_right, 0.005 * right) << "of the right ones";
}

TEST(ReadingConfidence, AFileThatLacksSomethingIsRefused) {
  const auto without = ReadingConfidence::parse(R"({"bias": 1, "weights": {}})", "some.json");
  ASSERT_FALSE(without);
  EXPECT_NE(without.error().message.find("least"), std::string::npos) << without.error().message;
  EXPECT_FALSE(ReadingConfidence::parse(R"({"least": 0.5, "bias": 1, "weights": {"ties": 1}})", "some.json"));
}

// What people said to the robot when they were recorded: notes as a cook writes them, "it" for what is held.
TEST_F(Instructions, MostRecordedSentencesAreCarriedOut) {
  const std::string folder = GOALNET_SOURCE_DIR "/../shared/data/goalnet/train";
  if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << folder << " is not there";
  const auto demonstrations = read_demonstrations(folder);
  ASSERT_TRUE(demonstrations) << demonstrations.error().message;
  int said = 0, refused = 0;
  for (const Demonstration& shown : *demonstrations) {
    if (shown.perturbed) continue;
    const std::vector<WorldState> states = {runner->furnished(shown.states.front())};
    ++said;
    refused += !runner->model().infer(
        {.sentence = shown.sentence, .grounding = nullptr, .states = states, .goals = {}});
  }
  std::printf("recorded: %d of %d sentences refused\n", refused, said);
  EXPECT_EQ(said, 779);
  EXPECT_LT(refused, 0.19 * said);
}

}  // namespace
}  // namespace goalnet::inference
