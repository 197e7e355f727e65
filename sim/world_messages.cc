#include "sim/world_messages.h"

#include <algorithm>

#include "components/robot/joint_order.h"

namespace goalnet::sim {
namespace {

geometry_msgs::msg::Pose pose_message(const scene::Pose& pose) {
  geometry_msgs::msg::Pose message;
  const Eigen::Quaterniond q(Eigen::Matrix3d(pose.linear()));
  message.position().x(pose.translation().x());
  message.position().y(pose.translation().y());
  message.position().z(pose.translation().z());
  message.orientation().x(q.x());
  message.orientation().y(q.y());
  message.orientation().z(q.z());
  message.orientation().w(q.w());
  return message;
}

geometry_msgs::msg::TransformStamped transform_message(const std::string& parent, const std::string& child,
                                                       const scene::Pose& pose,
                                                       const builtin_interfaces::msg::Time& stamp) {
  geometry_msgs::msg::TransformStamped message;
  message.header().stamp(stamp);
  message.header().frame_id(parent);
  message.child_frame_id(child);
  const Eigen::Quaterniond q(Eigen::Matrix3d(pose.linear()));
  message.transform().translation().x(pose.translation().x());
  message.transform().translation().y(pose.translation().y());
  message.transform().translation().z(pose.translation().z());
  message.transform().rotation().x(q.x());
  message.transform().rotation().y(q.y());
  message.transform().rotation().z(q.z());
  message.transform().rotation().w(q.w());
  return message;
}

}  // namespace

void fill_joint_states(const World& world, const builtin_interfaces::msg::Time& stamp,
                       sensor_msgs::msg::JointState& message) {
  message.header().stamp(stamp);
  const std::size_t robot = world.robot_joint_count(), fixtures = world.fixture_joint_count();
  if (message.name().size() != robot + fixtures) {
    message.name().clear();
    for (const auto& joint : world.robot().joints) message.name().push_back(joint.name);
    for (std::size_t i = 0; i < fixtures; ++i) message.name().push_back(world.fixture_joint_name(i));
    message.position().resize(robot + fixtures);
    message.velocity().resize(robot + fixtures);
    message.effort().resize(robot + fixtures);
  }
  for (std::size_t i = 0; i < robot + fixtures; ++i) {
    const JointReading reading = i < robot ? world.robot_joint(i) : world.fixture_joint(i - robot);
    message.position()[i] = reading.position;
    message.velocity()[i] = reading.velocity;
    message.effort()[i] = reading.effort;
  }
}

void fill_object_poses(const World& world, const builtin_interfaces::msg::Time& stamp,
                       goalnet_msgs::msg::ObjectPoses& message) {
  message.header().stamp(stamp);
  message.header().frame_id("map");
  message.objects().clear();
  const scene::Scene& scene = world.scene();
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    goalnet_msgs::msg::ObjectPose entry;
    entry.name(scene.objects[i].name);
    entry.model(scene.model_of(scene.objects[i]).name);
    entry.pose(pose_message(world.object_pose(i)));
    message.objects().push_back(entry);
  }
  const auto position = [&](const std::string& joint) {
    const int index = world.find_fixture_joint(joint);
    return index < 0 ? 0.0 : world.fixture_joint(static_cast<std::size_t>(index)).position;
  };
  for (const auto& fixture : scene.fixtures) {
    for (const auto& part : fixture.parts) {
      goalnet_msgs::msg::ObjectPose entry;
      entry.name(part.name);
      entry.pose(pose_message(scene::part_pose(fixture, part, position)));
      message.objects().push_back(entry);
    }
  }
  std::sort(message.objects().begin(), message.objects().end(),
            [](const auto& a, const auto& b) { return a.name() < b.name(); });
}

void fill_object_states(const FactSet& facts, const builtin_interfaces::msg::Time& stamp,
                        goalnet_msgs::msg::ObjectStates& message) {
  message.header().stamp(stamp);
  message.header().frame_id("map");
  message.objects().clear();
  for (const auto& fact : facts) {
    if (fact.relation != "state") continue;
    if (message.objects().empty() || message.objects().back().name() != fact.subject) {
      message.objects().emplace_back();
      message.objects().back().name(fact.subject);
    }
    message.objects().back().values().push_back(fact.object);
  }
}

void fill_transforms(const World& world, const builtin_interfaces::msg::Time& stamp, bool moving,
                     tf2_msgs::msg::TFMessage& message) {
  message.transforms().clear();
  const urdf::ModelInterface& model = *world.robot().urdf;
  if (!moving)
    message.transforms().push_back(
        transform_message("map", model.getRoot()->name, scene::Pose::Identity(), stamp));
  for (const auto& joint : robot::joints_depth_first(model)) {
    if (robot::is_actuated(*joint) != moving) continue;
    const scene::Pose parent = world.robot_link_pose(joint->parent_link_name);
    const scene::Pose child = world.robot_link_pose(joint->child_link_name);
    message.transforms().push_back(
        transform_message(joint->parent_link_name, joint->child_link_name, parent.inverse() * child, stamp));
  }
}

}  // namespace goalnet::sim
