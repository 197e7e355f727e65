#include "tools/goalnet/record_options.h"

#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>

namespace goalnet::tools {
namespace {

using testing::HasSubstr;

template <class Parse>
auto parse_words(Parse function, std::vector<std::string> words) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  return function(static_cast<int>(arguments.size()), arguments.data());
}
auto record(std::vector<std::string> words) {
  words.insert(words.begin(), "goalnet record");
  return parse_words(parse_record_options, std::move(words));
}
auto replay(std::vector<std::string> words) {
  words.insert(words.begin(), "goalnet replay");
  return parse_words(parse_replay_options, std::move(words));
}

TEST(RecordOptions, AsRos2BagTakesThem) {
  const auto parsed = record({"-o", "bag", "--storage", "sqlite3", "-b", "1000000", "-d", "2.5", "-x",
                              "image", "tf", "/odom", "--ros-args", "-r", "__node:=x"});
  ASSERT_TRUE(parsed) << parsed.error().message;
  EXPECT_EQ(parsed->options.bag.directory, "bag");
  EXPECT_EQ(parsed->options.bag.storage, ros::BagStorage::kSqlite);
  EXPECT_EQ(parsed->options.bag.split_bytes, 1'000'000u);
  EXPECT_EQ(parsed->options.bag.split_duration, std::chrono::milliseconds(2500));
  EXPECT_TRUE(parsed->options.selection.selects("/tf"));
  EXPECT_TRUE(parsed->options.selection.selects("/odom"));
  EXPECT_FALSE(parsed->options.selection.selects("/other"));
  EXPECT_THAT(parsed->ros_arguments, testing::ElementsAre("--ros-args", "-r", "__node:=x"));
}

TEST(RecordOptions, NothingNamedIsEverythingIntoADirectoryByDate) {
  const auto parsed = record({});
  ASSERT_TRUE(parsed);
  EXPECT_TRUE(parsed->options.selection.selects("/anything"));
  EXPECT_FALSE(parsed->options.selection.selects("/a/_hidden"));
  EXPECT_THAT(parsed->options.bag.directory, testing::MatchesRegex("rosbag2_[0-9_]+-[0-9_]+"));
  const auto all = record({"-a", "/extra", "--include-hidden-topics", "-x", "camera"});
  ASSERT_TRUE(all);
  EXPECT_TRUE(all->options.selection.selects("/anything"));
  EXPECT_TRUE(all->options.selection.selects("/a/_hidden"));
  EXPECT_FALSE(all->options.selection.selects("/camera/image"));
}

TEST(RecordOptions, SlipsAreTold) {
  const auto message = [](std::vector<std::string> words) {
    const auto parsed = record(std::move(words));
    return parsed ? "taken" : parsed.error().message;
  };
  EXPECT_THAT(message({"--storage", "floppy"}), HasSubstr("no bag storage \"floppy\""));
  EXPECT_THAT(message({"--storage", "sqlite3", "--compression", "zstd"}), HasSubstr("MCAP only"));
  EXPECT_THAT(message({"--compression", "rar"}), HasSubstr("rar"));
  EXPECT_THAT(message({"-e", "("}), HasSubstr("no regular expression"));
  EXPECT_THAT(message({"-d", "-1"}), HasSubstr("range"));
  EXPECT_THAT(message({"--sideways"}), HasSubstr("goalnet record --help"));
}

TEST(ReplayOptions, ClockMayBeAFlagOrANumber) {
  EXPECT_EQ(replay({"bag"})->options.clock_hz, 0.0);
  EXPECT_EQ(replay({"bag", "--clock"})->options.clock_hz, 40.0);
  EXPECT_EQ(replay({"bag", "--clock", "100"})->options.clock_hz, 100.0);
  const auto parsed = replay({"bag", "--rate", "2", "--loop", "-d", "0", "--topics", "/a", "b"});
  ASSERT_TRUE(parsed) << parsed.error().message;
  EXPECT_EQ(parsed->options.rate, 2.0);
  EXPECT_TRUE(parsed->options.loop);
  EXPECT_EQ(parsed->options.delay.count(), 0);
  EXPECT_TRUE(parsed->options.selection.selects("/b"));
  EXPECT_FALSE(parsed->options.selection.selects("/c"));
  EXPECT_FALSE(replay({}));
  EXPECT_FALSE(replay({"bag", "--rate", "0"}));
  EXPECT_FALSE(replay({"bag", "--clock", "fast"}));
}

}  // namespace
}  // namespace goalnet::tools
