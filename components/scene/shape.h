// Primitive solids, the only geometry of a scene: simulation, motion planning and pictures share them.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <Eigen/Geometry>

namespace goalnet::scene {

// Rigid transform: metres, right-handed.
using Pose = Eigen::Isometry3d;

enum class ShapeKind { kBox, kCylinder, kSphere };

struct Shape {
  ShapeKind kind = ShapeKind::kBox;
  // Box: full edge lengths x, y, z [m]. Cylinder (axis = z of its own frame): radius, radius, length [m].
  // Sphere: radius three times [m].
  Eigen::Vector3d size = Eigen::Vector3d::Zero();
  Pose pose = Pose::Identity();  // centre of the shape in the frame of its owner (object or part)
  std::array<double, 3> color = {0.7, 0.7, 0.7};  // red, green, blue 0..1: for pictures only
  bool solid = true;                              // false: only seen (water jet, flame), never collides
};

// Volume [m^3] and half extents of the axis-aligned box around the shape in its own frame [m].
double volume(const Shape& shape);
Eigen::Vector3d half_extents(const Shape& shape);

// Axis-aligned bounds, in the frame of the owner, of all shapes given; zero when there are none.
struct Bounds {
  Eigen::Vector3d lower = Eigen::Vector3d::Zero();
  Eigen::Vector3d upper = Eigen::Vector3d::Zero();
};
Bounds bounds(const std::vector<Shape>& shapes);

// Pose from x, y, z [m] and roll, pitch, yaw [rad] (fixed axes, as in URDF).
Pose make_pose(const Eigen::Vector3d& xyz, const Eigen::Vector3d& rpy);

}  // namespace goalnet::scene
