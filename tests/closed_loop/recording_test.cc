// Runs and processes that are recorded: what the bags hold, twice the same, and after the recorder's death.
#include <gmock/gmock-matchers.h>
#include <signal.h>

#include <filesystem>
#include <fstream>
#include <thread>

#include "components/messages/conversions.h"
#include "components/ros/bag/bag_reader.h"
#include "components/ros/bag/bag_repair.h"
#include "components/ros/detail/message_type.h"
#include "components/scene/scene.h"
#include "goalnet_msgs/msg/ActionStatus.h"
#include "goalnet_msgs/msg/ObjectPoses.h"
#include "tests/closed_loop/run_json.h"
#include "tests/support/slowdown.h"
#include "visualization_msgs/msg/MarkerArray.h"

namespace goalnet {
namespace {

namespace fs = std::filesystem;
using testing_support::Process;
using visualization_msgs::msg::Marker;
using visualization_msgs::msg::MarkerArray;
namespace marker = visualization_msgs::msg::Marker_Constants;

constexpr int kDomain = 95;

template <class Message>
Message decode(const std::vector<std::uint8_t>& payload) {
  const auto& support = idl::type_support<Message>();
  Message message;
  const char* fault = ros::detail::decode(support, ros::detail::layout_of(support), payload, &message);
  if (fault != nullptr) throw std::runtime_error(fault);
  return message;
}

struct Recorded {
  std::string topic;
  std::uint64_t time = 0;
  std::vector<std::uint8_t> payload;
};

struct Recording : testing::Test {
  fs::path folder = fs::path(testing::TempDir()) / ("recording_test_" + std::to_string(getpid()));
  void SetUp() override {
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  void TearDown() override { fs::remove_all(folder); }

  std::unique_ptr<ros::BagReader> open(const std::string& bag) {
    auto reader = ros::BagReader::open(bag);
    if (!reader) throw std::runtime_error(reader.error().message);
    return std::move(*reader);
  }
  std::vector<Recorded> messages(const std::string& bag) {
    auto reader = open(bag);
    std::vector<Recorded> out;
    ros::BagMessage message;
    for (;;) {
      const auto more = reader->next(message);
      if (!more) throw std::runtime_error(more.error().message);
      if (!*more) return out;
      out.push_back({reader->topics()[message.topic].name, message.log_time, message.payload});
    }
  }
  // A run of a few simulated seconds: the robot drives to the sink and turns the tap on.
  std::string run(const std::string& name, const std::string& storage) {
    const std::string bag = (folder / name / "bag").string();
    fs::create_directories(folder / name);
    const auto result =
        run_json({"--goal", "(state SinkKnob TapIsOn)", "--record", bag, "--record-storage", storage});
    EXPECT_EQ(result.exit_code, 0) << result.json["message"];
    return bag;
  }
};

TEST_F(Recording, SameRunSameBagInEitherStorage) {
  const auto first = messages(run("first", "mcap")), second = messages(run("second", "sqlite3"));
  ASSERT_EQ(first.size(), second.size());
  ASSERT_GT(first.size(), 1000u);
  std::size_t equal = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    ASSERT_EQ(first[i].topic, second[i].topic) << i;
    ASSERT_EQ(first[i].time, second[i].time) << i << " " << first[i].topic;
    if (first[i].payload == second[i].payload) {
      ++equal;
    } else if (first[i].topic == "/action_status") {  // says how long planning took on the wall clock
      auto a = decode<goalnet_msgs::msg::ActionStatus>(first[i].payload);
      auto b = decode<goalnet_msgs::msg::ActionStatus>(second[i].payload);
      a.planning_time(0);
      b.planning_time(0);
      EXPECT_EQ(a, b) << i;
    } else {  // stamped with the wall clock until the first /clock
      EXPECT_EQ(first[i].topic, "/parameter_events") << i;
    }
  }
  EXPECT_GT(equal, first.size() * 9 / 10);
}

// The robot has done what it was to do, but the recording that was asked for is not there: that is no
// success.
TEST_F(Recording, AFullDiskIsToldInTheOutcome) {
  const std::string bag = (folder / "bag").string();
  // Files end at 600 KiB, and writing beyond fails as on a full disk.
  Process process({"/bin/sh", "-c", "trap '' XFSZ; ulimit -f 1200; exec \"$0\" \"$@\"",
                   testing_support::program("goalnet"), "run", "--json", "--goal", "(state SinkKnob TapIsOn)",
                   "--record", bag},
                  {{"ROS_DOMAIN_ID", std::to_string(kDomain)}});
  const auto result = process.wait(std::chrono::seconds(60));
  EXPECT_EQ(result.exit_code, static_cast<int>(Outcome::kInternal)) << result.err;
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json["outcome"], "done");
  EXPECT_EQ(json["recording"]["complete"], false);
  EXPECT_THAT(json["recording"]["message"].get<std::string>(),
              testing::HasSubstr("cannot write the recording"));
  EXPECT_THAT(result.err, testing::HasSubstr("the recording is not complete"));
  const auto metadata = ros::read_bag_metadata(bag);
  ASSERT_TRUE(metadata) << metadata.error().message;
  EXPECT_GT(metadata->message_count(), 100u);
  EXPECT_TRUE(open(bag)->finished()) << "what was written before is whole";
  EXPECT_EQ(messages(bag).size(), metadata->message_count());
}

TEST_F(Recording, HoldsAllThatRvizNeeds) {
  const std::string bag = run("run", "mcap");
  std::map<std::string, std::vector<Recorded>> by_topic;
  for (Recorded& one : messages(bag)) by_topic[one.topic].push_back(std::move(one));
  for (const char* topic :
       {"/tf", "/tf_static", "/robot_description", "/joint_states", "/markers", "/clock", "/world_state"})
    EXPECT_FALSE(by_topic[topic].empty()) << topic;
  EXPECT_EQ(by_topic["/robot_description"].front().time, 0u) << "from its first word";
  const auto reader = open(bag);
  for (const ros::BagTopic& topic : reader->topics()) {
    if (topic.name != "/robot_description" && topic.name != "/tf_static" && topic.name != "/markers")
      continue;
    ASSERT_EQ(topic.offered.size(), 1u);
    EXPECT_TRUE(topic.offered[0].qos.transient_local) << topic.name;
  }
  EXPECT_LT(by_topic["/markers"].size(), by_topic["/clock"].size() / 9)
      << "at most 10 a second, /clock has 100";

  // The shapes stand where the scene and /object_poses say.
  const auto scene = scene::load_scene("kitchen");
  ASSERT_TRUE(scene);
  const MarkerArray last = decode<MarkerArray>(by_topic["/markers"].back().payload);
  ASSERT_FALSE(last.markers().empty());
  const auto seen = messages::to_nanoseconds(last.markers()[0].header().stamp());
  std::map<std::string, geometry_msgs::msg::Pose> poses;
  for (const Recorded& one : by_topic["/object_poses"]) {
    const auto message = decode<goalnet_msgs::msg::ObjectPoses>(one.payload);
    if (messages::to_nanoseconds(message.header().stamp()) != seen) continue;
    for (const auto& object : message.objects()) poses[object.name()] = object.pose();
  }
  ASSERT_FALSE(poses.empty()) << "header.stamp is the moment of the poses drawn";
  std::map<std::pair<std::string, int>, const Marker*> markers;
  for (const Marker& one : last.markers()) {
    EXPECT_EQ(one.header().frame_id(), "map");
    EXPECT_TRUE(markers.emplace(std::pair(one.ns(), one.id()), &one).second)
        << one.ns() << one.id() << " twice";
  }
  int id = 0;
  for (const scene::Object& object : scene->objects) {
    const auto& pose = poses.at(object.name);
    const Eigen::Quaterniond turn(pose.orientation().w(), pose.orientation().x(), pose.orientation().y(),
                                  pose.orientation().z());
    for (const scene::Shape& shape : scene->model_of(object).shapes) {
      const Marker* drawn = markers[{"objects", id++}];
      ASSERT_NE(drawn, nullptr) << object.name;
      const Eigen::Vector3d place =
          Eigen::Vector3d(pose.position().x(), pose.position().y(), pose.position().z()) +
          turn * shape.pose.translation();
      const auto& at = drawn->pose().position();
      EXPECT_LT((Eigen::Vector3d(at.x(), at.y(), at.z()) - place).norm(), 1e-6) << object.name;
      const double diameter = shape.kind == scene::ShapeKind::kBox ? shape.size.x() : 2 * shape.size.x();
      EXPECT_NEAR(drawn->scale().x(), diameter, 1e-9);
      EXPECT_EQ(drawn->type(), shape.kind == scene::ShapeKind::kBox        ? marker::CUBE
                               : shape.kind == scene::ShapeKind::kCylinder ? marker::CYLINDER
                                                                           : marker::SPHERE);
    }
  }
  EXPECT_GT(id, 30);

  // What was achieved is written where it is, in green; the way of the hand was drawn, and went when all was
  // done.
  const Marker* goal = markers[{"goals", 0}];
  ASSERT_NE(goal, nullptr);
  EXPECT_EQ(goal->text(), "goal: TapIsOn");
  EXPECT_GT(goal->color().g(), goal->color().r());
  EXPECT_THAT(markers.at({"task", 0})->text(), testing::HasSubstr("finished"));
  std::size_t with_path = 0;
  for (const Recorded& one : by_topic["/markers"]) {
    const auto message = decode<MarkerArray>(one.payload);
    for (const Marker& drawn : message.markers())
      with_path += drawn.ns() == "path" && drawn.action() == marker::ADD && drawn.points().size() >= 2;
  }
  EXPECT_GT(with_path, 0u);
  bool deleted = false;
  for (const auto& [key, one] : markers) {
    if (key.first == "path") {
      EXPECT_EQ(one->action(), marker::DELETE);
      deleted = true;
    }
  }
  EXPECT_TRUE(deleted) << "viewers are told to remove it";
}

// Rows of the table in idl/README.md by topic: type ("std_msgs/String") and quality of service.
std::map<std::string, std::pair<std::string, std::string>> documented_topics() {
  std::ifstream file(GOALNET_SOURCE_DIR "/idl/README.md");
  std::map<std::string, std::pair<std::string, std::string>> out;
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with("| `/")) continue;
    std::vector<std::string> cells;
    std::istringstream row(line.substr(1));
    for (std::string cell; std::getline(row, cell, '|');) {
      cell.erase(0, cell.find_first_not_of(' '));
      cell.erase(cell.find_last_not_of(' ') + 1);
      cells.push_back(cell);
    }
    std::istringstream names(cells.at(0));
    for (std::string name; std::getline(names, name, '`');) {
      if (name.starts_with("/")) out[name] = {cells.at(1), cells.at(2)};
    }
  }
  return out;
}

