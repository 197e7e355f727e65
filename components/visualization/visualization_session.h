// Draws what the robot knows and intends, for RViz, while active.
//
// In:  object_poses (goalnet_msgs/ObjectPoses), world_state (goalnet_msgs/WorldState, latched),
// instruction_status
//      (goalnet_msgs/InstructionStatus, latched), joint_trajectory (trajectory_msgs/JointTrajectory),
//      joint_states (sensor_msgs/JointState).
// Out: markers (visualization_msgs/MarkerArray, latched), when something changed, at most `rate` times a
// second.
//      header.stamp is the moment at which the objects were seen there; header.frame_id is map.
// It only draws, and only listens to poses and joints, while somebody subscribes to markers: who joins gets a
// picture within a period.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "components/robot/kinematics.h"
#include "components/robot/robot_model.h"
#include "components/ros/node.h"
#include "components/scene/scene.h"
#include "components/visualization/marker_message.h"
#include "components/visualization/path_drawing.h"
#include "components/visualization/text_drawing.h"
#include "goalnet_msgs/msg/InstructionStatus.h"
#include "goalnet_msgs/msg/ObjectPoses.h"
#include "goalnet_msgs/msg/WorldState.h"
#include "sensor_msgs/msg/JointState.h"
#include "trajectory_msgs/msg/JointTrajectory.h"

namespace goalnet::visualization {

// Belongs to the thread of the node's event loop.
class VisualizationSession {
 public:
  // Opens the topics. Scene and robot must outlive the session. `rate`: [Hz] at most so many markers
  // messages.
  VisualizationSession(ros::Node& node, const scene::Scene& scene, const robot::RobotModel& robot,
                       double rate);

 private:
  void open_topics(double rate);
  bool watched() const { return object_poses_ != nullptr; }
  void start_watching();
  void stop_watching();
  void on_poses(const goalnet_msgs::msg::ObjectPoses& message);
  void on_world(const goalnet_msgs::msg::WorldState& message);
  void on_status(const goalnet_msgs::msg::InstructionStatus& message);
  void on_trajectory(const trajectory_msgs::msg::JointTrajectory& message);
  void on_joints(const sensor_msgs::msg::JointState& message);
  void look();
  void publish();

  ros::Node& node_;
  const scene::Scene& scene_;
  const robot::RobotModel& robot_;
  const robot::Kinematics kinematics_;

  Poses poses_;
  builtin_interfaces::msg::Time seen_;  // of poses_
  FactSet facts_;
  Task task_;
  std::vector<double> joints_;  // in the order of RobotModel::joints [rad, m]
  std::vector<Drawing> path_;
  bool changed_ = false;
  MarkerWriter writer_;

  std::shared_ptr<ros::Publisher<visualization_msgs::msg::MarkerArray>> markers_;
  std::shared_ptr<ros::Timer> timer_;
  std::shared_ptr<ros::Subscription<goalnet_msgs::msg::WorldState>> world_state_;
  std::shared_ptr<ros::Subscription<goalnet_msgs::msg::InstructionStatus>> status_;
  std::shared_ptr<ros::Subscription<trajectory_msgs::msg::JointTrajectory>> trajectory_;
  // Only while somebody watches.
  std::shared_ptr<ros::Subscription<goalnet_msgs::msg::ObjectPoses>> object_poses_;
  std::shared_ptr<ros::Subscription<sensor_msgs::msg::JointState>> joint_states_;
};

}  // namespace goalnet::visualization
