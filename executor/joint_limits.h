// From the robot's description to the executor's limits.
#pragma once

#include <vector>

#include "components/robot/robot_model.h"
#include "executor/executor_params.h"

namespace goalnet::executor {

struct Tolerances {
  double start_revolute = 0.10, start_prismatic = 0.05;        // [rad], [m]
  double tracking_revolute = 0.30, tracking_prismatic = 0.12;  // [rad], [m]
  double goal_revolute = 0.05, goal_prismatic = 0.02;          // [rad], [m]
};

// Limits of the robot's joints, in their order. Fingers are exempt from tracking and goal tolerances: they
// are meant to be stopped by what they grip.
std::vector<JointLimits> joint_limits(const robot::RobotModel& robot, const Tolerances& tolerances);

}  // namespace goalnet::executor
