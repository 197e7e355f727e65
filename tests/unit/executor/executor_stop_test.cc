// How the executor stops: smoothly on the path, hard in an emergency, and when something is wrong.
#include "executor/trajectory_executor.h"

#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/executor/test_robot.h"

namespace goalnet::executor {
namespace {

using test::TestRobot;
using test::three_joints;
using testing::HasSubstr;

TEST(TrajectoryExecutor, StopsSmoothlyOnThePath) {
  for (double when : {0.05, 0.2, 0.5, 0.8, 0.97}) {
    TestRobot robot;
    robot.cycle();
    ASSERT_TRUE(robot.executor->submit(robot.through({{1.0, 0.5, -0.25}}, 1.0)));
    robot.run(when);
    std::array<double, 3> speed;
    for (int j = 0; j < 3; ++j) speed[j] = robot.command.velocity[j];
    robot.executor->stop();
    int cycles = 0;
    double jerk = 0.0, previous = 0.0;
    do {
      const double before = robot.command.velocity[0];
      robot.cycle();
      // All joints stay on the line from start to goal.
      EXPECT_NEAR(robot.command.position[1], 0.5 * robot.command.position[0], 1e-9);
      EXPECT_NEAR(robot.command.position[2], -0.25 * robot.command.position[0], 1e-9);
      const double acceleration = (robot.command.velocity[0] - before) / 0.001;
      if (cycles > 0) jerk = std::max(jerk, std::abs(acceleration - previous) / 0.001);
      previous = acceleration;
      ASSERT_LT(++cycles, 1000);
    } while (robot.executor->status().state == ExecutorState::kStopping);
    EXPECT_LT(jerk, 1000.0) << when;  // no step of acceleration: 8 rad/s^2 within a cycle would be 8000
    EXPECT_LT(cycles, 700) << when;
    EXPECT_EQ(robot.executor->status().state, ExecutorState::kIdle);
    EXPECT_EQ(robot.executor->status().outcome, Outcome::kCancelled);
    EXPECT_EQ(robot.command.velocity[0], 0.0);
    const auto resting = robot.command.position;
    robot.run(0.1);
    EXPECT_EQ(robot.command.position, resting);
  }
}

TEST(TrajectoryExecutor, TakesNothingWhileStopping) {
  TestRobot robot;
  robot.cycle();
  ASSERT_TRUE(robot.executor->submit(robot.through({{1.0, 0.5, 0.0}}, 1.0)));
  robot.run(0.5);
  robot.executor->stop();
  robot.cycle();
  ASSERT_TRUE(robot.executor->submit(robot.through({{0.0, 0.0, 0.0}}, 1.0, 9)));
  robot.cycle();
  EXPECT_EQ(robot.executor->status().rejected_stamp_ns, 9);
  EXPECT_EQ(robot.executor->status().rejected_outcome, Outcome::kBusy);
  robot.run_until(ExecutorState::kIdle);
  ASSERT_TRUE(robot.executor->submit(robot.through({{0.0, 0.0, 0.0}}, 2.0, 10)));
  robot.run_until(ExecutorState::kExecuting, 0.01);
}

// A trajectory and a stop in the same period: the stop came later and wins.
TEST(TrajectoryExecutor, StopsWhatWasJustSubmitted) {
  TestRobot robot;
  robot.cycle();
  ASSERT_TRUE(robot.executor->submit(robot.through({{1.0, 0.5, 0.0}}, 1.0)));
  robot.executor->stop();
  robot.run(0.01);
  EXPECT_EQ(robot.executor->status().state, ExecutorState::kIdle);
  EXPECT_EQ(robot.executor->status().outcome, Outcome::kCancelled);
  EXPECT_NEAR(robot.command.position[0], 0.0, 1e-3);
}

TEST(TrajectoryExecutor, BrakesHardInAnEmergency) {
  TestRobot robot;
  robot.cycle();
  ASSERT_TRUE(robot.executor->submit(robot.through({{1.0, 0.5, 0.0}}, 1.0)));
  robot.run(0.5);
  const double speed = robot.command.velocity[0];
  robot.executor->emergency_stop();
  robot.cycle();
  EXPECT_EQ(robot.executor->status().state, ExecutorState::kFault);
  EXPECT_EQ(robot.executor->status().outcome, Outcome::kEmergencyStop);
  EXPECT_NEAR(robot.command.velocity[0], speed - 0.008, 1e-3);
  robot.executor->reset();  // still moving: not yet
  robot.cycle();
  EXPECT_EQ(robot.executor->status().state, ExecutorState::kFault);
  robot.run(0.3);
  EXPECT_EQ(robot.command.velocity[0], 0.0);
  ASSERT_TRUE(robot.executor->submit(robot.through({{0.0, 0.0, 0.0}}, 1.0)));
  robot.run(0.1);
  EXPECT_EQ(robot.command.velocity[0], 0.0);
  EXPECT_EQ(robot.executor->status().rejected_outcome, Outcome::kBusy);
  robot.executor->reset();
  robot.cycle();
  EXPECT_EQ(robot.executor->status().state, ExecutorState::kIdle);
  ASSERT_TRUE(robot.executor->submit(robot.through({{0.0, 0.0, 0.0}}, 2.0)));
  robot.run_until(ExecutorState::kExecuting, 0.01);
  robot.run_until(ExecutorState::kIdle);
  EXPECT_EQ(robot.executor->status().outcome, Outcome::kDone);
}

TEST(TrajectoryExecutor, StopsWhenMeasurementsEnd) {
  for (const bool as_nan : {false, true}) {
    TestRobot robot;
    robot.cycle();
    ASSERT_TRUE(robot.executor->submit(robot.through({{1.0, 0.5, 0.0}}, 1.0)));
    robot.run(0.4);
    const std::int64_t last = robot.time_ns;
    robot.disturb = [&](JointSample& measured) {
      if (as_nan)
        measured.position[1] = std::nan("");
      else
        measured.time_ns = last;
    };
    robot.run(0.09);
    EXPECT_EQ(robot.executor->status().state, ExecutorState::kExecuting);
    robot.run(0.02);
    EXPECT_EQ(robot.executor->status().state, ExecutorState::kStopping);
    robot.run_until(ExecutorState::kFault, 1.0);
    EXPECT_EQ(robot.executor->status().outcome, Outcome::kWorldStale);
    EXPECT_THAT(robot.executor->status().message, HasSubstr("no valid joint measurement"));
    robot.executor->reset();
    robot.run(0.01);
    if (as_nan) {
      EXPECT_EQ(robot.executor->status().state, ExecutorState::kFault);
    }
    robot.disturb = nullptr;
    robot.measured.time_ns = 0;
    robot.executor->reset();
    robot.run(0.01);
    EXPECT_EQ(robot.executor->status().state, ExecutorState::kIdle);
  }
}

TEST(TrajectoryExecutor, NeverMovesBeforeTheFirstMeasurement) {
  TestRobot robot;
  robot.disturb = [](JointSample& measured) { measured.position[0] = std::nan(""); };
  robot.command.position[0] = 42.0;
  robot.executor->cycle(1, JointSample{.position = {std::nan("")}}, robot.command);
  EXPECT_EQ(robot.command.position[0], 42.0);
  ASSERT_TRUE(robot.executor->submit(JointTrajectory{1, {"a"}, {{0, {0.0}, {}}}}));
  robot.executor->cycle(2, JointSample{.position = {std::nan("")}}, robot.command);
  EXPECT_EQ(robot.executor->status().rejected_outcome, Outcome::kBusy);
}

TEST(TrajectoryExecutor, StopsWhenAJointDoesNotFollow) {
  ExecutorParams params = three_joints();
  params.joints[0].tracking_tolerance = 0.2;
  TestRobot robot(params);
  robot.cycle();
  robot.disturb = [](JointSample& measured) { measured.position[0] = std::min(measured.position[0], 0.3); };
  ASSERT_TRUE(robot.executor->submit(robot.through({{1.0, 0.5, 0.0}}, 1.0)));
  robot.run_until(ExecutorState::kStopping);
  robot.run_until(ExecutorState::kIdle);
  EXPECT_EQ(robot.executor->status().outcome, Outcome::kMotionFailed);
  EXPECT_THAT(robot.executor->status().message, HasSubstr("joint 'a'"));
  EXPECT_LT(robot.command.position[0], 1.0);
}

TEST(TrajectoryExecutor, ReportsAMissedGoal) {
  ExecutorParams params = three_joints();
  params.joints[0].goal_tolerance = 0.02;
  TestRobot robot(params);
  robot.cycle();
  robot.disturb = [](JointSample& measured) { measured.position[0] = std::min(measured.position[0], 0.9); };
  ASSERT_TRUE(robot.executor->submit(robot.through({{1.0, 0.5, 0.0}}, 1.0)));
  robot.run(1.3);
  EXPECT_EQ(robot.executor->status().state, ExecutorState::kExecuting);  // settling
  robot.run_until(ExecutorState::kIdle, 0.5);
  EXPECT_EQ(robot.executor->status().outcome, Outcome::kMotionFailed);
  EXPECT_THAT(robot.executor->status().message, HasSubstr("0.100 away from its goal"));
}

}  // namespace
}  // namespace goalnet::executor
