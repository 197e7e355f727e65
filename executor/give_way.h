// After a joint did not follow: the command goes back to where the joints are.
#pragma once

#include <array>
#include <vector>

#include "executor/executor_params.h"
#include "executor/joint_sample.h"

namespace goalnet::executor {

// A servo whose command lies inside an obstacle presses against it as hard as it can, and jumps when the
// obstacle goes. So the command of every joint that is farther from its measurement than its goal tolerance
// returns to the measurement, along a cubic from rest to rest at half of the limits of velocity and
// acceleration, all joints in the same time. Others stay: their deviation is what they need to carry their
// load. Joints whose deviation is not checked (no tracking tolerance: fingers) keep their command, and so
// their grip. Real-time thread; never allocates.
class GiveWay {
 public:
  // Begins at `command`, which stands. False, and nothing to do, if every joint is near enough.
  bool begin(const JointSample& command, const JointSample& measured,
             const std::vector<JointLimits>& joints) noexcept;

  // Moves on by `dt` seconds. Returns the setpoint.
  const JointSample& advance(double dt) noexcept;
  bool finished() const noexcept { return elapsed_ >= duration_; }

 private:
  JointSample start_, setpoint_;
  std::array<double, kMaxJoints> way_{};  // [rad or m] from start to end
  double duration_ = 0.0;                 // [s]
  double elapsed_ = 0.0;                  // [s]
};

}  // namespace goalnet::executor
