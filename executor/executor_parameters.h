// The executor's parameters as a ROS 2 node declares them, joined with the limits of the robot.
#pragma once

#include <string>

#include "components/core/outcome.h"
#include "components/robot/robot_model.h"
#include "components/ros/node.h"
#include "executor/cyclic_thread.h"
#include "executor/executor_params.h"

namespace goalnet::executor {

struct Tolerances {
  double start_revolute = 0.10, start_prismatic = 0.05;        // [rad], [m]
  double tracking_revolute = 0.30, tracking_prismatic = 0.12;  // [rad], [m]
  double goal_revolute = 0.05, goal_prismatic = 0.02;          // [rad], [m]
};

struct NodeParams {
  ExecutorParams core;
  bool lockstep = false;          // the simulator calls cycle()
  CyclicThreadParams thread;      // otherwise
  double command_period = 0.002;  // [s] between /joint_commands on the wall clock
};

// Limits of the robot's joints, in their order. Fingers are exempt from tracking and goal tolerances: they
// are meant to be stopped by what they grip.
std::vector<JointLimits> joint_limits(const robot::RobotModel& robot, const Tolerances& tolerances);

// Declares and reads all parameters; loads the robot that they name.
Expected<NodeParams> declare_parameters(ros::Node& node);

}  // namespace goalnet::executor
