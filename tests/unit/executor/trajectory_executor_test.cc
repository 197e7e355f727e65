// The executor as a whole: following, splicing, stopping, faults, and the same bits every time.
#include "executor/trajectory_executor.h"

#include <gmock/gmock.h>
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

// --- giving way ---

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
