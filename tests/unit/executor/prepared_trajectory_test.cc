// What submit() refuses and how trajectories are sampled.
#include "executor/prepared_trajectory.h"

#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/unit/executor/test_robot.h"

namespace goalnet::executor {
namespace {

using testing::HasSubstr;

JointTrajectory good() {
  JointTrajectory trajectory;
  trajectory.joints = {"b", "a"};
  trajectory.points = {{0, {0.0, 0.0}, {0.0, 0.0}},
                       {500'000'000, {0.3, -0.2}, {0.5, -0.4}},
                       {1'000'000'000, {0.6, -0.5}, {0.0, 0.0}}};
  return trajectory;
}

std::string refusal(const JointTrajectory& trajectory) {
  const auto prepared = PreparedTrajectory::prepare(trajectory, test::three_joints());
  if (prepared) return "accepted";
  EXPECT_EQ(prepared.error().outcome, Outcome::kInvalidRequest);
  return prepared.error().message;
}

TEST(PreparedTrajectory, RefusesWithTheReason) {
  EXPECT_EQ(refusal(good()), "accepted");
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  const auto with = [](auto change) {
    JointTrajectory trajectory = good();
    change(trajectory);
    return refusal(trajectory);
  };
  EXPECT_THAT(with([](auto& t) { t.joints.clear(); }), HasSubstr("names no joint"));
  EXPECT_THAT(with([](auto& t) { t.joints[0] = "nose"; }), HasSubstr("no joint 'nose'"));
  EXPECT_THAT(with([](auto& t) { t.joints[0] = "a"; }), HasSubstr("named twice"));
  EXPECT_THAT(with([](auto& t) { t.points.clear(); }), HasSubstr("no points"));
  EXPECT_THAT(with([](auto& t) { t.points.resize(100'001, t.points[0]); }), HasSubstr("at most"));
  EXPECT_THAT(with([](auto& t) { t.points[1].position.pop_back(); }), HasSubstr("1 positions for 2 joints"));
  EXPECT_THAT(with([](auto& t) { t.points[1].velocity.pop_back(); }), HasSubstr("1 velocities for 2 joints"));
  EXPECT_THAT(with([](auto& t) { t.points[0].time_ns = -1; }), HasSubstr("not later"));
  EXPECT_THAT(with([](auto& t) { t.points[2].time_ns = t.points[1].time_ns; }),
              HasSubstr("point 2 is not later"));
  EXPECT_THAT(with([](auto& t) { t.points[2].time_ns = INT64_MAX; }), HasSubstr("more than an hour"));
  EXPECT_THAT(with([&](auto& t) { t.points[1].position[1] = nan; }),
              HasSubstr("joint 'a': position is not a number"));
  EXPECT_THAT(with([&](auto& t) { t.points[1].position[1] = inf; }), HasSubstr("not a number"));
  EXPECT_THAT(with([&](auto& t) { t.points[1].velocity[0] = nan; }), HasSubstr("velocity is not a number"));
  EXPECT_THAT(with([](auto& t) { t.points[1].velocity[0] = 2.1; }),
              HasSubstr("velocity 2.1 exceeds the limit 2"));
  EXPECT_THAT(with([](auto& t) { t.points[2].position[0] = 3.2; }), HasSubstr("outside [-3, 3]"));
  EXPECT_THAT(with([](auto& t) { t.points[2].position[0] = 2.9; }), HasSubstr("needs 5.2 per second"));
  EXPECT_THAT(with([](auto& t) { t.points[2].velocity[0] = 0.5; }), HasSubstr("end at standstill"));
}

// A drive of no length: the same point twice at time 0.
TEST(PreparedTrajectory, TakesRepeatedPoints) {
  JointTrajectory trajectory = good();
  trajectory.points.insert(trajectory.points.begin(), trajectory.points.front());
  EXPECT_EQ(refusal(trajectory), "accepted");
  trajectory.points.resize(2);
  EXPECT_EQ(refusal(trajectory), "accepted");
  trajectory.points[1].position[0] += 0.01;
  EXPECT_THAT(refusal(trajectory), HasSubstr("not later"));
}

TEST(PreparedTrajectory, InterpolatesByCubics) {
  const auto prepared = PreparedTrajectory::prepare(good(), test::three_joints()).value();
  EXPECT_EQ(prepared->joint(0), 1u);
  EXPECT_EQ(prepared->joint(1), 0u);
  // At the points: the numbers given.
  for (const TrajectoryPoint& point : good().points) {
    const auto sample = prepared->sample(0, point.time_ns, prepared->find_segment(point.time_ns, 0));
    EXPECT_NEAR(sample.position, point.position[0], 1e-15);
    EXPECT_NEAR(sample.velocity, point.velocity[0], 1e-15);
  }
  // Half-way between two points: the mean, and an eighth of the difference of the slopes.
  const auto half = prepared->sample(0, 250'000'000, 0);
  EXPECT_NEAR(half.position, 0.15 + 0.5 * (0.0 - 0.5) / 8.0, 1e-12);
  // The velocity is the derivative of the position.
  for (std::int64_t t = 10'000'000; t < 990'000'000; t += 7'000'000) {
    const auto at = [&](std::int64_t time) {
      return prepared->sample(1, time, prepared->find_segment(time, 1));
    };
    EXPECT_NEAR(at(t).velocity, (at(t + 1000).position - at(t - 1000).position) / 2e-6, 1e-5);
  }
  // Before and after: standing at the ends.
  EXPECT_EQ(prepared->sample(0, -5, 0).position, 0.0);
  EXPECT_EQ(prepared->sample(0, 2'000'000'000, 1).position, 0.6);
  EXPECT_EQ(prepared->sample(0, 2'000'000'000, 1).velocity, 0.0);
}

TEST(PreparedTrajectory, FindsSegmentsFromAnyHint) {
  JointTrajectory trajectory;
  trajectory.joints = {"a"};
  for (int k = 0; k <= 20; ++k) trajectory.points.push_back({k * 10'000'000LL, {0.001 * k}, {}});
  const auto prepared = PreparedTrajectory::prepare(trajectory, test::three_joints()).value();
  for (std::int64_t time = 0; time < 200'000'000; time += 3'000'000)
    for (std::size_t hint : {0u, 3u, 19u, 1000u})
      EXPECT_EQ(prepared->find_segment(time, hint), static_cast<std::size_t>(time / 10'000'000));
}

// Without velocities the slopes are chosen so that the path never leaves the range of its points.
TEST(PreparedTrajectory, ChoosesSlopesWithoutOvershoot) {
  JointTrajectory trajectory;
  trajectory.joints = {"a"};
  const std::vector<double> positions = {0.0, 0.1, 0.9, 1.0, 1.0, 0.2, 0.2, 0.25};
  for (std::size_t k = 0; k < positions.size(); ++k)
    trajectory.points.push_back({static_cast<std::int64_t>(k) * 1'000'000'000, {positions[k]}, {}});
  const auto prepared = PreparedTrajectory::prepare(trajectory, test::three_joints()).value();
  for (std::int64_t t = 0; t < 7'000'000'000; t += 10'000'000) {
    const auto k = prepared->find_segment(t, 0);
    const double low = std::min(positions[k], positions[k + 1]),
                 high = std::max(positions[k], positions[k + 1]);
    const double position = prepared->sample(0, t, k).position;
    EXPECT_GE(position, low - 1e-12);
    EXPECT_LE(position, high + 1e-12);
  }
}

}  // namespace
}  // namespace goalnet::executor
