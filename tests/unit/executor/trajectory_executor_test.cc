// The executor as a whole: following, splicing, and the same bits every time.
#include "executor/trajectory_executor.h"

#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <random>

#include "tests/unit/executor/test_robot.h"

namespace goalnet::executor {
namespace {

using test::kPeriodNs;
using test::TestRobot;
using test::three_joints;
using testing::HasSubstr;

TEST(TrajectoryExecutor, RefusesBadParameters) {
  const auto refusal = [](auto change) {
    ExecutorParams params = three_joints();
    change(params);
    const auto made = TrajectoryExecutor::create(params);
    return made ? std::string("accepted") : made.error().message;
  };
  EXPECT_EQ(refusal([](auto&) {}), "accepted");
  EXPECT_THAT(refusal([](auto& p) { p.joints.clear(); }), HasSubstr("no joints"));
  EXPECT_THAT(refusal([](auto& p) { p.joints.resize(33, p.joints[0]); }), HasSubstr("at most 32"));
  EXPECT_THAT(refusal([](auto& p) { p.joints[1].name = "a"; }), HasSubstr("name of its own"));
  EXPECT_THAT(refusal([](auto& p) { p.joints[1].velocity = 0.0; }), HasSubstr("joint 'b'"));
  EXPECT_THAT(refusal([](auto& p) { p.joints[1].acceleration = std::nan(""); }),
              HasSubstr("positive and finite"));
  EXPECT_THAT(refusal([](auto& p) { p.joints[1].position_min = 4.0; }), HasSubstr("position_min"));
  EXPECT_THAT(refusal([](auto& p) { p.joints[1].goal_tolerance = -1.0; }), HasSubstr("tolerances"));
  EXPECT_THAT(refusal([](auto& p) { p.period = 0.0; }), HasSubstr("period"));
}

TEST(TrajectoryExecutor, HoldsWhereItStarts) {
  TestRobot robot;
  robot.measured.position = {0.3, -0.4, 0.5};
  robot.run(0.1);
  EXPECT_EQ(robot.command.position[1], -0.4);
  EXPECT_EQ(robot.command.velocity[1], 0.0);
  EXPECT_EQ(robot.executor->status().state, ExecutorState::kIdle);
  EXPECT_EQ(robot.executor->status().cycles, 100u);
}

TEST(TrajectoryExecutor, FollowsToTheEnd) {
  TestRobot robot;
  robot.cycle();
  const auto id = robot.executor->submit(robot.through({{0.5, 0.2, -0.3}, {0.8, 0.1, -0.6}}, 1.0, 77));
  ASSERT_TRUE(id);
  EXPECT_EQ(*id, 1u);
  robot.run(1.0);
  EXPECT_NEAR(robot.command.position[0], 0.5, 1e-12);  // through the points, on time
  EXPECT_EQ(robot.executor->status().state, ExecutorState::kExecuting);
  EXPECT_NEAR(robot.executor->status().progress, 0.5, 1e-9);
  robot.run_until(ExecutorState::kIdle);
  const ExecutorStatus status = robot.executor->status();
  EXPECT_EQ(robot.command.position[0], 0.8);
  EXPECT_EQ(robot.command.position[2], -0.6);
  EXPECT_EQ(status.outcome, Outcome::kDone);
  EXPECT_EQ(status.trajectory_id, 1u);
  EXPECT_EQ(status.trajectory_stamp_ns, 77);
  EXPECT_EQ(status.progress, 1.0);
  EXPECT_EQ(status.guarded_cycles, 0u);
}

TEST(TrajectoryExecutor, LeavesJointsAloneThatAreNotNamed) {
  TestRobot robot;
  robot.measured.position = {0.1, 0.2, 0.3};
  robot.cycle();
  JointTrajectory only_b;
  only_b.joints = {"b"};
  only_b.points = {{0, {0.2}, {}}, {1'000'000'000, {0.7}, {}}};
  ASSERT_TRUE(robot.executor->submit(only_b));
  robot.run_until(ExecutorState::kIdle);
  EXPECT_EQ(robot.command.position[0], 0.1);
  EXPECT_EQ(robot.command.position[1], 0.7);
  EXPECT_EQ(robot.command.position[2], 0.3);
}

TEST(TrajectoryExecutor, RefusesToStartElsewhere) {
  TestRobot robot;
  robot.cycle();
  JointTrajectory elsewhere = robot.through({{0.5, 0.0, 0.0}}, 1.0, 5);
  elsewhere.points[0].position[1] = 0.2;  // tolerance 0.05
  ASSERT_TRUE(robot.executor->submit(elsewhere));
  robot.run(0.01);
  ExecutorStatus status = robot.executor->status();
  EXPECT_EQ(status.state, ExecutorState::kIdle);
  EXPECT_EQ(status.rejections, 1u);
  EXPECT_EQ(status.rejected_stamp_ns, 5);
  EXPECT_EQ(status.rejected_outcome, Outcome::kInvalidRequest);
  EXPECT_THAT(status.rejected_message, HasSubstr("0.200 away from the command of joint 'b'"));
  EXPECT_EQ(robot.command.position[0], 0.0);

  // A first point that cannot be reached in the time left for it.
  elsewhere.points[0] = {10'000'000, {0.0, 1.0, 0.0}, {}};
  ASSERT_TRUE(robot.executor->submit(elsewhere));
  robot.run(0.01);
  EXPECT_EQ(robot.executor->status().rejections, 2u);
}

TEST(TrajectoryExecutor, BlendsASmallDifferenceAway) {
  TestRobot robot;
  robot.cycle();
  JointTrajectory trajectory = robot.through({{0.5, 0.0, 0.0}}, 1.0);
  trajectory.points[0].position[0] = 0.04;
  ASSERT_TRUE(robot.executor->submit(trajectory));
  robot.run_until(ExecutorState::kIdle);  // the robot checks the limits in every cycle
  EXPECT_EQ(robot.command.position[0], 0.5);
}

TEST(TrajectoryExecutor, MovesToAFirstPointInTheFuture) {
  TestRobot robot;
  robot.cycle();
  JointTrajectory trajectory;
  trajectory.joints = {"a"};
  trajectory.points = {{1'000'000'000, {0.6}, {}}, {2'000'000'000, {1.0}, {}}};
  ASSERT_TRUE(robot.executor->submit(trajectory));
  robot.run(1.0);
  EXPECT_NEAR(robot.command.position[0], 0.6, 1e-9);
  robot.run_until(ExecutorState::kIdle);
  EXPECT_EQ(robot.command.position[0], 1.0);
}

TEST(TrajectoryExecutor, TurnsContinuousJointsTheShortWay) {
  ExecutorParams params = three_joints();
  params.joints[0].continuous = true;
  params.joints[0].position_min = -std::numeric_limits<double>::infinity();
  params.joints[0].position_max = std::numeric_limits<double>::infinity();
  TestRobot robot(params);
  const double turns = 6.0 * std::numbers::pi;
  robot.measured.position[0] = turns + 0.1;
  robot.cycle();
  JointTrajectory trajectory;
  trajectory.joints = {"a"};
  trajectory.points = {{0, {0.1}, {}}, {1'000'000'000, {0.6}, {}}};
  ASSERT_TRUE(robot.executor->submit(trajectory));
  robot.run_until(ExecutorState::kIdle);
  EXPECT_NEAR(robot.command.position[0], turns + 0.6, 1e-9);
  EXPECT_EQ(robot.executor->status().rejections, 0u);
}

TEST(TrajectoryExecutor, SplicesANewTrajectoryIntoARunningOne) {
  TestRobot robot;
  robot.cycle();
  ASSERT_TRUE(robot.executor->submit(robot.through({{1.0, 1.0, 1.0}}, 1.0)));
  robot.run(0.5);  // at full speed now
  const double speed = robot.command.velocity[0];
  EXPECT_GT(speed, 1.0);
  JointTrajectory back = robot.through({{0.2, 0.0, 0.0}}, 1.5, 2);
  back.joints.pop_back();  // joint c slows down on its own
  for (TrajectoryPoint& point : back.points) point.position.pop_back();
  ASSERT_TRUE(robot.executor->submit(back));
  robot.cycle();
  EXPECT_NEAR(robot.command.velocity[0], speed, 0.05);
  robot.run_until(ExecutorState::kIdle);
  EXPECT_EQ(robot.executor->status().trajectory_id, 2u);
  EXPECT_NEAR(robot.command.position[0], 0.2, 1e-12);
  EXPECT_GT(robot.command.position[2], 0.5);
  EXPECT_LT(robot.command.position[2], 1.0);
}

TEST(TrajectoryExecutor, CapsWhatAPlanAsksTooMuchOf) {
  TestRobot robot;
  robot.cycle();
  // 0.9 rad in 0.5 s and at rest at both ends: the cubic needs 21 rad/s^2 where 8 are allowed.
  ASSERT_TRUE(robot.executor->submit(robot.through({{0.9, 0.0, 0.0}}, 0.5)));
  robot.run_until(ExecutorState::kIdle);
  EXPECT_EQ(robot.command.position[0], 0.9);
  EXPECT_GT(robot.executor->status().guarded_cycles, 0u);
}

TEST(TrajectoryExecutor, SurvivesLateAndRepeatedCycles) {
  TestRobot robot;
  robot.cycle();
  ASSERT_TRUE(robot.executor->submit(robot.through({{1.0, 0.5, 0.0}}, 1.0)));
  robot.run(0.5);
  robot.cycle(0);               // the same time again: nothing moves
  robot.cycle(50 * kPeriodNs);  // a stall: no jump (limits are checked by the robot)
  const ExecutorStatus status = robot.executor->status();
  EXPECT_EQ(status.overruns, 1u);
  EXPECT_NEAR(status.progress, 0.504, 1e-6);  // a stall counts as four periods at most
}

TEST(TrajectoryExecutor, RefusesMoreThanTheLoopCanTake) {
  TestRobot robot;
  robot.cycle();
  const JointTrajectory trajectory = robot.through({{0.1, 0.0, 0.0}}, 1.0);
  int accepted = 0;
  while (robot.executor->submit(trajectory)) ASSERT_LT(++accepted, 1000);
  EXPECT_EQ(accepted, 64);
  const auto refused = robot.executor->submit(trajectory);
  EXPECT_EQ(refused.error().outcome, Outcome::kBusy);
  robot.cycle();
  EXPECT_TRUE(robot.executor->submit(trajectory));
}

// The same calls give the same bits: random trajectories, stops and disturbances, twice.
TEST(TrajectoryExecutor, IsBitDeterministic) {
  const auto record = [](unsigned seed) {
    std::mt19937 random(seed);
    TestRobot robot;
    std::vector<JointSample> commands;
    for (int n = 0; n < 4000; ++n) {
      const auto kind = random() % 400;
      const auto goal = [&] { return static_cast<double>(random() % 2000) / 1000.0 - 1.0; };
      if (kind < 4) static_cast<void>(robot.executor->submit(robot.through({{goal(), goal(), goal()}}, 1.5)));
      if (kind == 4) robot.executor->stop();
      if (kind == 5) robot.executor->emergency_stop();
      if (kind == 6) robot.executor->reset();
      robot.cycle();
      commands.push_back(robot.command);
    }
    return commands;
  };
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const auto once = record(seed), again = record(seed);
    for (std::size_t n = 0; n < once.size(); ++n) {
      ASSERT_EQ(std::memcmp(&once[n].position, &again[n].position, sizeof once[n].position), 0);
      ASSERT_EQ(std::memcmp(&once[n].velocity, &again[n].velocity, sizeof once[n].velocity), 0);
    }
    EXPECT_NE(once.back().position, once.front().position);  // it did move
  }
}

}  // namespace
}  // namespace goalnet::executor
