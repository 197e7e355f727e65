#include "executor/executor_parameters.h"

#include <cmath>

#include "components/robot/robot_model.h"

namespace goalnet::executor {
namespace {

// Declares one number after the other; remembers the first error.
class Declarer {
 public:
  explicit Declarer(ros::Node& node) : node_(node) {}

  template <class T>
  T operator()(const std::string& name, T value, const std::string& description, double from, double to) {
    auto declared = node_.declare_parameter<T>(
        name, value, {.description = description, .read_only = true, .range = ros::ParameterRange{from, to}});
    return take(declared, value);
  }
  template <class T>
  T plain(const std::string& name, T value, const std::string& description) {
    auto declared = node_.declare_parameter<T>(name, value, {.description = description, .read_only = true});
    return take(declared, value);
  }

  Expected<void> result = {};

 private:
  template <class T>
  T take(const Expected<T>& declared, const T& fallback) {
    if (declared) return *declared;
    if (result) result = tl::unexpected(declared.error());
    return fallback;
  }
  ros::Node& node_;
};

}  // namespace

Expected<NodeParams> declare_parameters(ros::Node& node) {
  Declarer declare(node);
  NodeParams params;
  const auto robot_name =
      declare.plain<std::string>("robot", "default", "robot: a name in config/robots or a file");
  params.lockstep =
      declare.plain<bool>("lockstep", false, "the simulator calls the control cycle; no thread of its own");
  const double rate = declare("rate", 1000.0, "control cycles per second [Hz]", 10.0, 10000.0);
  params.core.measurement_timeout = declare(
      "measurement_timeout", 0.1, "older joint measurements stop the robot [s]; 0 = never", 0.0, 10.0);
  params.core.settle_time = declare(
      "settle_time", 1.0, "time for the goal tolerances after the end of a trajectory [s]", 0.0, 60.0);
  Tolerances t;
  t.start_revolute = declare("start_tolerance_revolute", t.start_revolute,
                             "how far from the command a trajectory may start [rad]", 1e-6, 10.0);
  t.start_prismatic = declare("start_tolerance_prismatic", t.start_prismatic,
                              "how far from the command a trajectory may start [m]", 1e-6, 10.0);
  t.tracking_revolute =
      declare("tracking_tolerance_revolute", t.tracking_revolute,
              "a joint farther from its command stops the motion [rad]; 0 = off", 0.0, 10.0);
  t.tracking_prismatic = declare("tracking_tolerance_prismatic", t.tracking_prismatic,
                                 "a joint farther from its command stops the motion [m]; 0 = off", 0.0, 10.0);
  t.goal_revolute = declare("goal_tolerance_revolute", t.goal_revolute,
                            "a joint farther from its goal has missed it [rad]; 0 = off", 0.0, 10.0);
  t.goal_prismatic = declare("goal_tolerance_prismatic", t.goal_prismatic,
                             "a joint farther from its goal has missed it [m]; 0 = off", 0.0, 10.0);
  params.thread.priority =
      declare("priority", 80, "SCHED_FIFO priority of the control thread; 0 = ordinary scheduling", 0, 99);
  if (const int cpu = declare("cpu", -1, "CPU that the control thread is pinned to; -1 = any", -1, 1023);
      cpu >= 0)
    params.thread.cpu = cpu;
  params.thread.lock_memory =
      declare.plain<bool>("lock_memory", true, "keep all pages of the process in memory");
  params.command_period =
      declare("command_period", 0.002, "time between /joint_commands on the wall clock [s]", 0.0005, 0.1);
  if (!declare.result) return tl::unexpected(declare.result.error());

  auto robot = robot::load_robot(robot_name.empty() ? "default" : robot_name);
  if (!robot) return tl::unexpected(robot.error());
  params.core.period = 1.0 / rate;
  params.thread.period_ns = std::llround(1e9 / rate);
  params.core.joints = joint_limits(*robot, t);
  return params;
}

}  // namespace goalnet::executor
