#include "components/goalnet/scoring.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "components/goalnet/evaluation.h"

namespace goalnet::inference {
namespace {

FactSet facts(std::initializer_list<const char*> texts) {
  std::vector<Predicate> list;
  for (const char* text : texts) list.push_back(*parse_predicate(text));
  return FactSet(list);
}

TEST(Scoring, PerfectRun) {
  const auto start = facts({"(Near Robot Sink)"}), end = facts({"(Grasping Robot Mug_1)"});
  const std::vector<std::string> actions = {"moveto Mug_1", "grasp Mug_1"};
  const Scores s = score_run(start, end, actions, end, actions);
  EXPECT_EQ(s.sji, 1);
  EXPECT_EQ(s.f1, 1);
  EXPECT_EQ(s.ied, 1);
  EXPECT_EQ(s.grr, 1);
  EXPECT_EQ(s.exact, 1);
}

TEST(Scoring, DoingMoreIsFreeForGrrOnly) {
  const auto start = facts({}), want = facts({"(On Mug_1 Sink)"}),
             got = facts({"(On Mug_1 Sink)", "(Near Robot Sink)"});
  const std::vector<std::string> one = {"keep Mug_1 On Sink"}, two = {"moveto Sink", "keep Mug_1 On Sink"};
  const Scores s = score_run(start, want, one, got, two);
  EXPECT_EQ(s.grr, 1);
  EXPECT_EQ(s.grr_formula, 0);
  EXPECT_DOUBLE_EQ(s.sji, 0.5);
  EXPECT_DOUBLE_EQ(s.ied, 0.5);
}

TEST(Scoring, PublishedSpellingTakesKeepInForKeepOn) {
  const std::vector<std::string> in = {"keep Mug_1 In Microwave"}, on = {"keep Mug_1 On Microwave"};
  const Scores s = score_run({}, {}, in, {}, on);
  EXPECT_EQ(s.ied, 1);
  EXPECT_EQ(s.ied_canonical, 0);
}

TEST(Scoring, NothingDoneScoresNothing) {
  const Scores s = score_run({}, {}, {}, {}, {});
  EXPECT_EQ(s.sji, 0);
  EXPECT_EQ(s.ied, 0);
  EXPECT_EQ(s.grr, 1);
  EXPECT_EQ(s.ied_canonical, 1);
}

// A model that repeats every other recorded step: right, wrong and half right runs of every kind.
class Parrot : public GoalModel {
 public:
  explicit Parrot(const std::vector<Demonstration>& all) : all_(all) {}
  std::string_view kind() const override { return "parrot"; }

 private:
  Expected<Goal> do_infer(const StepInput& input) override {
    for (const Demonstration& d : all_) {
      if (d.sentence != input.sentence || input.states.front().facts != d.states.front().facts) continue;
      const std::size_t at = input.goals.size() * (d.scenario.size() % 2 + 1);
      return at < d.steps.size() ? d.steps[at] : Goal{};
    }
    return Goal{};
  }
  const std::vector<Demonstration>& all_;
};

TEST(Scoring, EqualsTheIndependentScorer) {
  const std::filesystem::path shared = std::filesystem::path(GOALNET_SOURCE_DIR) / "../shared";
  const auto data = shared / "data/goalnet/val", script = shared / "tools/score.py";
  if (!std::filesystem::exists(data) || !std::filesystem::exists(script))
    GTEST_SKIP() << "needs ../shared/data/goalnet";
  if (std::system("python3 -c 0") != 0) GTEST_SKIP() << "needs python3";
  const auto all = read_demonstrations(data);
  ASSERT_TRUE(all) << all.error().message;
  Symbols symbols;
  const auto lexicon = Lexicon::load(GOALNET_SOURCE_DIR "/config/language/household.json", symbols);
  ASSERT_TRUE(lexicon);
  const auto result =
      evaluate([&] { return Expected<std::unique_ptr<GoalModel>>(std::make_unique<Parrot>(*all)); }, *all,
               *lexicon, {.grounding = true, .threads = 2, .progress = {}});
  ASSERT_TRUE(result);
  EXPECT_GT(result->mean.sji, 0.2) << "the comparison would say little";
  const auto runs =
      std::filesystem::temp_directory_path() / ("goalnet_runs_" + std::to_string(::getpid()) + ".jsonl");
  ASSERT_TRUE(write_runs(result->runs, runs));
  const std::string command = "python3 " + script.string() + " " + data.string() + " " + runs.string();
  FILE* pipe = popen(command.c_str(), "r");
  ASSERT_NE(pipe, nullptr);
  std::string output;
  std::array<char, 512> buffer;
  while (fgets(buffer.data(), buffer.size(), pipe) != nullptr) output += buffer.data();
  EXPECT_EQ(pclose(pipe), 0);
  std::filesystem::remove(runs);
  const auto value = [&](const std::string& key) {
    const std::size_t at = output.find("\"" + key + "\":");
    EXPECT_NE(at, std::string::npos) << key << " in " << output;
    return at == std::string::npos ? -1 : std::atof(output.c_str() + at + key.size() + 3);
  };
  // score.py rounds to four digits.
  EXPECT_NEAR(value("sji"), result->mean.sji, 5.1e-5);
  EXPECT_NEAR(value("ied"), result->mean.ied, 5.1e-5);
  EXPECT_NEAR(value("f1"), result->mean.f1, 5.1e-5);
  EXPECT_NEAR(value("grr"), result->mean.grr, 5.1e-5);
  EXPECT_NEAR(value("grr_formula"), result->mean.grr_formula, 5.1e-5);
  EXPECT_NEAR(value("exact"), result->mean.exact, 5.1e-5);
  EXPECT_NEAR(value("ied_canonical"), result->mean.ied_canonical, 5.1e-5);
  EXPECT_EQ(value("missing"), 0);
}

}  // namespace
}  // namespace goalnet::inference
