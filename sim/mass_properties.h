// Mass, centre of mass and inertia of bodies made of primitive shapes.
#pragma once

#include <vector>

#include "components/scene/shape.h"

namespace goalnet::sim {

struct MassProperties {
  double mass = 0.0;                                          // [kg]
  scene::Pose center = scene::Pose::Identity();               // centre of mass, axes along the principal axes
  Eigen::Vector3d inertia = Eigen::Vector3d::Constant(1e-6);  // [kg m^2] about those axes
};

// Solid shapes at equal density; `mass` is distributed over them by volume.
MassProperties mass_of_shapes(const std::vector<scene::Shape>& shapes, double mass);

// From a full inertia tensor about the centre of mass, given in a frame `center`.
MassProperties mass_of_tensor(double mass, const scene::Pose& center, const Eigen::Matrix3d& inertia);

// Two bodies joined rigidly; both centres in the same frame.
MassProperties combine(const MassProperties& a, const MassProperties& b);

// Inertia tensor about the centre of mass, in the axes of the frame that `properties.center` is given in.
Eigen::Matrix3d inertia_tensor(const MassProperties& properties);

}  // namespace goalnet::sim
