// The executor's parameters as a ROS 2 node declares them, joined with the limits of the robot.
#pragma once

#include <string>

#include "components/core/outcome.h"
#include "components/ros/node.h"
#include "executor/cyclic_thread.h"
#include "executor/executor_params.h"
#include "executor/joint_limits.h"

namespace goalnet::executor {

struct NodeParams {
  ExecutorParams core;
  bool lockstep = false;          // the simulator calls cycle()
  CyclicThreadParams thread;      // otherwise
  double command_period = 0.002;  // [s] between /joint_commands on the wall clock
};

// Declares and reads all parameters; loads the robot that they name.
Expected<NodeParams> declare_parameters(ros::Node& node);

}  // namespace goalnet::executor
