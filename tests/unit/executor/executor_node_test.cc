// The executor on DDS: trajectories in, status and commands out, in lockstep and on the wall clock.
#include "executor/executor_node.h"

#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>

#include "components/messages/conversions.h"
#include "rosgraph_msgs/msg/Clock.h"
#include "tests/support/domain.h"

namespace goalnet::executor {
namespace {

using namespace std::chrono_literals;
using goalnet_msgs::msg::ExecutorStatus_Constants::EXECUTING;
using goalnet_msgs::msg::ExecutorStatus_Constants::FAULT;
using goalnet_msgs::msg::ExecutorStatus_Constants::IDLE;
using testing::HasSubstr;
using StatusMessage = goalnet_msgs::msg::ExecutorStatus;

class ExecutorNodeTest : public testing::Test {
 protected:
  void start(const std::vector<std::string>& parameters) {
    std::vector<std::string> words = {"--ros-args", "--disable-stdout-logs"};
    for (const std::string& parameter : parameters) words.insert(words.end(), {"-p", parameter});
    context_ =
        ros::Context::create({.domain_id = testing_support::own_domain(), .process_only = true}).value();
    node_ = ros::Node::create(*context_, loop_,
                              {.name = "executor", .arguments = ros::parse_arguments(words).value()})
                .value();
    client_ = ros::Node::create(*context_, loop_, {.name = "client", .arguments = {}}).value();
    auto made = ExecutorNode::create(*node_);
    ASSERT_TRUE(made) << made.error().message;
    executor_ = std::move(*made);
    trajectories_ = client_->advertise<trajectory_msgs::msg::JointTrajectory>("joint_trajectory");
    commands_ = client_->advertise<std_msgs::msg::String>("executor_command");
    joint_states_ = client_->advertise<sensor_msgs::msg::JointState>("joint_states");
    status_ =
        client_->subscribe<StatusMessage>("executor_status", ros::Qos::latched(),
                                          [this](const StatusMessage& message) { seen_.push_back(message); });
    joint_commands_ = client_->subscribe<sensor_msgs::msg::JointState>(
        "joint_commands", ros::Qos::standard().keep_last(1),
        [this](const sensor_msgs::msg::JointState& message) { commanded_ = message; });
  }

  static trajectory_msgs::msg::JointTrajectory to(double goal, std::int64_t stamp,
                                                  const char* joint = "lift") {
    trajectory_msgs::msg::JointTrajectory message;
    message.header().stamp(messages::to_stamp(stamp));
    message.joint_names({joint});
    for (const int second : {0, 2}) {
      trajectory_msgs::msg::JointTrajectoryPoint point;
      point.time_from_start().sec(second);
      point.positions({second == 0 ? 0.2 : goal});
      message.points().push_back(point);
    }
    return message;
  }
  static std_msgs::msg::String word(const std::string& text) {
    std_msgs::msg::String message;
    message.data(text);
    return message;
  }

  ros::EventLoop loop_;
  std::unique_ptr<ros::Context> context_;
  std::unique_ptr<ros::Node> node_, client_;
  std::unique_ptr<ExecutorNode> executor_;
  std::shared_ptr<ros::Publisher<trajectory_msgs::msg::JointTrajectory>> trajectories_;
  std::shared_ptr<ros::Publisher<std_msgs::msg::String>> commands_;
  std::shared_ptr<ros::Publisher<sensor_msgs::msg::JointState>> joint_states_;
  std::shared_ptr<ros::Subscription<StatusMessage>> status_;
  std::shared_ptr<ros::Subscription<sensor_msgs::msg::JointState>> joint_commands_;
  std::vector<StatusMessage> seen_;
  sensor_msgs::msg::JointState commanded_;
};

// Lockstep: simulated time, one thread, a perfect robot.
class ExecutorLockstep : public ExecutorNodeTest {
 protected:
  void SetUp() override {
    start({"lockstep:=true", "use_sim_time:=true"});
    clock_ = client_->advertise<rosgraph_msgs::msg::Clock>("/clock", ros::Qos::clock());
    hook_ = executor_->lockstep_hook();
    command_.position[3] = 0.2;  // lift
    tick();
  }
  void tick() {
    for (int n = 0; n < 10; ++n) {
      time_ns_ += 1'000'000;
      measured_.position = command_.position;
      if (blocked_) measured_.position[3] = 0.2;
      hook_(time_ns_, measured_, command_);
    }
    rosgraph_msgs::msg::Clock message;
    message.clock(messages::to_stamp(time_ns_));
    clock_->publish(message);
    while (loop_.run_pending()) {
    }
  }
  void run(double seconds) {
    for (int n = 0; n < std::lround(100.0 * seconds); ++n) tick();
  }

