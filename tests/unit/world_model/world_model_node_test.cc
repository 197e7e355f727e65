// The world model on DDS: what it publishes, when, and what it does when observations stop.
#include "components/world_model/world_model_node.h"

#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>

#include <cmath>

#include "components/messages/conversions.h"
#include "rosgraph_msgs/msg/Clock.h"
#include "tests/support/domain.h"

namespace goalnet::world_model {
namespace {

using testing::HasSubstr;

// A room at rest, observed at 100 Hz of simulated time.
class WorldModelNodeTest : public testing::Test {
 protected:
  void SetUp() override {
    context_ =
        ros::Context::create({.domain_id = testing_support::own_domain(), .process_only = true}).value();
    client_ = ros::Node::create(*context_, loop_, {.name = "client", .arguments = {}}).value();
    make_world_model();
    clock_ = client_->advertise<rosgraph_msgs::msg::Clock>("/clock", ros::Qos::clock());
    poses_ = client_->advertise<goalnet_msgs::msg::ObjectPoses>("object_poses");
    joints_ = client_->advertise<sensor_msgs::msg::JointState>("joint_states");
    states_ = client_->advertise<goalnet_msgs::msg::ObjectStates>("object_states", ros::Qos::latched());
    world_state_ = client_->subscribe<goalnet_msgs::msg::WorldState>(
        "world_state", ros::Qos::latched(), [this](const auto& message) { seen_.push_back(message); });

    const robot::RobotModel robot = robot::load_robot("default").value();
    for (std::size_t i = 0; i < robot.joints.size(); ++i) {
      joint_states_.name().push_back(robot.joints[i].name);
      joint_states_.position().push_back(robot.home()[i]);
    }
    joint_states_.name().push_back("SinkKnob_joint");
    joint_states_.position().push_back(0.0);
    const scene::Scene scene = scene::load_scene("kitchen").value();
    const auto initial = scene::initial_poses(scene, 1);
    for (std::size_t i = 0; i < initial.size(); ++i) {
      goalnet_msgs::msg::ObjectPose object;
      object.name(scene.objects[i].name);
      set(object, initial[i]);
      object_poses_.objects().push_back(object);
    }
  }

  // Anew, with other parameters: "stale_after:=10.0".
  void make_world_model(const std::string& parameter = "stale_after:=0.5") {
    world_model_.reset();
    node_.reset();
    const auto arguments = ros::parse_arguments({"--ros-args", "--disable-stdout-logs", "-p",
                                                 "use_sim_time:=true", "-p", parameter})
                               .value();
    node_ = ros::Node::create(*context_, loop_, {.name = "world_model", .arguments = arguments}).value();
    auto made = WorldModelNode::create(*node_);
    ASSERT_TRUE(made) << made.error().message;
    world_model_ = std::move(*made);
  }

  static void set(goalnet_msgs::msg::ObjectPose& object, const scene::Pose& pose) {
    const Eigen::Quaterniond q(pose.linear());
    object.pose().position().x(pose.translation().x());
    object.pose().position().y(pose.translation().y());
    object.pose().position().z(pose.translation().z());
    object.pose().orientation().w(q.w());
    object.pose().orientation().x(q.x());
    object.pose().orientation().y(q.y());
    object.pose().orientation().z(q.z());
  }

  void tick() {
    time_ns_ += 10'000'000;
    rosgraph_msgs::msg::Clock message;
    message.clock(messages::to_stamp(time_ns_));
    clock_->publish(message);
    joint_states_.header().stamp(messages::to_stamp(time_ns_));
    object_poses_.header().stamp(messages::to_stamp(time_ns_ - poses_late_ns_));
    if (send_joints_) joints_->publish(joint_states_);
    if (send_poses_) poses_->publish(object_poses_);
    while (loop_.run_pending()) {
    }
  }
  void run(double seconds) {
    for (int n = 0; n < std::lround(100.0 * seconds); ++n) tick();
  }
  bool holds(const std::string& fact) const {
    const WorldState world = messages::from_message(seen_.back()).value();
    return world.facts.contains(parse_predicate(fact).value());
  }

