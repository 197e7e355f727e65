// Limits and tolerances of the real-time executor. Numbers come from the robot's file (config/robots/).
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace goalnet::executor {

struct JointLimits {
  std::string name;
  double position_min = -std::numeric_limits<double>::infinity();  // [rad or m]
  double position_max = std::numeric_limits<double>::infinity();   // [rad or m]
  double velocity = 1.0;                                           // [rad/s or m/s] > 0
  double acceleration = 1.0;                                       // [rad/s^2 or m/s^2] > 0
  bool continuous = false;  // turns without end: a trajectory may start whole turns away from the command

  // How far a trajectory may start from the current command.
  double start_tolerance = 0.1;  // [rad or m] > 0
  // Largest deviation of the measurement from the command while moving; beyond it the robot stops smoothly
  // and the trajectory has failed. 0 = not checked (fingers, which are meant to be stopped by what they
  // grip).
  double tracking_tolerance = 0.0;  // [rad or m]
  // Largest deviation of the measurement at the end of a trajectory. 0 = not checked.
  double goal_tolerance = 0.0;  // [rad or m]
};

struct ExecutorParams {
  std::vector<JointLimits> joints;   // 1 to kMaxJoints, in the order of JointSample
  double period = 0.001;             // [s] nominal time between cycles
  double measurement_timeout = 0.1;  // [s] an older measurement stops the robot (watchdog); 0 = never
  double settle_time = 0.5;          // [s] after the end of a trajectory for the goal tolerances to be met
};

}  // namespace goalnet::executor
