// The last stage: whatever is asked for, the limits hold; and what keeps the limits passes unchanged.
#include "executor/limit_guard.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "tests/unit/executor/test_robot.h"

namespace goalnet::executor {
namespace {

constexpr double kDt = 0.001;

// Follows one random target after the other (jumps, noise, NaN, infinity) with steps of random length, and
// checks every command.
TEST(LimitGuard, HoldsAllLimitsAgainstAnyTarget) {
  const auto joints = test::three_joints().joints;
  for (unsigned seed = 1; seed <= 50; ++seed) {
    std::mt19937 random(seed);
    const auto uniform = [&](double low, double high) {
      return low + (high - low) * static_cast<double>(random() % 100'000) / 100'000.0;
    };
    LimitGuard guard(joints);
    JointSample start;
    for (double& position : start.position) position = uniform(-3.0, 3.0);
    guard.reset(start);
    JointSample target = start, before = guard.command();
    std::array<double, 3> velocity{};
    for (int n = 0; n < 3000; ++n) {
      const double dt = seed % 2 == 0 ? kDt : uniform(0.0002, 0.004);
      for (std::size_t j = 0; j < 3; ++j) {
        const auto kind = random() % 200;
        if (kind == 0) target.position[j] = uniform(-6.0, 6.0);
        if (kind == 1) target.position[j] = std::nan("");
        if (kind == 2) target.position[j] = std::numeric_limits<double>::infinity();
        if (kind == 3) target.velocity[j] = std::nan("");
        if (kind > 100) target.position[j] += uniform(-0.002, 0.0021);
      }
      guard.follow(dt, target);
      for (std::size_t j = 0; j < 3; ++j) {
        const double now = guard.command().position[j], v = (now - before.position[j]) / dt;
        ASSERT_LE(std::abs(v), joints[j].velocity + 1e-6) << "seed " << seed << " cycle " << n;
        ASSERT_LE(std::abs(v - velocity[j]), joints[j].acceleration * dt + 1e-6)
            << "seed " << seed << " cycle " << n;
        ASSERT_LE(std::abs(now), 3.0 + 1e-9) << "seed " << seed << " cycle " << n;
        velocity[j] = v;
      }
      before = guard.command();
    }
  }
}

TEST(LimitGuard, PassesGoodTargetsUnchanged) {
  LimitGuard guard(test::three_joints().joints);
  guard.reset(JointSample{});
  for (int n = 1; n < 2000; ++n) {
    const double t = kDt * n;
    JointSample target;
    target.position[0] = 0.2 * (1.0 - std::cos(5.0 * t));  // peaks: 1 rad/s, 5 rad/s^2
    target.velocity[0] = std::sin(5.0 * t);
    EXPECT_FALSE(guard.follow(kDt, target));
    EXPECT_EQ(guard.command().position[0], target.position[0]);
    EXPECT_EQ(guard.command().velocity[0], target.velocity[0]);
  }
}

// A step of the target is turned into the fastest move without overshoot, and then followed exactly again.
TEST(LimitGuard, CatchesUpWithoutOvershoot) {
  LimitGuard guard(test::three_joints().joints);
  guard.reset(JointSample{});
  JointSample target;
  target.position[0] = 1.0;
  int cycles = 0;
  while (guard.lag() > 0.0 || !guard.standing() || cycles == 0) {
    guard.follow(kDt, target);
    ASSERT_LE(guard.command().position[0], 1.0 + 1e-12);
    ASSERT_LT(++cycles, 2000);
  }
  // Bang-bang with 8 up and 4 down (half is kept in reserve): sqrt(2 * 1 * (1/8 + 1/4)) = 0.866 s.
  EXPECT_NEAR(1e-3 * cycles, 0.866, 0.03);
  EXPECT_EQ(guard.command().position[0], 1.0);
  EXPECT_FALSE(guard.follow(kDt, target));
}

TEST(LimitGuard, OnlyMovesInwardFromOutside) {
  LimitGuard guard(test::three_joints().joints);
  JointSample start;
  start.position[0] = 3.5;
  guard.reset(start);
  JointSample target = start;
  target.position[0] = 4.0;
  for (int n = 0; n < 500; ++n) {
    guard.follow(kDt, target);
    EXPECT_LE(guard.command().position[0], 3.5);
  }
  target.position[0] = 2.0;
  for (int n = 0; n < 3000; ++n) guard.follow(kDt, target);
  EXPECT_EQ(guard.command().position[0], 2.0);
}

TEST(LimitGuard, BrakesAtTheLimitOfAcceleration) {
  LimitGuard guard(test::three_joints().joints);
  guard.reset(JointSample{});
  JointSample target;
  for (int n = 1; n < 400; ++n) {
    target.position[0] = 0.001 * n;  // 1 rad/s
    guard.follow(kDt, target);
  }
  int cycles = 0;
  while (!guard.standing()) {
    guard.brake(kDt);
    ASSERT_LT(++cycles, 1000);
  }
  EXPECT_NEAR(cycles, 125, 2);  // 1 rad/s at 8 rad/s^2
}

}  // namespace
}  // namespace goalnet::executor
