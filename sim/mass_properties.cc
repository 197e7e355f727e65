#include "sim/mass_properties.h"

#include <algorithm>

#include <Eigen/Eigenvalues>

namespace goalnet::sim {
namespace {

// Bullet's solver behaves badly with inertias far below mass times squared finger width; this is a 3 mm
// radius.
double least_inertia(double mass) { return mass * 9e-6; }

Eigen::Vector3d inertia_of_shape(const scene::Shape& shape, double mass) {
  const Eigen::Vector3d& s = shape.size;
  switch (shape.kind) {
    case scene::ShapeKind::kBox: {
      const Eigen::Vector3d q = s.cwiseProduct(s);
      return mass / 12.0 * Eigen::Vector3d(q.y() + q.z(), q.x() + q.z(), q.x() + q.y());
    }
    case scene::ShapeKind::kCylinder: {
      const double across = mass * (3.0 * s.x() * s.x() + s.z() * s.z()) / 12.0;
      return {across, across, mass * s.x() * s.x() / 2.0};
    }
    case scene::ShapeKind::kSphere:
      return Eigen::Vector3d::Constant(0.4 * mass * s.x() * s.x());
  }
  return Eigen::Vector3d::Zero();
}

Eigen::Matrix3d point_mass_tensor(double mass, const Eigen::Vector3d& offset) {
  return mass * (offset.squaredNorm() * Eigen::Matrix3d::Identity() - offset * offset.transpose());
}

}  // namespace

Eigen::Matrix3d inertia_tensor(const MassProperties& properties) {
  const Eigen::Matrix3d axes = properties.center.linear();
  return axes * properties.inertia.asDiagonal() * axes.transpose();
}

MassProperties mass_of_tensor(double mass, const scene::Pose& center, const Eigen::Matrix3d& inertia) {
  MassProperties result;
  result.mass = mass;
  result.center = center;
  const Eigen::Matrix3d symmetric = 0.5 * (inertia + inertia.transpose());
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  Eigen::Vector3d values = symmetric.diagonal();
  const double off_diagonal =
      std::max({std::abs(symmetric(0, 1)), std::abs(symmetric(0, 2)), std::abs(symmetric(1, 2))});
  if (off_diagonal > 1e-9 * (1e-9 + values.cwiseAbs().maxCoeff())) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(symmetric);
    axes = solver.eigenvectors();
    values = solver.eigenvalues();
    if (axes.determinant() < 0.0) axes.col(0) = -axes.col(0);
  }
  result.center.linear() = center.linear() * axes;
  result.inertia = values.cwiseMax(least_inertia(mass));
  return result;
}

MassProperties combine(const MassProperties& a, const MassProperties& b) {
  if (b.mass <= 0.0) return a;
  if (a.mass <= 0.0) return b;
  const double mass = a.mass + b.mass;
  scene::Pose center = scene::Pose::Identity();
  center.translation() = (a.mass * a.center.translation() + b.mass * b.center.translation()) / mass;
  Eigen::Matrix3d tensor = Eigen::Matrix3d::Zero();
  for (const MassProperties* part : {&a, &b}) {
    tensor += inertia_tensor(*part) +
              point_mass_tensor(part->mass, part->center.translation() - center.translation());
  }
  return mass_of_tensor(mass, center, tensor);
}

MassProperties mass_of_shapes(const std::vector<scene::Shape>& shapes, double mass) {
  double total = 0.0;
  for (const auto& shape : shapes) total += shape.solid ? scene::volume(shape) : 0.0;
  MassProperties result;
  for (const auto& shape : shapes) {
    if (!shape.solid || total <= 0.0) continue;
    const double share = mass * scene::volume(shape) / total;
    MassProperties part{share, shape.pose, inertia_of_shape(shape, share)};
    result = combine(result, part);
  }
  result.mass = mass;
  result.inertia = result.inertia.cwiseMax(least_inertia(mass));
  return result;
}

}  // namespace goalnet::sim
