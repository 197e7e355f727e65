// The executor's parameters as a ROS 2 node declares them, joined with the limits of the robot.
#pragma once

#include <string>

#include "components/core/outcome.h"
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

// As they are declared; the table is ExecutorNode::describe.
struct DeclaredParams {
  std::string robot = "default";
  bool lockstep = false;
  double rate = 1000.0;  // [Hz]
  double measurement_timeout = 0.1;
  double settle_time = 1.0;
  Tolerances tolerances;
  int priority = 80;
  int cpu = -1;
  bool lock_memory = true;
  double command_period = 0.002;
};

// Loads the robot that they name. Errors: kInvalidRequest.
Expected<NodeParams> resolve(const DeclaredParams& declared);

}  // namespace goalnet::executor