  ros::EventLoop loop_;
  std::unique_ptr<ros::Context> context_;
  std::unique_ptr<ros::Node> node_, client_;
  std::unique_ptr<WorldModelNode> world_model_;
  std::shared_ptr<ros::Publisher<rosgraph_msgs::msg::Clock>> clock_;
  std::shared_ptr<ros::Publisher<goalnet_msgs::msg::ObjectPoses>> poses_;
  std::shared_ptr<ros::Publisher<sensor_msgs::msg::JointState>> joints_;
  std::shared_ptr<ros::Publisher<goalnet_msgs::msg::ObjectStates>> states_;
  std::shared_ptr<ros::Subscription<goalnet_msgs::msg::WorldState>> world_state_;
  std::vector<goalnet_msgs::msg::WorldState> seen_;
  sensor_msgs::msg::JointState joint_states_;
  goalnet_msgs::msg::ObjectPoses object_poses_;
  std::int64_t time_ns_ = 0;
  std::int64_t poses_late_ns_ = 0;  // how long perception takes
  bool send_joints_ = true, send_poses_ = true;
};

TEST_F(WorldModelNodeTest, PublishesOnChangeAndRegularly) {
  run(0.02);
  ASSERT_FALSE(seen_.empty());  // at once
  EXPECT_EQ(seen_.back().header().frame_id(), "map");
  EXPECT_TRUE(holds("On Mug_1 Counter_1"));
  seen_.clear();
  run(2.0);
  EXPECT_NEAR(static_cast<double>(seen_.size()), 20.0, 1.0);  // 10 Hz
  EXPECT_LE(time_ns_ - messages::to_nanoseconds(seen_.back().header().stamp()), 100'000'000);

  seen_.clear();
  joint_states_.position().back() = 1.5;  // the tap is turned on
  run(0.06);
  ASSERT_FALSE(seen_.empty());
  EXPECT_TRUE(holds("state SinkKnob TapIsOn"));

  seen_.clear();
  goalnet_msgs::msg::ObjectState mug;
  mug.name("Mug_1");
  mug.values({"Water"});
  goalnet_msgs::msg::ObjectStates states;
  states.objects().push_back(mug);
  states_->publish(states);
  tick();
  ASSERT_FALSE(seen_.empty());
  EXPECT_TRUE(holds("state Mug_1 Water"));
}

// An old world is never passed off as a new one.
TEST_F(WorldModelNodeTest, SaysNothingWhenObservationsStop) {
  run(1.0);
  send_poses_ = false;
  run(0.6);
  seen_.clear();
  run(3.0);
  EXPECT_TRUE(seen_.empty());
  send_poses_ = true;
  send_joints_ = false;
  run(0.6);
  seen_.clear();
  run(1.0);
  EXPECT_TRUE(seen_.empty());
  send_joints_ = true;
  run(0.2);
  EXPECT_FALSE(seen_.empty());
}

TEST_F(WorldModelNodeTest, StartsOverWhenTheSimulatorDoes) {
  run(5.0);
  seen_.clear();
  time_ns_ = 0;
  run(0.5);
  ASSERT_FALSE(seen_.empty());
  EXPECT_LE(messages::to_nanoseconds(seen_.back().header().stamp()), time_ns_);
  EXPECT_TRUE(holds("On Mug_1 Counter_1"));
}

TEST_F(WorldModelNodeTest, SlowPerceptionIsNoJumpInTime) {
  make_world_model("stale_after:=10.0");
  poses_late_ns_ = 3'000'000'000;
  time_ns_ = 20'000'000'000;
  run(1.0);
  ASSERT_FALSE(seen_.empty());
  EXPECT_EQ(messages::to_nanoseconds(seen_.back().header().stamp()), time_ns_ - poses_late_ns_);
  EXPECT_TRUE(holds("On Mug_1 Counter_1"));
}

TEST_F(WorldModelNodeTest, SurvivesHostileMessages) {
  run(0.1);
  const WorldState before = messages::from_message(seen_.back()).value();
  goalnet_msgs::msg::ObjectPoses poses = object_poses_;
  for (auto& object : poses.objects()) object.pose().orientation().w(0.0);
  for (auto& object : poses.objects()) object.pose().orientation().z(0.0);  // no length
  poses.objects()[0].pose().position().x(std::nan(""));
  poses.header().stamp(messages::to_stamp(time_ns_ + 1));
  sensor_msgs::msg::JointState joints = joint_states_;
  joints.position().pop_back();
  goalnet_msgs::msg::ObjectStates states;
  states.objects().resize(20'000);
  for (int n = 0; n < 100; ++n) {
    poses_->publish(poses);
    joints_->publish(joints);
    states_->publish(states);
    while (loop_.run_pending()) {
    }
  }
  run(0.2);
  EXPECT_EQ(messages::from_message(seen_.back()).value().facts, before.facts);
}

TEST(WorldModelParameters, BadOnesAreRefused) {
  const auto refusal = [](const std::string& parameter) {
    auto context =
        ros::Context::create({.domain_id = testing_support::own_domain(), .process_only = true}).value();
    ros::EventLoop loop;
    auto arguments = ros::parse_arguments({"--ros-args", "--disable-stdout-logs", "-p", parameter}).value();
    auto node = ros::Node::create(*context, loop, {.name = "world_model", .arguments = arguments});
    if (!node) return node.error().message;
    const auto made = WorldModelNode::create(**node);
    return made ? std::string("accepted") : made.error().message;
  };
  EXPECT_THAT(refusal("near_object.exit:=0.1"), HasSubstr("near_object.exit"));
  EXPECT_THAT(refusal("rate:=-1.0"), HasSubstr("rate"));
  EXPECT_THAT(refusal("scene:=moon"), HasSubstr("moon"));
  EXPECT_THAT(refusal("robot:=no_such_robot"), HasSubstr("no_such_robot"));
}

}  // namespace
}  // namespace goalnet::world_model
