// Recordings: what is in the directory, that nothing is lost, and that others can read it (npm, if
// installed).
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "components/ros/bag/recorder.h"
#include "goalnet_msgs/msg/WorldState.h"
#include "std_msgs/msg/String.h"
#include "tests/unit/ros/support.h"

namespace goalnet::ros {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

std::string contents(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

struct BagTest : testing::Test {
  std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / ("bag_test_" + std::to_string(getpid()));
  void SetUp() override { std::filesystem::remove_all(folder); }
  void TearDown() override { std::filesystem::remove_all(folder); }

  // 200 world states and 100 strings.
  void record(Distro distro, bool crash = false) {
    auto context = make_context(kBagDomain, distro);
    EventLoop loop;
    Node node(*context, loop, plain("robot"));
    auto worlds = node.advertise<goalnet_msgs::msg::WorldState>("/world_state", Qos::latched());
    auto texts = node.advertise<std_msgs::msg::String>("/instruction", Qos::standard());
    auto recorder =
        Recorder::create(node, {.directory = folder.string(), .topics = {"/world_state", "/instruction"}});
    ASSERT_TRUE(recorder) << recorder.error().message;
    goalnet_msgs::msg::WorldState world;
    world.objects({"Mug_1", "Sink"});
    std_msgs::msg::String text;
    for (int i = 0; i < 100; ++i) {
      world.header().stamp(Time(i).to_msg());
      text.data("fill mug " + std::to_string(i) + " ü");
      worlds->publish(world);
      texts->publish(text);
      worlds->publish(world);
      while (loop.run_pending()) {
      }
    }
    if (crash) {
      loop.run_for(700ms);                                          // the flush of the last half second
      std::filesystem::copy(folder, folder.string() + "_crashed");  // as a killed process leaves it
    }
    ASSERT_TRUE((*recorder)->close());
    EXPECT_EQ((*recorder)->message_count(), 300u);
    EXPECT_FALSE(Recorder::create(node, {.directory = folder.string(), .topics = {}})) << "never overwrites";
  }
};

TEST_F(BagTest, MetadataOfBothDistributions) {
  for (const Distro distro : {Distro::kJazzy, Distro::kHumble}) {
    std::filesystem::remove_all(folder);
    record(distro);
    const YAML::Node info =
        YAML::LoadFile((folder / "metadata.yaml").string())["rosbag2_bagfile_information"];
    EXPECT_EQ(info["version"].as<int>(), distro == Distro::kJazzy ? 9 : 5);
    EXPECT_EQ(info["storage_identifier"].as<std::string>(), "mcap");
    EXPECT_EQ(info["message_count"].as<int>(), 300);
    ASSERT_EQ(info["topics_with_message_count"].size(), 2u);
    const YAML::Node topic = info["topics_with_message_count"][1];
    EXPECT_EQ(topic["topic_metadata"]["name"].as<std::string>(), "/world_state");
    EXPECT_EQ(topic["message_count"].as<int>(), 200);
    const YAML::Node qos = topic["topic_metadata"]["offered_qos_profiles"];
    if (distro == Distro::kJazzy) {
      EXPECT_EQ(qos[0]["durability"].as<std::string>(), "transient_local");
      EXPECT_THAT(topic["topic_metadata"]["type_description_hash"].as<std::string>(), HasSubstr("RIHS01_"));
    } else {
      const YAML::Node inner = YAML::Load(qos.as<std::string>());
      EXPECT_EQ(inner[0]["durability"].as<int>(), 1);
      EXPECT_EQ(inner[0]["liveliness_lease_duration"]["nsec"].as<int>(), 854775807);
    }
    EXPECT_TRUE(std::filesystem::exists(folder / info["files"][0]["path"].as<std::string>()));
  }
}

TEST_F(BagTest, DefinitionsCarryTheirDependencies) {
  record(Distro::kJazzy);
  const std::string file = contents(folder / "recording_0.mcap");
  EXPECT_THAT(file, HasSubstr("MSG: goalnet_msgs/Predicate"));
  EXPECT_THAT(file, HasSubstr("MSG: builtin_interfaces/Time"));
  EXPECT_EQ(file.substr(0, 8), file.substr(file.size() - 8)) << "magic at both ends";
}

// tests/interoperability/read_bag.mjs decodes every message with @mcap/core and
// @foxglove/rosmsg2-serialization.
TEST_F(BagTest, ReadersOfOthersDecodeEveryMessage) {
  const char* modules = std::getenv("GOALNET_NODE_MODULES");
  if (modules == nullptr)
    GTEST_SKIP() << "set GOALNET_NODE_MODULES to a folder with @mcap/core (tests/interoperability/README.md)";
  record(Distro::kJazzy, true);
  for (const std::string suffix : {"", "_crashed"}) {
    const std::string command = "cd '" + std::string(modules) + "/..' && cp '" + GOALNET_SOURCE_DIR +
                                "/tests/interoperability/read_bag.mjs' read_bag.mjs && node read_bag.mjs '" +
                                folder.string() + suffix + "/recording_0.mcap' > '" + folder.string() +
                                "/out.txt' 2>&1";
    const int code = std::system(command.c_str());
    const std::string out = contents(folder / "out.txt");
    EXPECT_EQ(code, 0) << out;
    EXPECT_THAT(out, HasSubstr("/instruction 100"));
    EXPECT_THAT(out, HasSubstr("/world_state 200"));
    EXPECT_THAT(out, HasSubstr("fill mug 99 ü"));
    EXPECT_THAT(out, HasSubstr("Mug_1,Sink"));
    EXPECT_THAT(out, HasSubstr(suffix.empty() ? "indexed" : "stream"));
  }
  std::filesystem::remove_all(folder.string() + "_crashed");
}

}  // namespace
}  // namespace goalnet::ros
