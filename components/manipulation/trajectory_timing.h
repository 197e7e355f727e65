// Gives paths their times: as fast as the joints' velocity and acceleration limits allow, from rest to rest.
#pragma once

#include <string>
#include <vector>

#include "components/manipulation/joint_path.h"
#include "executor/joint_trajectory.h"

namespace goalnet::manipulation {

using executor::JointTrajectory;

struct TimedJoints {
  std::vector<std::string> names;
  JointVector velocity;      // [rad/s or m/s] limits, already scaled down for safety
  JointVector acceleration;  // [rad/s^2 or m/s^2]
};

// Along a dense path with continuous slope but for sharp corners (turns_sharply), where the motion stops: the
// executor's cubics between points would leave a path that turns at once. Method: forward and backward passes
// over the squared path speed under velocity and acceleration limits (Bobrow, Dubowsky, Gibson, "Time-Optimal
// Control of Robotic Manipulators Along Specified Paths", IJRR 4(3), 1985), here with kinematic limits only.
// A path of fewer than two distinct points gives a trajectory without points: nothing to move.
JointTrajectory time_path(const TimedJoints& joints, const JointPath& path);

// Straight to a goal with KDL's trapezoidal profile, all joints together. `speed` scales velocities down,
// 0..1.
JointTrajectory time_straight(const TimedJoints& joints, const JointVector& from, const JointVector& to,
                              double speed = 1.0);

// Two motions of different joints at the same time; the shorter one rests at its end.
JointTrajectory merge(const JointTrajectory& a, const JointTrajectory& b);

double duration_s(const JointTrajectory& trajectory);

}  // namespace goalnet::manipulation
