#include "components/robot/kdl_tree.h"

#include "components/robot/joint_order.h"

namespace goalnet::robot {
namespace {

KDL::RigidBodyInertia inertia_of(const urdf::Link& link) {
  if (!link.inertial) return KDL::RigidBodyInertia(0.0);
  const auto& i = *link.inertial;
  const KDL::Frame origin = to_kdl(to_pose(i.origin));
  // urdfdom gives the inertia about the centre of mass in the axes of the inertial frame; KDL wants the axes
  // of the link and the point of reference spelled out.
  const KDL::RigidBodyInertia about_com(i.mass, KDL::Vector::Zero(),
                                        KDL::RotationalInertia(i.ixx, i.iyy, i.izz, i.ixy, i.ixz, i.iyz));
  return origin * about_com;
}

KDL::Joint joint_of(const urdf::Joint& joint) {
  const KDL::Frame origin = to_kdl(to_pose(joint.parent_to_joint_origin_transform));
  const KDL::Vector axis = origin.M * KDL::Vector(joint.axis.x, joint.axis.y, joint.axis.z);
  if (!is_actuated(joint)) return KDL::Joint(joint.name, KDL::Joint::Fixed);
  const auto type = joint.type == urdf::Joint::PRISMATIC ? KDL::Joint::TransAxis : KDL::Joint::RotAxis;
  return KDL::Joint(joint.name, origin.p, axis, type);
}

}  // namespace

KDL::Frame to_kdl(const Pose& pose) {
  KDL::Frame frame;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) frame.M(r, c) = pose.linear()(r, c);
    frame.p(r) = pose.translation()(r);
  }
  return frame;
}

Pose from_kdl(const KDL::Frame& frame) {
  Pose pose = Pose::Identity();
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) pose.linear()(r, c) = frame.M(r, c);
    pose.translation()(r) = frame.p(r);
  }
  return pose;
}

KDL::Tree kdl_tree(const RobotModel& model) {
  KDL::Tree tree(model.urdf->getRoot()->name);
  for (const auto& joint : joints_depth_first(*model.urdf)) {
    const auto link = model.urdf->getLink(joint->child_link_name);
    tree.addSegment(KDL::Segment(link->name, joint_of(*joint),
                                 to_kdl(to_pose(joint->parent_to_joint_origin_transform)), inertia_of(*link)),
                    joint->parent_link_name);
  }
  return tree;
}

Expected<KDL::Chain> kdl_chain(const RobotModel& model, const std::string& from, const std::string& to) {
  KDL::Chain chain;
  if (!kdl_tree(model).getChain(from, to, chain)) {
    return fail(Outcome::kInvalidRequest,
                model.file + ": no chain of links from '" + from + "' to '" + to + "'");
  }
  return chain;
}

}  // namespace goalnet::robot
