#include "components/manipulation/perception.h"

#include <cmath>

#include "components/messages/conversions.h"

namespace goalnet::manipulation {
namespace {

// Nothing where the numbers are no pose.
std::optional<Pose> to_pose(const geometry_msgs::msg::Pose& message) {
  const Eigen::Vector3d position(message.position().x(), message.position().y(), message.position().z());
  const auto& q = message.orientation();
  const Eigen::Quaterniond rotation(q.w(), q.x(), q.y(), q.z());
  const double length = rotation.norm();
  if (!position.allFinite() || !std::isfinite(length) || std::abs(length - 1.0) > 0.01) return std::nullopt;
  Pose pose = Pose::Identity();
  pose.linear() = rotation.normalized().toRotationMatrix();
  pose.translation() = position;
  return pose;
}

}  // namespace

Perception::Perception(const robot::RobotModel& model) : seen_(model.joints.size(), false) {
  for (std::size_t i = 0; i < model.joints.size(); ++i) robot_joints_[model.joints[i].name] = i;
  view_.robot.assign(model.joints.size(), 0.0);
}

Expected<void> Perception::take(const sensor_msgs::msg::JointState& message) {
  const auto& names = message.name();
  const auto& positions = message.position();
  if (positions.size() != names.size() || names.size() > messages::kMaxObjects) {
    return fail(Outcome::kInvalidRequest, "joint_states with " + std::to_string(names.size()) +
                                              " names and " + std::to_string(positions.size()) +
                                              " positions");
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!std::isfinite(positions[i])) {
      return fail(Outcome::kInvalidRequest,
                  "joint_states: the position of '" + names[i] + "' is not a number");
    }
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto joint = robot_joints_.find(names[i]);
    if (joint == robot_joints_.end()) {
      view_.joints[names[i]] = positions[i];
      continue;
    }
    view_.robot[joint->second] = positions[i];
    robot_seen_ += seen_[joint->second] ? 0 : 1;
    seen_[joint->second] = true;
  }
  return {};
}

Expected<void> Perception::take(const goalnet_msgs::msg::ObjectPoses& message) {
  if (message.objects().size() > messages::kMaxObjects) {
    return fail(Outcome::kInvalidRequest,
                "object_poses with " + std::to_string(message.objects().size()) + " objects");
  }
  std::map<std::string, Pose> objects;
  for (const auto& object : message.objects()) {
    if (object.model().empty()) continue;  // a moving part of a fixture: its joint says where it is
    const auto pose = to_pose(object.pose());
    if (!pose)
      return fail(Outcome::kInvalidRequest, "object_poses: the pose of '" + object.name() + "' is none");
    objects.emplace(object.name(), *pose);
  }
  view_.objects = std::move(objects);
  poses_seen_ = true;
  return {};
}

Expected<void> Perception::take(const goalnet_msgs::msg::WorldState& message) {
  auto world = messages::from_message(message);
  if (!world) return tl::unexpected<Error>(std::move(world.error()));
  view_.facts = std::move(world->facts);
  facts_seen_ = true;
  return {};
}

}  // namespace goalnet::manipulation