  std::shared_ptr<ros::Publisher<rosgraph_msgs::msg::Clock>> clock_;
  ExecutorNode::Hook hook_;
  JointSample measured_, command_;
  std::int64_t time_ns_ = 0;
  bool blocked_ = false;
};

TEST_F(ExecutorLockstep, FollowsAndReports) {
  run(0.1);
  ASSERT_EQ(seen_.size(), 1u);  // idle: told once
  trajectories_->publish(to(0.4, 123'456));
  run(1.0);
  EXPECT_EQ(seen_.back().state(), EXECUTING);
  EXPECT_EQ(messages::to_nanoseconds(seen_.back().trajectory_stamp()), 123'456);
  EXPECT_NEAR(seen_.back().progress(), 0.5, 0.02);
  EXPECT_NEAR(static_cast<double>(seen_.size()), 50.0, 4.0);  // 50 Hz
  run(1.2);
  EXPECT_EQ(seen_.back().state(), IDLE);
  EXPECT_EQ(seen_.back().outcome(), 0);
  EXPECT_EQ(seen_.back().progress(), 1.0);
  EXPECT_NEAR(command_.position[3], 0.4, 1e-12);
}

TEST_F(ExecutorLockstep, RefusalsCarryTheStamp) {
  run(0.1);
  trajectories_->publish(to(0.4, 1));
  run(0.5);
  trajectories_->publish(to(0.4, 777, "nose"));
  tick();
  const auto refused = [&](std::int64_t stamp) {
    for (const StatusMessage& message : seen_)
      if (messages::to_nanoseconds(message.trajectory_stamp()) == stamp && message.outcome() != 0)
        return message.message();
    return std::string();
  };
  EXPECT_THAT(refused(777), HasSubstr("no joint 'nose'"));
  auto elsewhere = to(0.4, 778);
  elsewhere.points()[0].positions({0.05});
  trajectories_->publish(elsewhere);
  run(0.1);
  EXPECT_THAT(refused(778), HasSubstr("away from the command of joint 'lift'"));
  run(2.0);
  EXPECT_NEAR(command_.position[3], 0.4, 1e-12);  // the first one was not disturbed
}

TEST_F(ExecutorLockstep, WhatIsSentTwiceIsTakenOnce) {
  run(0.1);
  trajectories_->publish(to(0.4, 5));
  run(1.0);
  trajectories_->publish(to(0.4, 5));  // by one who has not heard our answer yet
  run(0.5);
  EXPECT_EQ(seen_.back().state(), EXECUTING);
  EXPECT_EQ(seen_.back().trajectory_id(), 1u);
  EXPECT_NEAR(seen_.back().progress(), 0.75, 0.02);
  run(1.0);
  EXPECT_EQ(seen_.back().outcome(), 0);
}

TEST_F(ExecutorLockstep, DeactivatedItStopsAndHoldsAndActivatedItBeginsWhereTheJointsAre) {
  run(0.1);
  trajectories_->publish(to(0.4, 1));
  run(1.0);
  ASSERT_TRUE(executor_->deactivate());
  tick();
  EXPECT_EQ(seen_.back().outcome(), 22) << "told before it fell silent";
  const std::size_t told = seen_.size();
  trajectories_->publish(to(0.1, 2));
  run(2.0);
  EXPECT_EQ(command_.velocity[3], 0.0);
  EXPECT_GT(command_.position[3], 0.29);
  EXPECT_LT(command_.position[3], 0.4);
  EXPECT_EQ(seen_.size(), told);
  command_.position[3] = 0.2;  // somebody moves the lift meanwhile
  ASSERT_TRUE(executor_->cleanup());
  run(0.1);
  EXPECT_EQ(command_.position[3], 0.2) << "without an executor it holds";
  ASSERT_TRUE(executor_->configure());
  ASSERT_TRUE(executor_->activate());
  run(0.1);
  EXPECT_NEAR(command_.position[3], 0.2, 1e-9);
  trajectories_->publish(to(0.3, 3));
  run(3.0);
  EXPECT_EQ(seen_.back().outcome(), 0);
  EXPECT_NEAR(command_.position[3], 0.3, 1e-9);
}

TEST_F(ExecutorLockstep, StopsAndResetsOnCommand) {
  run(0.1);
  trajectories_->publish(to(0.4, 1));
  run(1.0);
  commands_->publish(word("stop"));
  run(1.0);
  EXPECT_EQ(seen_.back().state(), IDLE);
  EXPECT_EQ(seen_.back().outcome(), 22);
  commands_->publish(word("emergency_stop"));
  run(0.1);
  EXPECT_EQ(seen_.back().state(), FAULT);
  EXPECT_EQ(seen_.back().outcome(), 33);
  commands_->publish(word("dance"));
  commands_->publish(word("reset"));
  run(0.1);
  EXPECT_EQ(seen_.back().state(), IDLE);
  EXPECT_EQ(seen_.back().outcome(), 0);
}

TEST_F(ExecutorLockstep, ABlockedJointFailsTheMotion) {
  blocked_ = true;
  run(0.1);
  trajectories_->publish(to(0.4, 1));
  run(3.0);
  EXPECT_EQ(seen_.back().state(), IDLE);
  EXPECT_EQ(seen_.back().outcome(), 30);
  EXPECT_THAT(seen_.back().message(), HasSubstr("joint 'lift'"));
}

// On the wall clock: measurements over DDS in, commands over DDS out, real threads.
TEST_F(ExecutorNodeTest, RunsOnTheWallClock) {
  // The simulator's clock never ticks: a dead simulator must not keep a fault from being told.
  start({"lock_memory:=false", "use_sim_time:=true"});
  // Everything but numbers first: nothing may come out.
  sensor_msgs::msg::JointState measured;
  measured.name({"lift", "base_x"});
  measured.position({0.2});
  joint_states_->publish(measured);
  measured.position({std::nan(""), 0.0});
  joint_states_->publish(measured);
  loop_.run_for(50ms);
  EXPECT_TRUE(commanded_.name().empty());

  const robot::RobotModel robot = robot::load_robot("default").value();
  measured = {};
  for (const robot::Joint& joint : robot.joints) {
    measured.name().push_back(joint.name);
    measured.position().push_back(joint.name == "lift" ? 0.2 : joint.home);
  }
  measured.name().push_back("FridgeLeftDoor_joint");  // fixtures come along and are left out
  measured.position().push_back(0.0);
  const auto keep_measuring = [&] {
    if (commanded_.position().size() == robot.joints.size())
      for (std::size_t i = 0; i < robot.joints.size(); ++i) measured.position()[i] = commanded_.position()[i];
    joint_states_->publish(measured);
  };
  auto driver = client_->create_timer(5ms, keep_measuring);
  ASSERT_TRUE(loop_.run_for(2s, [&] { return !commanded_.name().empty(); }));
  EXPECT_EQ(commanded_.name().size(), robot.joints.size());
  trajectories_->publish(to(0.25, 42));
  ASSERT_TRUE(loop_.run_for(5s, [&] { return !seen_.empty() && seen_.back().state() == EXECUTING; }));
  ASSERT_TRUE(loop_.run_for(5s, [&] { return seen_.back().state() == IDLE; }));
  EXPECT_EQ(seen_.back().outcome(), 0) << seen_.back().message();
  EXPECT_NEAR(commanded_.position()[static_cast<std::size_t>(robot.index_of("lift"))], 0.25, 1e-6);

  // The driver dies; whoever tells of doors and of the base goes on. The watchdog notices.
  driver->cancel();
  sensor_msgs::msg::JointState others;
  others.name({"FridgeLeftDoor_joint", "base_x"});
  others.position({0.0, commanded_.position()[static_cast<std::size_t>(robot.index_of("base_x"))]});
  const auto doors = client_->create_timer(5ms, [&] { joint_states_->publish(others); });
  ASSERT_TRUE(loop_.run_for(5s, [&] { return seen_.back().state() == FAULT; }));
  EXPECT_EQ(seen_.back().outcome(), 31);
}

// On the wall clock deactivate returns when the robot stands.
TEST_F(ExecutorNodeTest, DeactivateWaitsUntilTheRobotStands) {
  start({"lock_memory:=false"});
  const robot::RobotModel robot = robot::load_robot("default").value();
  const auto lift = static_cast<std::size_t>(robot.index_of("lift"));
  sensor_msgs::msg::JointState measured;
  for (const robot::Joint& joint : robot.joints) {
    measured.name().push_back(joint.name);
    measured.position().push_back(joint.name == "lift" ? 0.2 : joint.home);
  }
  // A perfect robot in a thread of its own: this test's loop is the executor's, and that one waits.
  std::atomic<double> position{0.2}, velocity{0.0};
  std::atomic<int> commands{0};
  const auto obey =
      client_->subscribe<sensor_msgs::msg::JointState>("joint_commands", ros::Qos::standard().keep_last(1),
                                                       [&](const sensor_msgs::msg::JointState& command) {
                                                         position = command.position()[lift];
                                                         velocity = command.velocity()[lift];
                                                         ++commands;
                                                       },
                                                       {.immediate = true});
  std::jthread robot_thread([&](const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      measured.position()[lift] = position;
      joint_states_->publish(measured);
      std::this_thread::sleep_for(2ms);
    }
  });
  ASSERT_TRUE(loop_.run_for(2s, [&] { return commands > 0; }));
  trajectories_->publish(to(0.4, 42));
  ASSERT_TRUE(loop_.run_for(5s, [&] { return velocity > 0.05; }));
  ASSERT_TRUE(executor_->deactivate());
  EXPECT_EQ(velocity, 0.0);
  EXPECT_LT(position, 0.4) << "stopped on the way";
  const double stood = position;
  const int before = commands;
  loop_.run_for(50ms);
  EXPECT_EQ(commands, before) << "silent";
  EXPECT_EQ(seen_.back().outcome(), 22) << seen_.back().message();
  ASSERT_TRUE(executor_->activate());
  ASSERT_TRUE(loop_.run_for(2s, [&] { return commands > before + 5; }));
  EXPECT_NEAR(position, stood, 1e-9);
}

TEST(ExecutorParameters, BadOnesAreRefused) {
  const auto refusal = [](const std::string& parameter) {
    auto context =
        ros::Context::create({.domain_id = testing_support::own_domain(), .process_only = true}).value();
    ros::EventLoop loop;
    auto arguments = ros::parse_arguments({"--ros-args", "--disable-stdout-logs", "-p", parameter}).value();
    auto node = ros::Node::create(*context, loop, {.name = "executor", .arguments = arguments});
    if (!node) return node.error().message;
    const auto made = ExecutorNode::create(**node);
    return made ? std::string("accepted") : made.error().message;
  };
  EXPECT_THAT(refusal("rate:=1.0"), HasSubstr("rate"));
  EXPECT_THAT(refusal("priority:=100"), HasSubstr("priority"));
  EXPECT_THAT(refusal("lockstep:=maybe"), HasSubstr("lockstep"));
  EXPECT_THAT(refusal("robot:=no_such_robot"), HasSubstr("no_such_robot"));
}

}  // namespace
}  // namespace goalnet::executor
