#include "components/robot/kinematics.h"

#include "components/robot/joint_order.h"

namespace goalnet::robot {

Pose to_pose(const urdf::Pose& pose) {
  Pose out = Pose::Identity();
  out.translation() = Eigen::Vector3d(pose.position.x, pose.position.y, pose.position.z);
  out.linear() = Eigen::Quaterniond(pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z)
                     .normalized()
                     .toRotationMatrix();
  return out;
}

Kinematics::Kinematics(const RobotModel& model) : joint_count_(model.joints.size()) {
  Link root;
  root.name = model.urdf->getRoot()->name;
  links_.push_back(root);
  for (const auto& joint : joints_depth_first(*model.urdf)) {
    Link link;
    link.name = joint->child_link_name;
    link.parent = link_index(joint->parent_link_name);
    link.joint = is_actuated(*joint) ? model.index_of(joint->name) : -1;
    link.prismatic = joint->type == urdf::Joint::PRISMATIC;
    link.origin = to_pose(joint->parent_to_joint_origin_transform);
    if (link.joint >= 0)
      link.axis = Eigen::Vector3d(joint->axis.x, joint->axis.y, joint->axis.z).normalized();
    links_.push_back(link);
  }
}

int Kinematics::link_index(const std::string& name) const {
  for (std::size_t i = 0; i < links_.size(); ++i) {
    if (links_[i].name == name) return static_cast<int>(i);
  }
  return -1;
}

Pose Kinematics::local(const Link& link, const std::vector<double>& q) const {
  if (link.joint < 0) return link.origin;
  Pose out = link.origin;
  const double value = q[static_cast<std::size_t>(link.joint)];
  if (link.prismatic) {
    out.translation() += out.linear() * (link.axis * value);
  } else {
    out.linear() = out.linear() * Eigen::AngleAxisd(value, link.axis).toRotationMatrix();
  }
  return out;
}

void Kinematics::forward(const std::vector<double>& q, std::vector<Pose>& poses) const {
  poses.resize(links_.size());
  poses[0] = Pose::Identity();
  for (std::size_t i = 1; i < links_.size(); ++i) {
    poses[i] = poses[static_cast<std::size_t>(links_[i].parent)] * local(links_[i], q);
  }
}

Pose Kinematics::forward(const std::vector<double>& q, int link) const {
  Pose out = Pose::Identity();
  for (int i = link; i > 0; i = links_[static_cast<std::size_t>(i)].parent) {
    out = local(links_[static_cast<std::size_t>(i)], q) * out;
  }
  return out;
}

}  // namespace goalnet::robot
