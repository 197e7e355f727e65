// Bags of whole runs, decoded to the last message by software that is not ours: @mcap/core, @foxglove/rosbag2
// and
// @foxglove/rosmsg2-serialization from npm, which the CTest fixture npm_bag_readers installs.
#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <filesystem>
#include <sstream>
#include <thread>

#include "components/ros/bag/bag_reader.h"
#include "tests/support/process.h"

namespace goalnet {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing_support::Process;
using testing_support::ProcessResult;

constexpr int kDomain = 96;
const std::string kReaders = GOALNET_BAG_READERS;  // where npm installed them

struct OthersReadBags : testing::Test {
  fs::path folder = fs::path(testing::TempDir()) / ("others_read_bags_" + std::to_string(getpid()));
  void SetUp() override {
    if (!fs::exists(kReaders + "/node_modules/.package-lock.json"))
      GTEST_SKIP() << "readers of others are not installed: the test npm_bag_readers says why";
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  void TearDown() override { fs::remove_all(folder); }

  // A run of a few simulated seconds.
  std::string run(const std::string& storage, const std::string& distro) {
    const std::string bag = (folder / (storage + "_" + distro)).string();
    const auto result = testing_support::run_goalnet(
        {"run", "--goal", "(state SinkKnob TapIsOn)", "--json", "--record", bag, "--record-storage", storage},
        kDomain, {{"GOALNET_ROS_DISTRO", distro}});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return bag;
  }
  // Whatever file the bag has, through the script that reads its kind.
  ProcessResult read(const std::string& bag) {
    for (const auto& entry : fs::directory_iterator(bag)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".mcap" && extension != ".db3") continue;
      const std::string script = kReaders + (extension == ".mcap" ? "/read_mcap.mjs" : "/read_sqlite.mjs");
      Process node({GOALNET_NODE, script, entry.path().string()}, {});
      return node.wait(std::chrono::seconds(60));
    }
    return {};
  }
  // They count as many messages of each topic as metadata.yaml says.
  void expect_counts(const std::string& bag, const std::string& out, bool all_topics = true) {
    const auto metadata = ros::read_bag_metadata(bag);
    ASSERT_TRUE(metadata) << metadata.error().message;
    std::map<std::string, std::uint64_t> counted;
    std::istringstream lines(out);
    for (std::string line; std::getline(lines, line);) {
      std::istringstream words(line);
      std::string topic;
      if (line.starts_with("/") && words >> topic) words >> counted[topic];
    }
    std::size_t compared = 0;
    for (const ros::BagTopic& topic : metadata->topics) {
      if (topic.message_count == 0 || (!all_topics && !counted.contains(topic.name))) continue;
      EXPECT_EQ(counted[topic.name], topic.message_count) << topic.name;
      ++compared;
    }
    EXPECT_GE(compared, all_topics ? 15u : 6u);
  }
};

TEST_F(OthersReadBags, McapOfJazzy) {
  const std::string bag = run("mcap", "jazzy");
  const auto read_out = read(bag);
  ASSERT_EQ(read_out.exit_code, 0) << read_out.err;
  EXPECT_THAT(read_out.out, HasSubstr("indexed, chunks"));
  EXPECT_THAT(read_out.out, HasSubstr("profile ros2"));
  EXPECT_THAT(read_out.out, HasSubstr("metadata message_count: 0\nmetadata message_count: "));
  EXPECT_THAT(read_out.out,
              HasSubstr("\"relation\":\"state\",\"subject\":\"SinkKnob\",\"object\":\"TapIsOn\""));
  expect_counts(bag, read_out.out);
}

TEST_F(OthersReadBags, McapOfHumble) {
  const std::string bag = run("mcap", "humble");
  const auto read_out = read(bag);
  ASSERT_EQ(read_out.exit_code, 0) << read_out.err;
  EXPECT_THAT(read_out.out, HasSubstr("metadata humble\n"));
  expect_counts(bag, read_out.out);
}

TEST_F(OthersReadBags, SqliteOfJazzy) {
  const std::string bag = run("sqlite3", "jazzy");
  const auto read_out = read(bag);
  ASSERT_EQ(read_out.exit_code, 0) << read_out.err;
  EXPECT_THAT(read_out.out,
              HasSubstr("\"relation\":\"state\",\"subject\":\"SinkKnob\",\"object\":\"TapIsOn\""));
  expect_counts(bag, read_out.out);
}

TEST_F(OthersReadBags, SqliteOfHumble) {
  const std::string bag = run("sqlite3", "humble");
  const auto read_out = read(bag);
  ASSERT_EQ(read_out.exit_code, 0) << read_out.err;
  EXPECT_THAT(read_out.out, HasSubstr("/joint_states "));
  expect_counts(bag, read_out.out,
                false);  // Humble's tables have no definitions: the types they know themselves
}

// Compressed, and cut off by the death of the recorder; then repaired.
TEST_F(OthersReadBags, McapOfAKilledRecorder) {
  const std::map<std::string, std::string> environment = {{"ROS_DOMAIN_ID", std::to_string(kDomain)}};
  Process simulator({testing_support::program("goalnet"), "component", "simulator"}, environment);
  const std::string bag = (folder / "killed").string();
  Process recorder({testing_support::program("goalnet"), "record", "--compression", "zstd", "-o", bag,
                    "/joint_states", "/clock"},
                   environment);
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  const auto count = [&] {
    const auto metadata = ros::read_bag_metadata(bag);
    return metadata ? metadata->message_count() : 0u;
  };
  while (count() < 100 && std::chrono::steady_clock::now() < deadline)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  recorder.signal(SIGKILL);
  recorder.wait(std::chrono::seconds(5));
  const auto as_it_lies = read(bag);
  ASSERT_EQ(as_it_lies.exit_code, 0) << as_it_lies.err;
  EXPECT_THAT(as_it_lies.out, HasSubstr("stream"));
  EXPECT_THAT(as_it_lies.out, HasSubstr("/joint_states "));
  ASSERT_EQ(testing_support::run_goalnet({"record", "--repair", bag}, kDomain).exit_code, 0);
  const auto repaired = read(bag);
  ASSERT_EQ(repaired.exit_code, 0) << repaired.err;
  EXPECT_THAT(repaired.out, HasSubstr("indexed"));
  EXPECT_EQ(repaired.out.substr(repaired.out.find("\n/")), as_it_lies.out.substr(as_it_lies.out.find("\n/")));
}

}  // namespace
}  // namespace goalnet
