// Runs that begin where a file says, such as where another run ended.
#include <gmock/gmock-matchers.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "tests/closed_loop/run_json.h"

namespace goalnet {
namespace {

class Start : public testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text) {
    const std::filesystem::path path = folder_ / name;
    std::ofstream(path) << text;
    return path;
  }
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

 private:
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("goalnet_start_test_" + std::to_string(getpid()));
};

TEST_F(Start, ARunGoesOnWhereAnotherEnded) {
  const RunResult first = run_json({"--goal", "(In Mug_1 Microwave)"});
  ASSERT_EQ(first.exit_code, 0) << first.json["message"];
  const std::string file = write("first.json", first.json.dump());
  const RunResult second = run_json({"--start", file, "open the microwave and take the mug out"});
  EXPECT_EQ(second.exit_code, 0) << second.json["message"];
  for (const auto& fact : first.json["facts"]) {
    const std::string text = fact;
    if (text.starts_with("(On") || text.starts_with("(In") || text.starts_with("(state")) {
      EXPECT_THAT(second.json["facts_before"], testing::Contains(text));
    }
  }
  EXPECT_TRUE(second.holds("not (In Mug_1 Microwave)"));
}

TEST_F(Start, WhatARunEmptiedIsEmptyInTheNext) {
  const std::string empty = write("empty.json", R"json({"facts": [], "objects": ["Mug_1"]})json");
  const RunResult first = run_json({"--start", empty, "--goal", "(Near Robot Sink)"});
  ASSERT_EQ(first.exit_code, 0) << first.json["message"];
  ASSERT_TRUE(first.holds("not (state Mug_1 Coffee)"));
  const std::string file = write("first.json", first.json.dump());
  const RunResult second = run_json({"--start", file, "--goal", "(Near Robot Fridge)"});
  EXPECT_EQ(second.exit_code, 0) << second.json["message"];
  EXPECT_TRUE(second.holds("not (state Mug_1 Coffee)")) << "the scene's own mug has some";
}

TEST_F(Start, InferenceKnowsTheThingsOfARunThatNoFactTellsOf) {
  const RunResult run = run_json({"--goal", "(Near Robot Fridge)"});
  ASSERT_EQ(run.exit_code, 0) << run.json["message"];
  const std::string file = write("run.json", run.json.dump());
  const auto inferred = testing_support::run_goalnet({"infer", file, "turn on the tap"}, kRunDomain);
  EXPECT_EQ(inferred.exit_code, 0) << inferred.err;
  EXPECT_THAT(inferred.out, testing::HasSubstr("(state SinkKnob TapIsOn)"));
}

TEST_F(Start, PutsThingsWhereTheFileSays) {
  const std::string file =
      write("state.json", R"json({"facts": ["(On Book_2 CoffeeTable_1)", "(state Tv_1 IsOn)",
                                                            "(state Tv_1 Channel2)"]})json");
  const RunResult run =
      run_json({"--scene", "living_room", "--start", file, "--goal", "(Grasping Robot Book_2)"});
  EXPECT_EQ(run.exit_code, 0) << run.json["message"];
  EXPECT_THAT(run.json["facts_before"], testing::Contains("(On Book_2 CoffeeTable_1)"));
  EXPECT_TRUE(run.holds("(state Tv_1 Channel2)"));
  EXPECT_TRUE(run.holds("not (state Tv_1 Channel3)")) << "devices are as the file says, or off";
  EXPECT_TRUE(run.holds("(Grasping Robot Book_2)"));
}

TEST_F(Start, AWholeStateEmptiesWhatItDoesNotFill) {
  for (const bool whole : {false, true}) {
    const std::string file =
        write("state.json", R"json({"facts": ["(On Mug_1 Sink)"])json" +
                                std::string(whole ? ", \"objects\": [\"Mug_1\"]}" : "}"));
    const RunResult run = run_json({"--start", file, "--goal", "(Near Robot Sink)"});
    EXPECT_EQ(run.exit_code, 0) << run.json["message"];
    EXPECT_TRUE(run.holds("(On Mug_1 Sink)"));
    EXPECT_EQ(run.holds("(state Mug_1 Coffee)"), !whole);
  }
}

TEST_F(Start, WhatCannotBeArrangedIsTold) {
  const std::string file =
      write("state.json", R"json({"facts": ["(On Kettle Moon)", "(state Stove StoveFire1)"]})json");
  const auto run = testing_support::run_goalnet(
      {"run", "--private", "--start", file, "--goal", "not (state Stove StoveFire1)"}, kRunDomain);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, testing::HasSubstr("has it: (On Kettle Moon)\n"));
}

TEST_F(Start, BadFilesAreRefused) {
  for (const auto& [text, reason] : {std::pair{"{\"facts\": 3}", "should be {\"objects\""},
                                     {"{\"facts\": [\"(On Mug_1\"]}", "unbalanced"},
                                     {"{", "parse error"}}) {
    const RunResult run = run_json({"--start", write("bad.json", text), "open the microwave"});
    EXPECT_EQ(run.exit_code, 13) << text;
    EXPECT_THAT(run.json["message"].get<std::string>(),
                testing::AllOf(testing::HasSubstr("bad.json: "), testing::HasSubstr(reason)));
  }
  const RunResult both = run_json({"--untidy", "--start", "a.json", "open the microwave"});
  EXPECT_EQ(both.exit_code, 13);
}

}  // namespace
}  // namespace goalnet
