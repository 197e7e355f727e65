#include "executor/executor_parameters.h"

#include <cmath>

#include "components/robot/robot_model.h"
#include "executor/executor_node.h"

namespace goalnet::executor {

void ExecutorNode::describe(ros::ParameterSet& set, Params& params) {
  Tolerances& t = params.tolerances;
  set.text("robot", params.robot, "robot whose joints and limits count", "a name in config/robots or a file");
  set.flag("lockstep", params.lockstep, "the simulator calls the control cycle; no thread of its own")
      .settable = ros::Settable::kAtStart;
  set.number("rate", params.rate, "control cycles per second [Hz]", 10.0, 10000.0);
  set.number("measurement_timeout", params.measurement_timeout,
             "older joint measurements stop the robot [s]; 0 = never", 0.0, 10.0);
  set.number("settle_time", params.settle_time,
             "time for the goal tolerances after the end of a trajectory [s]", 0.0, 60.0);
  set.number("start_tolerance_revolute", t.start_revolute,
             "how far from the command a trajectory may start [rad]", 1e-6, 10.0);
  set.number("start_tolerance_prismatic", t.start_prismatic,
             "how far from the command a trajectory may start [m]", 1e-6, 10.0);
  set.number("tracking_tolerance_revolute", t.tracking_revolute,
             "a joint farther from its command stops the motion [rad]; 0 = off", 0.0, 10.0);
  set.number("tracking_tolerance_prismatic", t.tracking_prismatic,
             "a joint farther from its command stops the motion [m]; 0 = off", 0.0, 10.0);
  set.number("goal_tolerance_revolute", t.goal_revolute,
             "a joint farther from its goal has missed it [rad]; 0 = off", 0.0, 10.0);
  set.number("goal_tolerance_prismatic", t.goal_prismatic,
             "a joint farther from its goal has missed it [m]; 0 = off", 0.0, 10.0);
  set.whole("priority", params.priority, "SCHED_FIFO priority of the control thread; 0 = ordinary scheduling",
            0, 99);
  set.whole("cpu", params.cpu, "CPU that the control thread is pinned to; -1 = any", -1, 1023);
  set.flag("lock_memory", params.lock_memory, "keep all pages of the process in memory");
  set.number("command_period", params.command_period, "time between joint_commands on the wall clock [s]",
             0.0005, 0.1);
}

Expected<NodeParams> resolve(const DeclaredParams& declared) {
  auto robot = robot::load_robot(declared.robot.empty() ? "default" : declared.robot);
  if (!robot) return tl::unexpected(robot.error());
  NodeParams params;
  params.lockstep = declared.lockstep;
  params.core.period = 1.0 / declared.rate;
  params.core.measurement_timeout = declared.measurement_timeout;
  params.core.settle_time = declared.settle_time;
  params.core.joints = joint_limits(*robot, declared.tolerances);
  params.thread.period_ns = std::llround(1e9 / declared.rate);
  params.thread.priority = declared.priority;
  if (declared.cpu >= 0) params.thread.cpu = declared.cpu;
  params.thread.lock_memory = declared.lock_memory;
  params.command_period = declared.command_period;
  return params;
}

}  // namespace goalnet::executor
