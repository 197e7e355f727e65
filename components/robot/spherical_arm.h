// Closed-form inverse kinematics of a seven-joint arm with spherical shoulder and wrist. Method: elbow on a
// circle about the shoulder-wrist line, its place given by the swivel angle (Shimizu et al., "Analytical
// Inverse Kinematic Computation for 7-DOF Redundant Manipulators With Joint Limits", IEEE T-RO 24(5), 2008).
#pragma once

#include <array>
#include <optional>

#include <Eigen/Geometry>

#include "components/robot/kinematics.h"

namespace goalnet::robot {

using ArmPositions = std::array<double, 7>;  // [rad]

// Immutable; any thread. Does not allocate.
class SphericalArm {
 public:
  // Recognises the pattern (axes z y z y z y z, all offsets along z); nothing if the arm is built otherwise.
  static std::optional<SphericalArm> recognise(const RobotModel& model, const Arm& arm);

  // Up to four solutions (two of the shoulder, two of the wrist) for the tool's pose in the frame of the
  // arm's base link and a swivel angle [rad]. Limits are not looked at. Returns how many; 0 if out of reach.
  int solve(const Pose& target, double swivel, std::array<ArmPositions, 4>& solutions) const;

  // Swivel angle of a configuration, the inverse of the above up to its four branches.
  double swivel(const ArmPositions& q) const;

 private:
  struct ElbowCircle {
    Eigen::Vector3d centre, u, v;  // u, v span its plane
    double radius = 0;
  };
  std::optional<ElbowCircle> circle(const Eigen::Vector3d& wrist) const;

  Pose mount_ = Pose::Identity();  // base link -> frame at the shoulder's centre with joint 1 at zero
  Pose tool_ = Pose::Identity();   // wrist's centre with joint 7 -> tool frame
  double upper_ = 0, fore_ = 0;    // [m] shoulder-elbow, elbow-wrist
};

}  // namespace goalnet::robot
