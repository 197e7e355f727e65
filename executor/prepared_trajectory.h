// A trajectory that has been checked and laid out for the real-time thread: sampling it never allocates.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "components/core/outcome.h"
#include "executor/executor_params.h"
#include "executor/joint_trajectory.h"

namespace goalnet::executor {

// Immutable once made. Made and destroyed outside the real-time thread, sampled inside it.
class PreparedTrajectory {
 public:
  // Fails with kInvalidRequest and the joint, the point and the numbers that are wrong.
  static Expected<std::unique_ptr<PreparedTrajectory>> prepare(const JointTrajectory& given,
                                                               const ExecutorParams& params);

  struct Sample {
    double position;  // [rad or m]
    double velocity;  // [rad/s or m/s]
  };
  // Cubic Hermite interpolation of the i-th joint of this trajectory; before the first and after the last
  // point it stands there. `segment` is a hint that the caller keeps: sampling forward in time then costs no
  // search.
  Sample sample(std::size_t i, std::int64_t time_ns, std::size_t segment) const noexcept;
  // The segment [k, k+1] that contains `time_ns`, searched from `hint`.
  std::size_t find_segment(std::int64_t time_ns, std::size_t hint) const noexcept;

  std::size_t size() const noexcept { return joints_.size(); }
  std::size_t joint(std::size_t i) const noexcept { return joints_[i]; }  // index into ExecutorParams::joints
  std::int64_t first_ns() const noexcept { return times_.front(); }
  std::int64_t last_ns() const noexcept { return times_.back(); }
  std::int64_t stamp_ns() const noexcept { return stamp_ns_; }

  std::uint64_t id = 0;  // given by TrajectoryExecutor::submit()

 private:
  Expected<void> check_positions(const ExecutorParams& params);
  Expected<void> take_velocities(const JointTrajectory& trajectory, const ExecutorParams& params);

  std::int64_t stamp_ns_ = 0;
  std::vector<std::size_t> joints_;
  std::vector<std::int64_t> times_;             // [ns] of each point
  std::vector<double> positions_, velocities_;  // point-major: [point * joints + i]
};

}  // namespace goalnet::executor
