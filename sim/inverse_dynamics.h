// Joint forces for wanted joint accelerations: recursive Newton-Euler in the map frame. Pure, no Bullet.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "sim/articulated_body.h"

namespace goalnet::sim {

// Reuses its memory from call to call; not thread-safe.
class InverseDynamics {
 public:
  InverseDynamics(const scene::Pose& base, const std::vector<LinkSpec>& links);

  // All vectors have one entry per link. Result [N m or N]: what the joints must apply so that they
  // accelerate by `acceleration` under gravity and without contacts.
  void compute(const std::vector<double>& position, const std::vector<double>& velocity,
               const std::vector<double>& acceleration, std::vector<double>& force);

 private:
  struct Body {
    // Per call, in the map frame, about the map's origin: spatial vectors are (angular, linear).
    scene::Pose pose;
    Eigen::Vector3d axis_angular, axis_linear;
    Eigen::Vector3d velocity_angular, velocity_linear;
    Eigen::Vector3d acceleration_angular, acceleration_linear;
    Eigen::Vector3d moment, force;
  };
  scene::Pose base_;
  std::vector<LinkSpec> links_;
  std::vector<Eigen::Matrix3d> tensors_;  // about each centre of mass, axes of the link
  std::vector<Body> bodies_;
};

}  // namespace goalnet::sim
