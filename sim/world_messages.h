// From the simulated world to ROS 2 messages. No publishing here.
#pragma once

#include <cstdint>
#include <vector>

#include "builtin_interfaces/msg/Time.h"
#include "goalnet_msgs/msg/ObjectPoses.h"
#include "goalnet_msgs/msg/ObjectStates.h"
#include "sensor_msgs/msg/JointState.h"
#include "sim/world.h"
#include "tf2_msgs/msg/TFMessage.h"

namespace goalnet::sim {

// Robot joints in the order of the model, then fixture joints in the order of the scene.
void fill_joint_states(const World& world, const builtin_interfaces::msg::Time& stamp,
                       sensor_msgs::msg::JointState& message);

// Objects and moving parts of fixtures, sorted by name. Parts have an empty model.
void fill_object_poses(const World& world, const builtin_interfaces::msg::Time& stamp,
                       goalnet_msgs::msg::ObjectPoses& message);

// (state …) facts grouped by subject.
void fill_object_states(const FactSet& facts, const builtin_interfaces::msg::Time& stamp,
                        goalnet_msgs::msg::ObjectStates& message);

// Transforms of the robot's links with respect to their parents. `moving`: those behind actuated joints; else
// the fixed ones and map -> root link.
void fill_transforms(const World& world, const builtin_interfaces::msg::Time& stamp, bool moving,
                     tf2_msgs::msg::TFMessage& message);

}  // namespace goalnet::sim
