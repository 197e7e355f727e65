#include "executor/joint_limits.h"

#include <algorithm>

namespace goalnet::executor {

std::vector<JointLimits> joint_limits(const robot::RobotModel& robot, const Tolerances& tolerances) {
  std::vector<JointLimits> limits;
  for (const robot::Joint& joint : robot.joints) {
    const bool prismatic = joint.kind == robot::JointKind::kPrismatic;
    const bool finger = std::any_of(robot.arms.begin(), robot.arms.end(), [&](const robot::Arm& arm) {
      return std::find(arm.gripper.fingers.begin(), arm.gripper.fingers.end(), joint.name) !=
             arm.gripper.fingers.end();
    });
    JointLimits made;
    made.name = joint.name;
    made.position_min = joint.limits.lower;
    made.position_max = joint.limits.upper;
    made.velocity = joint.limits.velocity;
    made.acceleration = joint.limits.acceleration;
    made.continuous = joint.kind == robot::JointKind::kContinuous;
    made.start_tolerance = prismatic ? tolerances.start_prismatic : tolerances.start_revolute;
    // A finger's command lies inside what it grips, its measurement outside: let trajectories start from
    // either.
    if (finger)
      made.start_tolerance = std::max(made.start_tolerance, joint.limits.upper - joint.limits.lower);
    if (!finger) {
      made.tracking_tolerance = prismatic ? tolerances.tracking_prismatic : tolerances.tracking_revolute;
      made.goal_tolerance = prismatic ? tolerances.goal_prismatic : tolerances.goal_revolute;
    }
    limits.push_back(made);
  }
  return limits;
}

}  // namespace goalnet::executor
