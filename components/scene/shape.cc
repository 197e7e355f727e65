#include "components/scene/shape.h"

#include <numbers>

namespace goalnet::scene {

double volume(const Shape& shape) {
  switch (shape.kind) {
    case ShapeKind::kBox:
      return shape.size.x() * shape.size.y() * shape.size.z();
    case ShapeKind::kCylinder:
      return std::numbers::pi * shape.size.x() * shape.size.x() * shape.size.z();
    case ShapeKind::kSphere:
      return 4.0 / 3.0 * std::numbers::pi * shape.size.x() * shape.size.x() * shape.size.x();
  }
  return 0.0;
}

Eigen::Vector3d half_extents(const Shape& shape) {
  switch (shape.kind) {
    case ShapeKind::kBox:
      return shape.size / 2.0;
    case ShapeKind::kCylinder:
      return {shape.size.x(), shape.size.x(), shape.size.z() / 2.0};
    case ShapeKind::kSphere:
      return shape.size;
  }
  return Eigen::Vector3d::Zero();
}

Bounds bounds(const std::vector<Shape>& shapes) {
  Bounds result;
  bool first = true;
  for (const auto& shape : shapes) {
    const Eigen::Vector3d half = shape.pose.linear().cwiseAbs() * half_extents(shape);
    const Eigen::Vector3d lower = shape.pose.translation() - half;
    const Eigen::Vector3d upper = shape.pose.translation() + half;
    result.lower = first ? lower : Eigen::Vector3d(result.lower.cwiseMin(lower));
    result.upper = first ? upper : Eigen::Vector3d(result.upper.cwiseMax(upper));
    first = false;
  }
  return result;
}

Pose make_pose(const Eigen::Vector3d& xyz, const Eigen::Vector3d& rpy) {
  Pose pose = Pose::Identity();
  pose.translation() = xyz;
  pose.linear() = (Eigen::AngleAxisd(rpy.z(), Eigen::Vector3d::UnitZ()) *
                   Eigen::AngleAxisd(rpy.y(), Eigen::Vector3d::UnitY()) *
                   Eigen::AngleAxisd(rpy.x(), Eigen::Vector3d::UnitX()))
                      .toRotationMatrix();
  return pose;
}

}  // namespace goalnet::scene
