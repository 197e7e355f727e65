#include "sim/robot_servo.h"

#include <algorithm>
#include <cmath>

namespace goalnet::sim {
namespace {

// A finger presses with this at least as soon as it is blocked [N].
constexpr double kFingerPreload = 10.0;
// A finger slower than this that is not where it should be is blocked [m/s].
constexpr double kBlocked = 0.02;

}  // namespace

RobotServo::RobotServo(ArticulatedBody& body, const robot::RobotModel& model, const WorldOptions& options)
    : body_(body),
      dynamics_(body.base(), body.links()),
      options_(options),
      targets_(model.joints.size()),
      position_(model.joints.size()),
      velocity_(model.joints.size()),
      acceleration_(model.joints.size()),
      effort_(model.joints.size()) {
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    const robot::JointLimits& limits = model.joints[i].limits;
    targets_[i].lower = limits.lower;
    targets_[i].upper = limits.upper;
    targets_[i].max_velocity = limits.velocity;
    targets_[i].max_effort = limits.effort;
    for (const auto& arm : model.arms) {
      const auto& fingers = arm.gripper.fingers;
      targets_[i].finger |= std::find(fingers.begin(), fingers.end(), model.joints[i].name) != fingers.end();
    }
  }
}

void RobotServo::set_target(std::size_t joint, double position, double velocity) {
  Target& target = targets_[joint];
  if (!std::isfinite(position) || !std::isfinite(velocity))
    return;  // never let a bad command into the physics
  target.position = std::clamp(position, target.lower, target.upper);
  target.velocity = std::clamp(velocity, -target.max_velocity, target.max_velocity);
}

void RobotServo::hold(std::size_t joint, bool held, double position) {
  targets_[joint].held = held;
  targets_[joint].held_position = position;
}

void RobotServo::freeze(std::size_t joint, bool frozen) {
  if (frozen && !targets_[joint].frozen) targets_[joint].held_position = body_.position(joint);
  targets_[joint].frozen = frozen;
}

double RobotServo::finger_force(std::size_t joint) const {
  const Target& target = targets_[joint];
  const double error = std::abs(target.position - body_.position(joint));
  return std::min(target.max_effort, kFingerPreload + options_.grip_stiffness * error);
}

void RobotServo::apply(double dt) {
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    const Target& target = targets_[i];
    position_[i] = body_.position(i);
    velocity_[i] = body_.velocity(i);
    const bool fixed = target.held || target.frozen;
    const double goal = fixed ? target.held_position : target.position;
    const double feed = fixed ? 0.0 : target.velocity;
    // The command is where the joint should be when the step is over.
    const double error = goal - position_[i] - feed * dt;
    const double limit = 1.5 * target.max_velocity;
    const double wanted = std::clamp(feed + options_.servo_gain * error / dt, -limit, limit);
    acceleration_[i] = (wanted - velocity_[i]) / dt;
  }
  dynamics_.compute(position_, velocity_, acceleration_, effort_);
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    const Target& target = targets_[i];
    double effort = effort_[i];
    if (target.finger && !target.held && !target.frozen) {
      // Fingers are gentle while they move; once something blocks them they press like a spring towards their
      // target.
      effort = std::clamp(effort, -kFingerPreload, kFingerPreload);
      if (std::abs(velocity_[i]) < kBlocked)
        effort += options_.grip_stiffness * (target.position - position_[i]);
    }
    effort_[i] = std::clamp(effort, -target.max_effort, target.max_effort);
    body_.body().addJointTorque(static_cast<int>(i), effort_[i]);
  }
}

}  // namespace goalnet::sim
