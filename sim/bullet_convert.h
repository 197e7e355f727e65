// Between Eigen (the project's geometry) and Bullet's types. Used inside sim/ only.
#pragma once

#include <Eigen/Geometry>

#include <LinearMath/btTransform.h>

namespace goalnet::sim {

inline btVector3 to_bullet(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

inline btMatrix3x3 to_bullet(const Eigen::Matrix3d& m) {
  return {m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2), m(2, 0), m(2, 1), m(2, 2)};
}

inline btTransform to_bullet(const Eigen::Isometry3d& pose) {
  return btTransform(to_bullet(Eigen::Matrix3d(pose.linear())),
                     to_bullet(Eigen::Vector3d(pose.translation())));
}

inline Eigen::Vector3d from_bullet(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

inline Eigen::Isometry3d from_bullet(const btTransform& transform) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  const btMatrix3x3& m = transform.getBasis();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) pose.linear()(row, column) = m[row][column];
  }
  pose.translation() = from_bullet(transform.getOrigin());
  return pose;
}

}  // namespace goalnet::sim
