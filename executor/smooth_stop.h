// Slowing down along the path: time itself runs slower and slower until it stands.
#pragma once

#include <cstdint>
#include <vector>

#include "executor/executor_params.h"
#include "executor/joint_sample.h"
#include "executor/motion.h"

namespace goalnet::executor {

// The rate of the motion's time falls from 1 to 0 as 1 - 3u^2 + 2u^3 over `duration`: acceleration begins and
// ends at 0, without steps. All joints stay on the planned path, which is known to be free of collisions;
// braking each joint on its own would leave it. Real-time thread; never allocates.
class SmoothStop {
 public:
  // Chooses the shortest duration (in steps of a quarter) that keeps every joint within its acceleration,
  // judged at samples along the way; at most kLongest times the time that the velocities alone need.
  void begin(Motion& motion, std::int64_t time_ns, const JointSample& command,
             const std::vector<JointLimits>& joints) noexcept;

  // Moves on by `dt_ns`. Returns the motion's time.
  std::int64_t advance(std::int64_t dt_ns) noexcept;
  double rate() const noexcept { return rate_at(elapsed_); }  // 1..0
  bool finished() const noexcept { return elapsed_ >= duration_; }
  double duration() const noexcept { return duration_; }  // [s]

 private:
  static constexpr double kLongest = 4.0;
  double rate_at(double elapsed) const noexcept;
  std::int64_t time_at(double elapsed) const noexcept;
  bool within_limits(Motion& motion, const JointSample& command,
                     const std::vector<JointLimits>& joints) const noexcept;

  std::int64_t start_ns_ = 0;  // the motion's time when the stop began
  double duration_ = 0.0;      // [s]
  double elapsed_ = 0.0;       // [s]
};

}  // namespace goalnet::executor
