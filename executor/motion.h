// One trajectory as a motion of all joints, from the command as it stands at its start.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "executor/executor_params.h"
#include "executor/joint_sample.h"
#include "executor/prepared_trajectory.h"

namespace goalnet::executor {

// Why a trajectory cannot start here.
struct StartMismatch {
  bool mismatch = false;
  std::size_t joint = 0;
  double distance = 0.0;  // [rad or m] from the command to the trajectory's start
};

// Splices a trajectory onto the current command without a jump of position or velocity:
// - first point at time 0: the small difference to the command fades out along a cubic, at half acceleration;
// - first point later: one cubic leads from the command there;
// - joints that the trajectory does not name, but which still move, slow down to standstill.
// Everything is a function of the motion's own time, so a smooth stop can slow that time down and stay on the
// path. Real-time thread; never allocates.
class Motion {
 public:
  explicit Motion(const std::vector<JointLimits>& joints);

  // Begins `trajectory` (which must outlive the motion) at `command`, or leaves the motion as it was and says
  // why.
  StartMismatch begin(const PreparedTrajectory& trajectory, const JointSample& command) noexcept;

  // The setpoint at `time_ns` after the start; beyond the end everything stands.
  void evaluate(std::int64_t time_ns, JointSample& setpoint) noexcept;

  std::int64_t end_ns() const noexcept { return end_ns_; }

 private:
  // How one joint gets from the command to its trajectory, or to rest.
  struct Splice {
    double offset = 0.0;      // whole turns added to the trajectory (continuous joints)
    double difference = 0.0;  // command minus trajectory at time 0: position ...
    double rate = 0.0;        // ... and velocity
    double duration = 0.0;    // [s] of the fade, or of slowing down
  };
  static double fade_duration(double difference, double rate, double acceleration) noexcept;

  const std::vector<JointLimits>& joints_;
  const PreparedTrajectory* trajectory_ = nullptr;
  std::size_t segment_ = 0;
  std::int64_t end_ns_ = 0;
  JointSample start_;
  std::array<Splice, kMaxJoints> splices_{};
  std::array<std::int32_t, kMaxJoints> row_{};  // place of each joint in the trajectory, or -1
};

}  // namespace goalnet::executor
