#include "components/robot/arm_kinematics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainiksolverpos_lma.hpp>
#include <kdl/chainjnttojacsolver.hpp>

#include <Eigen/SVD>

#include "components/robot/kdl_tree.h"

namespace goalnet::robot {
namespace {

constexpr double kTau = 2 * std::numbers::pi;

double squared_distance(const ArmPositions& a, const ArmPositions& b) {
  double sum = 0;
  for (std::size_t i = 0; i < 7; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return sum;
}

KDL::JntArray to_array(const ArmPositions& q) {
  KDL::JntArray out(7);
  for (unsigned i = 0; i < 7; ++i) out(i) = q[i];
  return out;
}

}  // namespace

double largest_step(const ArmPositions& a, const ArmPositions& b) {
  double largest = 0;
  for (std::size_t i = 0; i < 7; ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

Expected<ArmKinematics> ArmKinematics::create(const RobotModel& model, const Arm& arm) {
  if (arm.joints.size() != 7) {
    return fail(Outcome::kInvalidRequest, model.file + ": arm '" + arm.name + "' has " +
                                              std::to_string(arm.joints.size()) +
                                              " joints; manipulation needs 7");
  }
  ArmKinematics out;
  auto chain = kdl_chain(model, arm.base_link, arm.tool_link);
  if (!chain) return tl::unexpected<Error>(chain.error());
  out.chain_ = *chain;
  for (std::size_t i = 0; i < 7; ++i) {
    out.joints_[i] = model.index_of(arm.joints[i]);
    const auto& limits = model.joints[static_cast<std::size_t>(out.joints_[i])].limits;
    out.lower_[i] = std::max(limits.lower, -kTau);
    out.upper_[i] = std::min(limits.upper, kTau);
  }
  out.spherical_ = SphericalArm::recognise(model, arm);
  return out;
}

bool ArmKinematics::within_limits(ArmPositions& q, double margin) const {
  for (std::size_t i = 0; i < 7; ++i) {
    const double low = lower_[i] + margin, high = upper_[i] - margin;
    // Angles come out in (-pi, pi]; the joint's range may want the same angle a turn further.
    if (q[i] < low) q[i] += kTau;
    if (q[i] > high) q[i] -= kTau;
    if (q[i] < low || q[i] > high) return false;
  }
  return true;
}

std::vector<ArmPositions> ArmKinematics::solve(const Pose& target, const ArmPositions& seed, int swivels,
                                               double margin) const {
  if (!spherical_) return solve_numerically(target, seed, margin);
  std::vector<ArmPositions> found;
  const double start = spherical_->swivel(seed);
  std::array<ArmPositions, 4> branches;
  for (int i = 0; i < swivels; ++i) {
    const int count = spherical_->solve(target, start + kTau * i / swivels, branches);
    if (count == 0) break;
    for (int b = 0; b < count; ++b) {
      if (within_limits(branches[static_cast<std::size_t>(b)], margin)) {
        found.push_back(branches[static_cast<std::size_t>(b)]);
      }
    }
  }
  std::stable_sort(found.begin(), found.end(), [&](const ArmPositions& a, const ArmPositions& b) {
    return squared_distance(a, seed) < squared_distance(b, seed);
  });
  return found;
}

std::optional<ArmPositions> ArmKinematics::follow(const Pose& target, const ArmPositions& seed,
                                                  double max_step) const {
  std::optional<ArmPositions> best;
  double least = max_step * max_step * 7;
  const auto consider = [&](ArmPositions q) {
    if (!within_limits(q, 0.0)) return;
    const double distance = squared_distance(q, seed);
    if (largest_step(q, seed) <= max_step && distance < least) {
      least = distance;
      best = q;
    }
  };
  if (!spherical_) {
    for (const auto& q : solve_numerically(target, seed, 0.0)) consider(q);
    return best;
  }
  const double swivel = spherical_->swivel(seed);
  std::array<ArmPositions, 4> branches;
  for (const double offset :
       {0.0, 0.01, -0.01, 0.025, -0.025, 0.05, -0.05, 0.09, -0.09, 0.14, -0.14, 0.2, -0.2}) {
    const int count = spherical_->solve(target, swivel + offset, branches);
    for (int b = 0; b < count; ++b) consider(branches[static_cast<std::size_t>(b)]);
    if (best && largest_step(*best, seed) < 0.5 * max_step) break;  // good enough: elbow nearly as before
  }
  return best;
}

std::vector<ArmPositions> ArmKinematics::solve_numerically(const Pose& target, const ArmPositions& seed,
                                                           double margin) const {
  // Position in metres counts as much as 0.1 of an angle in radians in the solver's error norm.
  Eigen::Matrix<double, 6, 1> weights;
  weights << 1, 1, 1, 0.1, 0.1, 0.1;
  KDL::ChainIkSolverPos_LMA solver(chain_, weights, 1e-6, 200);
  std::vector<ArmPositions> found;
  const KDL::Frame frame = to_kdl(target);
  for (int attempt = 0; attempt < 12; ++attempt) {
    ArmPositions start = seed;
    for (std::size_t i = 0; i < 7 && attempt > 0; ++i) {
      // A low-discrepancy sequence over the joint ranges: spread seeds without random numbers.
      const double fraction =
          std::fmod(0.5 + attempt * (0.6180339887 + 0.1031 * static_cast<double>(i)), 1.0);
      start[i] = lower_[i] + (upper_[i] - lower_[i]) * (0.1 + 0.8 * fraction);
    }
    KDL::JntArray result(7);
    if (solver.CartToJnt(to_array(start), frame, result) < 0) continue;
    ArmPositions q;
    for (unsigned i = 0; i < 7; ++i) q[i] = std::remainder(result(i), kTau);
    if (within_limits(q, margin)) found.push_back(q);
  }
  std::stable_sort(found.begin(), found.end(), [&](const ArmPositions& a, const ArmPositions& b) {
    return squared_distance(a, seed) < squared_distance(b, seed);
  });
  return found;
}

Pose ArmKinematics::forward(const ArmPositions& q) const {
  KDL::ChainFkSolverPos_recursive solver(chain_);
  KDL::Frame frame;
  solver.JntToCart(to_array(q), frame);
  return from_kdl(frame);
}

double ArmKinematics::conditioning(const ArmPositions& q) const {
  KDL::ChainJntToJacSolver solver(chain_);
  KDL::Jacobian jacobian(7);
  solver.JntToJac(to_array(q), jacobian);
  Eigen::Matrix<double, 6, 7> j = jacobian.data;
  j.bottomRows<3>() *= 0.3;
  return Eigen::JacobiSVD<Eigen::Matrix<double, 6, 7>>(j).singularValues()(5);
}

}  // namespace goalnet::robot
