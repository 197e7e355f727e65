// Moves one hand of the simulated default robot along straight lines through the joint servos, as
// manipulation would, but without planning: for tests of physics.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "components/robot/arm_kinematics.h"
#include "sim/world.h"

namespace goalnet::sim {

class Puppet {
 public:
  Puppet(World& world, const std::string& arm)
      : world_(world), kinematics_(*robot::ArmKinematics::create(world.robot(), *world.robot().arm(arm))) {
    arm_ = world.robot().arm(arm);
    for (const auto& finger : arm_->gripper.fingers)
      fingers_.push_back(static_cast<std::size_t>(world.robot().index_of(finger)));
  }

  // Frame of the hand: z out of it, y the closing direction, from an approach and a closing direction in the
  // map.
  static scene::Pose tool(const Eigen::Vector3d& position, const Eigen::Vector3d& approach,
                          const Eigen::Vector3d& closing) {
    scene::Pose pose = scene::Pose::Identity();
    const Eigen::Vector3d z = approach.normalized();
    const Eigen::Vector3d y = (closing - closing.dot(z) * z).normalized();
    pose.linear().col(0) = y.cross(z);
    pose.linear().col(1) = y;
    pose.linear().col(2) = z;
    pose.translation() = position;
    return pose;
  }

  // Puts base and lift there at once and the hand at `target`. False if the arm cannot reach it.
  bool place(double x, double y, double yaw, double lift, const scene::Pose& target, double opening) {
    const auto& robot = world_.robot();
    set(robot.base.x, x);
    set(robot.base.y, y);
    set(robot.base.yaw, yaw);
    set(robot.lift, lift);
    for (std::size_t finger : fingers_) world_.set_robot_position(finger, opening);
    robot::ArmPositions seed{};
    for (std::size_t i = 0; i < 7; ++i)
      seed[i] = robot.joints[static_cast<std::size_t>(kinematics_.joints()[i])].home;
    const auto solutions = kinematics_.solve(local(target), seed);
    if (solutions.empty()) return false;
    // The posture farthest from its joint limits can follow straight lines longest.
    const auto margin = [&](const robot::ArmPositions& q) {
      double least = 1e9;
      for (std::size_t i = 0; i < 7; ++i) {
        least = std::min({least, q[i] - kinematics_.lower()[i], kinematics_.upper()[i] - q[i]});
      }
      return least;
    };
    position_ = *std::max_element(solutions.begin(), solutions.end(),
                                  [&](const auto& a, const auto& b) { return margin(a) < margin(b); });
    for (std::size_t i = 0; i < 7; ++i)
      world_.set_robot_position(static_cast<std::size_t>(kinematics_.joints()[i]), position_[i]);
    target_ = target;
    return true;
  }

  // Straight line and even turn to `target` in `seconds`. False if the arm cannot follow.
  bool move(const scene::Pose& target, double seconds) {
    const scene::Pose start = target_;
    return follow(
        [&](double s) {
          scene::Pose pose = scene::Pose::Identity();
          const Eigen::Quaterniond a(Eigen::Matrix3d(start.linear())), b(Eigen::Matrix3d(target.linear()));
          pose.linear() = a.slerp(s, b).toRotationMatrix();
          pose.translation() = start.translation() + s * (target.translation() - start.translation());
          return pose;
        },
        seconds);
  }

  // Along path(s), s from 0 to 1, smooth start and end.
  template <class Path>
  bool follow(Path&& path, double seconds) {
    const double dt = world_.options().physics_step;
    const int steps = std::max(1, static_cast<int>(std::lround(seconds / dt)));
    for (int k = 1; k <= steps; ++k) {
      const double u = static_cast<double>(k) / steps;
      target_ = path(u * u * (3.0 - 2.0 * u));
      const auto next = kinematics_.follow(local(target_), position_, 0.02);
      if (!next) return false;
      for (std::size_t i = 0; i < 7; ++i) {
        world_.command(static_cast<std::size_t>(kinematics_.joints()[i]), (*next)[i],
                       ((*next)[i] - position_[i]) / dt);
      }
      position_ = *next;
      world_.step();
    }
    hold();
    return true;
  }

  void fingers(double opening, double seconds) {
    const double dt = world_.options().physics_step;
    const int steps = std::max(1, static_cast<int>(std::lround(seconds / dt)));
    const double start =
        commanded_opening_ < 0 ? world_.robot_joint(fingers_[0]).position : commanded_opening_;
    for (int k = 1; k <= steps; ++k) {
      const double q = start + (opening - start) * k / steps;
      for (std::size_t finger : fingers_) world_.command(finger, q, (opening - start) / (steps * dt));
      world_.step();
    }
    commanded_opening_ = opening;
    for (std::size_t finger : fingers_) world_.command(finger, opening, 0.0);
  }

  void wait(double seconds) {
    for (double t = 0; t < seconds; t += world_.options().physics_step) world_.step();
  }

  const scene::Pose& target() const { return target_; }

 private:
  void hold() {
    for (std::size_t i = 0; i < 7; ++i)
      world_.command(static_cast<std::size_t>(kinematics_.joints()[i]), position_[i], 0.0);
  }
  void set(const std::string& joint, double q) {
    world_.set_robot_position(static_cast<std::size_t>(world_.robot().index_of(joint)), q);
  }
  scene::Pose local(const scene::Pose& pose) const {
    return world_.robot_link_pose(arm_->base_link).inverse() * pose;
  }

  World& world_;
  robot::ArmKinematics kinematics_;
  const robot::Arm* arm_ = nullptr;
  std::vector<std::size_t> fingers_;
  robot::ArmPositions position_{};
  scene::Pose target_ = scene::Pose::Identity();
  double commanded_opening_ = -1;
};

}  // namespace goalnet::sim
