// The robot's joint controllers: computed torque with the effort limits of the URDF.
// Each physics step asks for the velocity that follows the command and takes away a share of the position
// error, and applies the joint force that inverse dynamics gives for it, clamped. Stiff in free motion,
// bounded in contact.
#pragma once

#include <vector>

#include "components/robot/robot_model.h"
#include "sim/inverse_dynamics.h"
#include "sim/world_options.h"

namespace goalnet::sim {

class RobotServo {
 public:
  RobotServo(ArticulatedBody& body, const robot::RobotModel& model, const WorldOptions& options);

  void set_target(std::size_t joint, double position, double velocity);
  double target(std::size_t joint) const { return targets_[joint].position; }
  // The command as given, also while a grasp or a fault overrides it.
  void hold(std::size_t joint, bool held, double position);
  void freeze(std::size_t joint, bool frozen);
  bool is_held(std::size_t joint) const { return targets_[joint].held; }

  // Sets the joint forces for the physics step ahead.
  void apply(double dt);
  double effort(std::size_t joint) const { return effort_[joint]; }
  // [N] that a finger would press with towards its target if blocked at its present position.
  double finger_force(std::size_t joint) const;

 private:
  struct Target {
    double position = 0, velocity = 0;
    bool held = false, frozen = false, finger = false;
    double held_position = 0;
    double lower = 0, upper = 0, max_velocity = 0, max_effort = 0;
  };
  ArticulatedBody& body_;
  InverseDynamics dynamics_;
  const WorldOptions options_;
  std::vector<Target> targets_;
  std::vector<double> position_, velocity_, acceleration_, effort_;
};

}  // namespace goalnet::sim
