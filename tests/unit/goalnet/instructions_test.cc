// Plain instructions and nonsense (tests/data/instructions): does the shipped model do what any sane person
// would want, and refuse what means nothing? Only counts are asserted and printed, so that the held-out part
// stays held out.
#include <gtest/gtest.h>

#include <array>

#include "tests/unit/goalnet/instruction_runner.h"

namespace goalnet::inference {
namespace {

const std::string kFolder = GOALNET_SOURCE_DIR "/tests/data/instructions/";

class Instructions : public testing::Test {
 protected:
  static void SetUpTestSuite() { runner = std::make_unique<InstructionRunner>(); }
  static void TearDownTestSuite() { runner.reset(); }
  inline static std::unique_ptr<InstructionRunner> runner;
};

TEST_F(Instructions, SensibleOnesReachTheirGoals) {
  std::map<std::string, std::array<int, 3>> counts;  // set -> all, reached, refused
  for (const auto& row : read_rows(kFolder + "sensible.tsv")) {
    ASSERT_EQ(row.size(), 6u) << row[0];
    auto& [all, good, refused] = counts[row[1]];
    ++all;
    const auto run = runner->follow(runner->room(row[2], row[4]), row[3]);
    refused += run.refused;
    const bool ok = !run.refused && reached(row[5], run.facts);
    good += ok;
    if (row[1] == "tuning") {
      EXPECT_TRUE(ok) << row[0] << ": " << row[3] << ": " << run.message;
    }
  }
  for (const auto& [set, count] : counts) {
    std::printf("%s: %d of %d reach their goal, %d refused\n", set.c_str(), count[1], count[0], count[2]);
    EXPECT_GE(count[1], 0.9 * count[0]) << set;
    EXPECT_LT(count[2], 0.03 * count[0] + 1e-9) << set;
  }
  EXPECT_EQ(counts["held_out"][0], 80);
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
    EXPECT_EQ(goal.error().outcome, Outcome::kNotUnderstood);
    EXPECT_GT(goal.error().message.size(), 20u);
  }
  for (const auto& [set, count] : counts) {
    std::printf("%s: %d of %d nonsense sentences refused\n", set.c_str(), count[1], count[0]);
    EXPECT_GE(count[1], 0.95 * count[0]) << set;
  }
}

}  // namespace
}  // namespace goalnet::inference
