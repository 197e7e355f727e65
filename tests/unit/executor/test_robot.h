// A robot for tests: some joints that follow their commands perfectly (unless told otherwise), and a watcher
// that checks every single command against the limits.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "executor/trajectory_executor.h"

namespace goalnet::executor::test {

inline constexpr std::int64_t kPeriodNs = 1'000'000;

inline ExecutorParams three_joints() {
  ExecutorParams params;
  for (const char* name : {"a", "b", "c"}) {
    JointLimits joint;
    joint.name = name;
    joint.position_min = -3.0;
    joint.position_max = 3.0;
    joint.velocity = 2.0;
    joint.acceleration = 8.0;
    joint.start_tolerance = 0.05;
    params.joints.push_back(joint);
  }
  return params;
}

class TestRobot {
 public:
  explicit TestRobot(ExecutorParams params = three_joints()) : params_(params) {
    auto made = TrajectoryExecutor::create(std::move(params));
    if (!made) throw std::runtime_error(made.error().message);
    executor = std::move(*made);
  }

  // One period: the plant moves to the last command, then the executor runs. Checks the limits.
  void cycle(std::int64_t dt_ns = kPeriodNs) {
    time_ns += dt_ns;
    if (commanded_) {
      measured.position = command.position;
      measured.velocity = command.velocity;
    }
    if (disturb) disturb(measured);
    const JointSample before = command;
    executor->cycle(time_ns, measured, command);
    // After a stall the motion goes on by four periods at most; such steps are judged as that long.
    if (commanded_ && dt_ns > 0)
      check_limits(before, 1e-9 * static_cast<double>(std::min(dt_ns, 4 * kPeriodNs)));
    commanded_ = true;
  }

  void run(double seconds) {
    for (int n = 0; n < std::lround(seconds * 1000.0); ++n) cycle();
  }

  // Until the state is reached; fails the test after `limit` seconds.
  void run_until(ExecutorState state, double limit = 10.0) {
    for (int n = 0; n < std::lround(limit * 1000.0); ++n) {
      cycle();
      if (executor->status().state == state) return;
    }
    ADD_FAILURE() << "state not reached within " << limit << " s";
  }

  // A trajectory through positions of all joints, `step` seconds apart, beginning with the current command.
  JointTrajectory through(std::vector<std::vector<double>> positions, double step,
                          std::int64_t stamp = 1) const {
    JointTrajectory trajectory;
    trajectory.stamp_ns = stamp;
    for (const JointLimits& joint : params_.joints) trajectory.joints.push_back(joint.name);
    std::vector<double> here(command.position.begin(), command.position.begin() + params_.joints.size());
    positions.insert(positions.begin(), here);
    for (std::size_t k = 0; k < positions.size(); ++k)
      trajectory.points.push_back(
          {static_cast<std::int64_t>(std::llround(1e9 * step * static_cast<double>(k))), positions[k],
           std::vector<double>()});
    return trajectory;
  }

  std::unique_ptr<TrajectoryExecutor> executor;
  JointSample measured, command;
  std::int64_t time_ns = 1'000'000'000;
  std::function<void(JointSample&)> disturb;  // changes what is measured
  double largest_acceleration = 0.0;          // relative to the limit, so far

 private:
  void check_limits(const JointSample& before, double dt) {
    for (std::size_t j = 0; j < params_.joints.size(); ++j) {
      const JointLimits& limits = params_.joints[j];
      const double velocity = (command.position[j] - before.position[j]) / dt;
      const double acceleration = (velocity - velocity_[j]) / dt;
      velocity_[j] = velocity;
      largest_acceleration = std::max(largest_acceleration, std::abs(acceleration) / limits.acceleration);
      ASSERT_TRUE(std::isfinite(command.position[j]) && std::isfinite(command.velocity[j]));
      ASSERT_LE(std::abs(velocity), limits.velocity + 1e-6) << limits.name;
      ASSERT_LE(std::abs(acceleration), limits.acceleration * (1.0 + 1e-5) + 1e-5) << limits.name;
      ASSERT_GE(command.position[j], limits.position_min - 1e-9) << limits.name;
      ASSERT_LE(command.position[j], limits.position_max + 1e-9) << limits.name;
    }
  }

  ExecutorParams params_;
  std::array<double, kMaxJoints> velocity_{};
  bool commanded_ = false;
};

}  // namespace goalnet::executor::test
