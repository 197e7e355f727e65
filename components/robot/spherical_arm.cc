#include "components/robot/spherical_arm.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "components/robot/joint_order.h"

namespace goalnet::robot {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

bool along_z(const Pose& pose) {
  return pose.linear().isIdentity(1e-9) && std::abs(pose.translation().x()) < 1e-9 &&
         std::abs(pose.translation().y()) < 1e-9;
}

Matrix3d rot_y(double a) { return Eigen::AngleAxisd(a, Vector3d::UnitY()).toRotationMatrix(); }
Matrix3d rot_z(double a) { return Eigen::AngleAxisd(a, Vector3d::UnitZ()).toRotationMatrix(); }

}  // namespace

std::optional<SphericalArm> SphericalArm::recognise(const RobotModel& model, const Arm& arm) {
  if (arm.joints.size() != 7) return std::nullopt;
  // Origins of everything between the base link and the tool; fixed joints are merged into what follows.
  std::vector<Pose> origins;
  std::vector<Vector3d> axes;
  Pose pending = Pose::Identity();
  std::vector<urdf::JointConstSharedPtr> chain;
  for (auto link = model.urdf->getLink(arm.tool_link); link && link->name != arm.base_link;
       link = link->getParent()) {
    chain.insert(chain.begin(), link->parent_joint);
  }
  for (const auto& joint : chain) {
    pending = pending * to_pose(joint->parent_to_joint_origin_transform);
    if (!is_actuated(*joint)) continue;
    if (joint->type == urdf::Joint::PRISMATIC) return std::nullopt;
    origins.push_back(pending);
    axes.emplace_back(joint->axis.x, joint->axis.y, joint->axis.z);
    pending = Pose::Identity();
  }
  for (std::size_t i = 0; i < 7; ++i) {
    const Vector3d expected = i % 2 == 0 ? Vector3d::UnitZ() : Vector3d::UnitY();
    if (!axes[i].isApprox(expected, 1e-9)) return std::nullopt;
    if (i > 0 && !along_z(origins[i])) return std::nullopt;
  }
  const auto z = [&](std::size_t i) { return origins[i].translation().z(); };
  SphericalArm out;
  out.mount_ = origins[0] * Eigen::Translation3d(0, 0, z(1));
  out.upper_ = z(2) + z(3);
  out.fore_ = z(4) + z(5);
  out.tool_ = Pose(Eigen::Translation3d(0, 0, z(6))) * pending;
  if (out.upper_ < 1e-3 || out.fore_ < 1e-3) return std::nullopt;
  return out;
}

std::optional<SphericalArm::ElbowCircle> SphericalArm::circle(const Vector3d& wrist) const {
  const double d = wrist.norm();
  if (d > upper_ + fore_ - 1e-6 || d < std::abs(upper_ - fore_) + 1e-3) return std::nullopt;
  ElbowCircle out;
  const Vector3d line = wrist / d;
  const double along = (upper_ * upper_ - fore_ * fore_ + d * d) / (2 * d);
  out.centre = line * along;
  out.radius = std::sqrt(std::max(0.0, upper_ * upper_ - along * along));
  // Zero of the swivel angle: the elbow as far out along joint 1's axis as it goes.
  Vector3d reference = Vector3d::UnitZ() - line * line.z();
  if (reference.norm() < 1e-4) reference = Vector3d::UnitX() - line * line.x();
  out.u = reference.normalized();
  out.v = line.cross(out.u);
  return out;
}

int SphericalArm::solve(const Pose& target, double swivel, std::array<ArmPositions, 4>& solutions) const {
  const Pose hand = mount_.inverse(Eigen::Isometry) * target * tool_.inverse(Eigen::Isometry);
  const Vector3d wrist = hand.translation();
  const auto elbows = circle(wrist);
  if (!elbows) return 0;
  const Vector3d elbow =
      elbows->centre + elbows->radius * (std::cos(swivel) * elbows->u + std::sin(swivel) * elbows->v);
  const Vector3d up = elbow / upper_;
  const Vector3d fore = (wrist - elbow) / fore_;
  const double bend = std::acos(std::clamp(up.dot(fore), -1.0, 1.0));
  int count = 0;
  for (const double sign : {1.0, -1.0}) {
    ArmPositions q{};
    q[1] = sign * std::acos(std::clamp(up.z(), -1.0, 1.0));
    q[0] = std::atan2(sign * up.y(), sign * up.x());
    const Matrix3d shoulder = rot_z(q[0]) * rot_y(q[1]);
    const Vector3d f = shoulder.transpose() * fore;
    q[2] = std::atan2(f.y(), f.x());
    q[3] = bend;
    const Matrix3d w = (shoulder * rot_z(q[2]) * rot_y(q[3])).transpose() * hand.linear();
    const double tilt = std::acos(std::clamp(w(2, 2), -1.0, 1.0));
    for (const double flip : {1.0, -1.0}) {
      q[5] = flip * tilt;
      if (tilt < 1e-6) {  // joints 5 and 7 in line: put all into joint 5
        q[4] = std::atan2(w(1, 0), w(0, 0));
        q[6] = 0;
      } else {
        q[4] = std::atan2(flip * w(1, 2), flip * w(0, 2));
        q[6] = std::atan2(flip * w(2, 1), -flip * w(2, 0));
      }
      solutions[static_cast<std::size_t>(count++)] = q;
    }
  }
  return count;
}

double SphericalArm::swivel(const ArmPositions& q) const {
  const Matrix3d shoulder = rot_z(q[0]) * rot_y(q[1]);
  const Vector3d elbow = shoulder.col(2) * upper_;
  const Vector3d wrist = elbow + (shoulder * rot_z(q[2]) * rot_y(q[3])).col(2) * fore_;
  const auto elbows = circle(wrist);
  if (!elbows) return 0;
  const Vector3d r = elbow - elbows->centre;
  return std::atan2(r.dot(elbows->v), r.dot(elbows->u));
}

}  // namespace goalnet::robot
