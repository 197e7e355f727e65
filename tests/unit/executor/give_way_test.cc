// After a joint did not follow: nothing is left pressed, and nothing jumps.
#include "executor/trajectory_executor.h"

#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/executor/test_robot.h"

namespace goalnet::executor {
namespace {

using test::kPeriodNs;
using test::TestRobot;
using test::three_joints;
using testing::HasSubstr;

ExecutorParams checked_joints() {
  ExecutorParams params = three_joints();
  for (auto& joint : params.joints) {
    joint.tracking_tolerance = 0.2;
    joint.goal_tolerance = 0.05;
  }
  params.joints[2].tracking_tolerance = params.joints[2].goal_tolerance = 0.0;  // c is a finger
  return params;
}

TEST(TrajectoryExecutor, GivesWayToWhatBlocksAJoint) {
  TestRobot robot(checked_joints());
  robot.cycle();
  robot.disturb = [](JointSample& measured) {
    measured.position[0] = std::min(measured.position[0], 0.3);
    measured.position[2] = std::min(measured.position[2], 0.1);
  };
  ASSERT_TRUE(robot.executor->submit(robot.through({{1.0, 0.5, 0.4}}, 1.0)));
  robot.run_until(ExecutorState::kStopping);
  robot.run_until(ExecutorState::kIdle);
  const ExecutorStatus status = robot.executor->status();
  EXPECT_EQ(status.outcome, Outcome::kMotionFailed);
  EXPECT_THAT(status.message, HasSubstr("joint 'a'"));
  EXPECT_NEAR(robot.command.position[0], 0.3, 1e-9);
  EXPECT_EQ(robot.command.velocity[0], 0.0);
  EXPECT_GT(robot.command.position[1], 0.1) << "what followed stays where the stop ended";
  EXPECT_GT(robot.command.position[2], 0.15) << "a finger goes on gripping";
  EXPECT_EQ(status.guarded_cycles, 0u) << "it stays within the limits by itself";

  // Released, nothing moves; and from here the next trajectory goes through.
  robot.disturb = {};
  const JointSample before = robot.command;
  robot.run(0.5);
  EXPECT_EQ(robot.command.position, before.position);
  ASSERT_TRUE(robot.executor->submit(robot.through({{1.0, 0.5, 0.4}}, 1.0, 2)));
  robot.run_until(ExecutorState::kExecuting, 0.1);
  robot.run_until(ExecutorState::kIdle);
  EXPECT_EQ(robot.executor->status().outcome, Outcome::kDone);
  EXPECT_EQ(robot.command.position[0], 1.0);
}

TEST(TrajectoryExecutor, GivesWayAtAGoalThatWasMissed) {
  TestRobot robot(checked_joints());
  robot.cycle();
  robot.disturb = [](JointSample& measured) { measured.position[0] = std::min(measured.position[0], 0.85); };
  ASSERT_TRUE(robot.executor->submit(robot.through({{1.0, 0.0, 0.0}}, 1.0)));
  robot.run(1.2);
  robot.run_until(ExecutorState::kIdle);
  EXPECT_THAT(robot.executor->status().message, HasSubstr("away from its goal"));
  EXPECT_NEAR(robot.command.position[0], 0.85, 1e-9);
}

// A cancelled motion leaves nothing pressed either, and a robot that stands lets itself be pushed away.
TEST(TrajectoryExecutor, GivesWayAfterAStopAndWhileItStands) {
  TestRobot robot(checked_joints());
  robot.cycle();
  robot.disturb = [](JointSample& measured) { measured.position[0] = std::min(measured.position[0], 0.3); };
  ASSERT_TRUE(robot.executor->submit(robot.through({{1.0, 0.0, 0.0}}, 1.0)));
  while (robot.command.position[0] < 0.36) robot.cycle();
  robot.executor->stop();
  robot.run_until(ExecutorState::kIdle);
  EXPECT_EQ(robot.executor->status().outcome, Outcome::kCancelled);
  EXPECT_NEAR(robot.command.position[0], 0.3, 1e-9);

  robot.disturb = [](JointSample& measured) { measured.position[1] = -0.15; };
  robot.run(1.0);
  EXPECT_EQ(robot.command.position[1], 0.0) << "within the tolerance it holds";
  robot.disturb = [](JointSample& measured) { measured.position[1] = -0.5; };
  robot.run(2.0);
  EXPECT_NEAR(robot.command.position[1], -0.5, 1e-9);
  EXPECT_EQ(robot.executor->status().state, ExecutorState::kIdle);
  EXPECT_THAT(robot.executor->status().message, HasSubstr("joint 'b'"));
}

TEST(TrajectoryExecutor, GivingWayEndsInAFaultWhenItMust) {
  for (const bool emergency : {true, false}) {
    TestRobot robot(checked_joints());
    robot.cycle();
    robot.disturb = [](JointSample& measured) { measured.position[1] = -1.0; };
    robot.run(0.2);
    ASSERT_EQ(robot.executor->status().state, ExecutorState::kStopping);
    if (emergency) {
      robot.executor->emergency_stop();
    } else {
      robot.disturb = [](JointSample& measured) { measured.position[1] = std::nan(""); };
    }
    robot.run_until(ExecutorState::kFault);
    robot.run(0.5);
    EXPECT_EQ(robot.executor->status().outcome, emergency ? Outcome::kEmergencyStop : Outcome::kWorldStale);
    EXPECT_EQ(robot.command.velocity[1], 0.0);
    robot.disturb = {};
    robot.run(0.1);
    robot.executor->reset();
    robot.run(0.1);
    EXPECT_EQ(robot.executor->status().state, ExecutorState::kIdle);
  }
}

// A robot that was pushed while it stood in a fault does not jump back; fingers keep their grip.
TEST(TrajectoryExecutor, RestartsWhereItIsAfterAFault) {
  ExecutorParams params = three_joints();
  params.joints[0].tracking_tolerance = 0.5;  // c has none, like a finger
  TestRobot robot(params);
  robot.run(0.01);
  robot.executor->emergency_stop();
  robot.run(0.01);
  JointSample pushed = robot.measured;
  pushed.position[0] = 0.4;
  pushed.position[2] = 0.01;
  JointSample command = robot.command;
  robot.executor->reset();
  robot.executor->cycle(robot.time_ns + kPeriodNs, pushed, command);
  EXPECT_EQ(robot.executor->status().state, ExecutorState::kIdle);
  EXPECT_EQ(command.position[0], 0.4);
  EXPECT_EQ(command.position[2], 0.0);
}

}  // namespace
}  // namespace goalnet::executor