TEST_F(Recording, TopicsAreThoseOfTheTable) {
  const auto documented = documented_topics();
  ASSERT_GT(documented.size(), 15u);
  std::size_t compared = 0;
  const auto bag = open(run("run", "mcap"));
  for (const ros::BagTopic& topic : bag->topics()) {
    if (topic.name.ends_with("/transition_event")) continue;  // one for each component, under its name
    if (topic.name.ends_with("/transition_event")) continue;  // of every managed node
    const auto row = documented.find(topic.name);
    ASSERT_NE(row, documented.end()) << topic.name << " is not in idl/README.md";
    if (row->second.first == "standard") continue;
    std::string type = topic.type;
    type.erase(type.find("/msg/"), 4);
    EXPECT_EQ(row->second.first.substr(0, type.size()), type) << topic.name;
    for (const ros::OfferedQos& offered : topic.offered) {
      EXPECT_TRUE(offered.qos.reliable) << topic.name;
      EXPECT_EQ(offered.qos.transient_local, row->second.second == "latched") << topic.name;
    }
    ++compared;
  }
  EXPECT_GT(compared, 14u);
}

// `goalnet record` is killed while a simulator works: the bag ends less than a second before.
TEST_F(Recording, AKilledRecorderLosesLessThanASecond) {
  const std::map<std::string, std::string> environment = {{"ROS_DOMAIN_ID", std::to_string(kDomain)}};
  Process simulator({testing_support::program("goalnet"), "component", "simulator"}, environment);
  for (const std::string storage : {"mcap", "sqlite3"}) {
    const std::string bag = (folder / storage).string();
    Process recorder({testing_support::program("goalnet"), "record", "--storage", storage, "-o", bag},
                     environment);
    // It records once there are messages in its metadata.
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    const auto recording = [&] {
      const auto metadata = ros::read_bag_metadata(bag);
      return metadata && metadata->message_count() > 200;
    };
    while (!recording() && std::chrono::steady_clock::now() < deadline)
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    ASSERT_TRUE(recording()) << recorder.err();
    testing_support::Slowdown slowdown;
    std::this_thread::sleep_for(std::chrono::milliseconds(400));  // some way into the next half second
    const auto killed = std::chrono::system_clock::now().time_since_epoch();
    recorder.signal(SIGKILL);
    const double slower = slowdown.stop();
    recorder.wait(std::chrono::seconds(5));
    const auto repaired = testing_support::run_goalnet({"record", "--repair", bag}, kDomain);
    EXPECT_EQ(repaired.exit_code, 0) << repaired.err;
    const auto recorded = messages(bag);
    ASSERT_GT(recorded.size(), 200u);
    const auto lost = killed - std::chrono::nanoseconds(recorded.back().time);
    EXPECT_LT(lost / slower, std::chrono::seconds(1)) << storage;
    EXPECT_TRUE(open(bag)->finished());
    EXPECT_EQ(ros::read_bag_metadata(bag)->message_count(), recorded.size());
  }
}

}  // namespace
}  // namespace goalnet
