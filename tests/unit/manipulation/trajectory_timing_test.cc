#include "components/manipulation/trajectory_timing.h"

#include <cmath>

#include <gtest/gtest.h>

namespace goalnet::manipulation {
namespace {

TimedJoints two_joints() {
  TimedJoints joints;
  joints.names = {"a", "b"};
  joints.velocity = JointVector::Constant(2, 1.5);
  joints.acceleration = JointVector::Constant(2, 4.0);
  return joints;
}

// Velocity and acceleration limits hold between all points, times increase, and both ends are at rest.
void expect_within_limits(const JointTrajectory& t, const TimedJoints& joints, double slack) {
  ASSERT_GE(t.points.size(), 2u);
  for (std::size_t j = 0; j < joints.names.size(); ++j) {
    EXPECT_NEAR(t.points.front().velocity[j], 0, 1e-9);
    EXPECT_NEAR(t.points.back().velocity[j], 0, 1e-9);
    const auto k = static_cast<Eigen::Index>(j);
    for (std::size_t i = 1; i < t.points.size(); ++i) {
      const double dt = static_cast<double>(t.points[i].time_ns - t.points[i - 1].time_ns) * 1e-9;
      ASSERT_GT(dt, 0);
      EXPECT_LE(std::abs(t.points[i].velocity[j]), joints.velocity[k] * (1 + 1e-6));
      const double a = (t.points[i].velocity[j] - t.points[i - 1].velocity[j]) / dt;
      EXPECT_LE(std::abs(a), joints.acceleration[k] * slack) << "point " << i << " joint " << j;
    }
  }
}

TEST(TrajectoryTiming, StraightMotionTakesTheTimeOfATrapezoid) {
  const auto joints = two_joints();
  const JointVector from = JointVector::Zero(2), to = (JointVector(2) << 3.0, -1.0).finished();
  const auto t = time_straight(joints, from, to);
  expect_within_limits(t, joints, 1.01);
  EXPECT_NEAR(duration_s(t), 3.0 / 1.5 + 1.5 / 4.0, 0.02);  // way / speed + speed / acceleration
  EXPECT_DOUBLE_EQ(t.points.back().position[0], 3.0);
  EXPECT_DOUBLE_EQ(t.points.back().position[1], -1.0);
}

TEST(TrajectoryTiming, NoWayNoPoints) {
  const auto joints = two_joints();
  EXPECT_TRUE(time_straight(joints, JointVector::Ones(2), JointVector::Ones(2)).points.empty());
  EXPECT_TRUE(time_path(joints, {JointVector::Ones(2), JointVector::Ones(2)}).points.empty());
  EXPECT_TRUE(time_path(joints, {}).points.empty());
}

TEST(TrajectoryTiming, TinyMotionsOfTwoPointsHaveTimesToo) {
  const auto joints = two_joints();
  for (const double way : {3e-5, 1e-3, 0.5}) {
    const auto t = time_path(joints, {JointVector::Zero(2), JointVector::Constant(2, way)});
    expect_within_limits(t, joints, 1.15);
    EXPECT_GT(duration_s(t), 0.0);
    EXPECT_LT(duration_s(t), 2.0);
    EXPECT_DOUBLE_EQ(t.points.back().position[1], way);
  }
}

TEST(TrajectoryTiming, RoundedCornersKeepTheLimits) {
  const auto joints = two_joints();
  const JointVector scale = joints.velocity.cwiseInverse();
  const JointPath corners = {(JointVector(2) << 0, 0).finished(), (JointVector(2) << 1, 0).finished(),
                             (JointVector(2) << 1, 1).finished(), (JointVector(2) << -0.5, 1.2).finished()};
  const auto path = round_corners(corners, scale, 0.25, 0.01, [](const JointVector&) { return true; });
  const auto t = time_path(joints, path);
  expect_within_limits(t, joints, 1.15);  // finite differences across the ends of a parabola
  EXPECT_NEAR(t.points.back().position[0], -0.5, 1e-9);
  // Faster than stopping at each corner.
  double stopping = 0;
  for (std::size_t i = 1; i < corners.size(); ++i)
    stopping += duration_s(time_straight(joints, corners[i - 1], corners[i]));
  EXPECT_LT(duration_s(t), stopping);
}

TEST(TrajectoryTiming, ACornerWithoutRoomIsKept) {
  const auto joints = two_joints();
  const JointVector scale = joints.velocity.cwiseInverse();
  const JointPath corners = {(JointVector(2) << 0, 0).finished(), (JointVector(2) << 1, 0).finished(),
                             (JointVector(2) << 1, 1).finished()};
  const auto on_legs = [](const JointVector& q) {
    return std::abs(q[1]) < 1e-9 || std::abs(q[0] - 1) < 1e-9;
  };
  const auto path = round_corners(corners, scale, 0.25, 0.02, on_legs);
  for (const auto& q : path) EXPECT_TRUE(on_legs(q)) << q.transpose();
  const auto t = time_path(joints, path);
  // Also between its points, where the executor follows cubics: a corner taken at speed would swing out.
  expect_within_limits(t, joints, 1.15);
  for (std::size_t i = 1; i < t.points.size(); ++i) {
    const auto &a = t.points[i - 1], &b = t.points[i];
    const double h = static_cast<double>(b.time_ns - a.time_ns) * 1e-9;
    JointVector middle(2);
    for (std::size_t j = 0; j < 2; ++j)
      middle[static_cast<Eigen::Index>(j)] =
          0.5 * (a.position[j] + b.position[j]) + h / 8 * (a.velocity[j] - b.velocity[j]);
    EXPECT_LT(std::min(std::abs(middle[1]), std::abs(middle[0] - 1)), 1e-9) << middle.transpose();
  }
}

TEST(TrajectoryTiming, ACurveKeepsSharpCornersOfItsPoints) {
  JointPath points;
  for (int i = 0; i <= 10; ++i) points.push_back((JointVector(2) << 0.1 * i, 0.0).finished());
  for (int i = 1; i <= 10; ++i) points.push_back((JointVector(2) << 1.0 - 0.02 * i, 0.1 * i).finished());
  for (const auto& q : through_points(points, JointVector::Ones(2), 0.01)) {
    EXPECT_LE(q[0], 1.0 + 1e-12) << "it swings out over the corner";
    EXPECT_GE(q[1], -1e-12);
  }
}

TEST(TrajectoryTiming, CurveGoesThroughItsPoints) {
  JointPath points;
  for (int i = 0; i <= 10; ++i) points.push_back((JointVector(2) << 0.1 * i, std::sin(0.3 * i)).finished());
  const auto path = through_points(points, JointVector::Ones(2), 0.01);
  for (const auto& p : points) {
    double nearest = 1;
    for (const auto& q : path) nearest = std::min(nearest, (p - q).norm());
    EXPECT_LT(nearest, 1e-9);
  }
}

TEST(TrajectoryTiming, MergedMotionsRunTogether) {
  TimedJoints one = two_joints(), other;
  other.names = {"finger"};
  other.velocity = JointVector::Constant(1, 0.15);
  other.acceleration = JointVector::Constant(1, 2.0);
  const auto a = time_straight(one, JointVector::Zero(2), JointVector::Ones(2));
  const auto b = time_straight(other, JointVector::Zero(1), JointVector::Constant(1, 0.03));
  const auto t = merge(a, b);
  ASSERT_EQ(t.joints.size(), 3u);
  EXPECT_EQ(duration_s(t), duration_s(a));
  EXPECT_NEAR(t.points.back().position[2], 0.03, 1e-12);
  EXPECT_NEAR(t.points.front().position[2], 0.0, 1e-12);
}

}  // namespace
}  // namespace goalnet::manipulation
