// The simulator's shell: what it publishes, in lockstep and paced.
#include "sim/simulator_node.h"

#include <cmath>
#include <optional>

#include <gtest/gtest.h>

#include "goalnet_msgs/msg/ObjectPoses.h"
#include "goalnet_msgs/msg/ObjectStates.h"
#include "rosgraph_msgs/msg/Clock.h"
#include "sensor_msgs/msg/JointState.h"
#include "std_msgs/msg/String.h"
#include "tests/support/domain.h"
#include "tf2_msgs/msg/TFMessage.h"

namespace goalnet::sim {
namespace {

struct Bench {
  explicit Bench(std::vector<std::string> parameters, int domain) {
    ros::ContextOptions options;
    options.domain_id = domain;
    context = std::move(*ros::Context::create(options));
    std::vector<std::string> words = {"--ros-args"};
    for (const auto& parameter : parameters) {
      words.push_back("-p");
      words.push_back(parameter);
    }
    arguments = *ros::parse_arguments(words);
  }
  std::unique_ptr<ros::Node> node(const std::string& name) {
    ros::NodeOptions options;
    options.name = name;
    if (name == "simulator") options.arguments = arguments;
    return std::move(*ros::Node::create(*context, loop, options));
  }
  ros::EventLoop loop;
  std::unique_ptr<ros::Context> context;
  ros::Arguments arguments;
};

TEST(SimulatorNode, PublishesTheWorldInLockstep) {
  Bench bench({"lockstep:=true", "seed:=2"}, testing_support::own_domain());
  auto listener = bench.node("listener");
  auto node = bench.node("simulator");
  int clocks = 0;
  std::optional<sensor_msgs::msg::JointState> joints;
  std::optional<goalnet_msgs::msg::ObjectPoses> poses;
  std::optional<goalnet_msgs::msg::ObjectStates> states;
  std::optional<tf2_msgs::msg::TFMessage> transforms;
  std::optional<std_msgs::msg::String> description;
  auto a = listener->subscribe<rosgraph_msgs::msg::Clock>("/clock", ros::Qos::clock(),
                                                          [&](const auto&) { ++clocks; });
  auto b = listener->subscribe<sensor_msgs::msg::JointState>("joint_states", ros::Qos::standard(),
                                                             [&](const auto& m) { joints = m; });
  auto c = listener->subscribe<goalnet_msgs::msg::ObjectPoses>("object_poses", ros::Qos::standard(),
                                                               [&](const auto& m) { poses = m; });
  auto d = listener->subscribe<goalnet_msgs::msg::ObjectStates>("object_states", ros::Qos::latched(),
                                                                [&](const auto& m) { states = m; });
  auto e = listener->subscribe<tf2_msgs::msg::TFMessage>("/tf", ros::Qos::tf(),
                                                         [&](const auto& m) { transforms = m; });
  auto f = listener->subscribe<std_msgs::msg::String>("robot_description", ros::Qos::latched(),
                                                      [&](const auto& m) { description = m; });
  auto simulator = SimulatorNode::create(*node);
  ASSERT_TRUE(simulator) << simulator.error().message;
  for (int i = 0; i < 10; ++i) {
    (*simulator)->tick();
    while (bench.loop.run_pending()) {
    }
  }
  EXPECT_EQ((*simulator)->time_ns(), 100'000'000);
  EXPECT_EQ(clocks, 10);
  ASSERT_TRUE(joints);
  EXPECT_EQ(joints->name().size(), 32u);
  EXPECT_EQ(joints->position().size(), 32u);
  EXPECT_EQ(joints->header().stamp().nanosec(), 100'000'000u);
  ASSERT_TRUE(poses);
  EXPECT_EQ(poses->header().frame_id(), "map");
  EXPECT_EQ(poses->objects().size(), 30u);
  EXPECT_EQ(poses->objects().front().name(), "BoiledEgg_1");
  ASSERT_TRUE(states);
  bool coffee = false;
  for (const auto& object : states->objects()) {
    for (const auto& value : object.values()) coffee |= object.name() == "Mug_1" && value == "Coffee";
  }
  EXPECT_TRUE(coffee);
  ASSERT_TRUE(transforms);
  EXPECT_EQ(transforms->transforms().size(), 22u);
  ASSERT_TRUE(description);
  EXPECT_NE(description->data().find("<robot"), std::string::npos);
}

TEST(SimulatorNode, CallsItsControllerEveryMillisecond) {
  Bench bench({"lockstep:=true"}, testing_support::own_domain());
  auto node = bench.node("simulator");
  auto simulator = SimulatorNode::create(*node);
  ASSERT_TRUE(simulator) << simulator.error().message;
  std::vector<std::int64_t> times;
  const auto lift = static_cast<std::size_t>((*simulator)->world().robot().index_of("lift"));
  double start = -1, largest_error = 0;
  (*simulator)
      ->set_controller([&](std::int64_t time, const executor::JointSample& measured,
                           executor::JointSample& command) {
        times.push_back(time);
        if (start < 0) start = measured.position[lift];
        largest_error = std::max(largest_error, std::abs(measured.position[lift] - command.position[lift]));
        command.position[lift] = start + 0.1 * static_cast<double>(time) * 1e-9;
        command.velocity[lift] = 0.1;
      });
  for (int i = 0; i < 50; ++i) (*simulator)->tick();
  ASSERT_EQ(times.size(), 500u);
  for (std::size_t i = 0; i < times.size(); ++i)
    EXPECT_EQ(times[i], static_cast<std::int64_t>(i) * 1'000'000);
  EXPECT_NEAR((*simulator)->world().robot_joint(lift).position, start + 0.05, 2e-4);
  EXPECT_LT(largest_error, 2e-3);
}

TEST(SimulatorNode, FollowsJointCommandsWhenPaced) {
  Bench bench({"real_time_factor:=5.0"}, testing_support::own_domain());
  auto node = bench.node("simulator");
  auto driver = bench.node("driver");
  auto simulator = SimulatorNode::create(*node);
  ASSERT_TRUE(simulator) << simulator.error().message;
  const auto lift = static_cast<std::size_t>((*simulator)->world().robot().index_of("lift"));
  const double start = (*simulator)->world().robot_joint(lift).position;
  auto commands =
      driver->advertise<sensor_msgs::msg::JointState>("joint_commands", ros::Qos::standard().keep_last(1));
  sensor_msgs::msg::JointState message;
  message.name({"lift", "no_such_joint"});
  message.position({start - 0.05, std::nan("")});
  message.velocity({0.0, 0.0});
  commands->publish(message);
  bench.loop.run_for(std::chrono::seconds(5), [&] { return (*simulator)->time_ns() >= 1'500'000'000; });
  EXPECT_GE((*simulator)->time_ns(), 1'500'000'000);
  EXPECT_NEAR((*simulator)->world().robot_joint(lift).position, start - 0.05, 1e-3);
}

TEST(SimulatorNode, RefusesBadParameters) {
  for (const char* bad : {"scene:=no_such_room", "robot:=no_such_robot", "physics_step:=0.003",
                          "real_time_factor:=0.0", "seed:=-1"}) {
    Bench bench({bad, "lockstep:=true"}, testing_support::own_domain());
    auto node = bench.node("simulator");
    auto simulator = SimulatorNode::create(*node);
    ASSERT_FALSE(simulator) << bad;
    EXPECT_EQ(simulator.error().outcome, Outcome::kInvalidRequest) << bad;
    EXPECT_FALSE(simulator.error().message.empty()) << bad;
  }
}

}  // namespace
}  // namespace goalnet::sim
