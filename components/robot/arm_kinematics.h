// Inverse kinematics of one arm, in the frame of its base link. Closed form where the arm's geometry allows
// it (spherical_arm.h), otherwise KDL's Levenberg-Marquardt solver from several seeds.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <kdl/chain.hpp>

#include "components/robot/kinematics.h"
#include "components/robot/robot_model.h"
#include "components/robot/spherical_arm.h"

namespace goalnet::robot {

// One object per planning thread: the numeric solver keeps scratch memory. Deterministic: no random numbers.
class ArmKinematics {
 public:
  static Expected<ArmKinematics> create(const RobotModel& model, const Arm& arm);

  // Solutions within limits (with `margin` [rad] to spare) for the tool's pose in the frame of the arm's base
  // link, nearest to `seed` first. Empty if out of reach. `swivels`: how many elbow positions are tried.
  std::vector<ArmPositions> solve(const Pose& target, const ArmPositions& seed, int swivels = 24,
                                  double margin = 0.02) const;

  // The solution that continues from `seed` (straight-line motion of the tool): elbow as before if it can be,
  // and no joint further than `max_step` [rad] from the seed.
  std::optional<ArmPositions> follow(const Pose& target, const ArmPositions& seed, double max_step) const;

  // Pose of the tool in the frame of the arm's base link, by KDL.
  Pose forward(const ArmPositions& q) const;
  // Smallest singular value of the Jacobian (rotation weighted by 0.3 m): distance from singular postures.
  double conditioning(const ArmPositions& q) const;

  // Indices of the arm's joints in RobotModel::joints.
  const std::array<int, 7>& joints() const { return joints_; }
  const ArmPositions& lower() const { return lower_; }
  const ArmPositions& upper() const { return upper_; }
  bool closed_form() const { return spherical_.has_value(); }

 private:
  ArmKinematics() = default;
  bool within_limits(ArmPositions& q, double margin) const;
  std::vector<ArmPositions> solve_numerically(const Pose& target, const ArmPositions& seed,
                                              double margin) const;

  std::optional<SphericalArm> spherical_;
  KDL::Chain chain_;
  std::array<int, 7> joints_{};
  ArmPositions lower_{}, upper_{};
};

// Largest difference of any joint [rad].
double largest_step(const ArmPositions& a, const ArmPositions& b);

}  // namespace goalnet::robot
