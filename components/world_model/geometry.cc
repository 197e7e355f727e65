#include "components/world_model/geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace goalnet::world_model {
namespace {

// Narrows `interval` to |origin + t * direction| <= half on one axis; false if nothing is left.
bool clip_slab(double origin, double direction, double half, Interval& interval) {
  if (std::abs(direction) < 1e-12) return std::abs(origin) <= half;
  double a = (-half - origin) / direction, b = (half - origin) / direction;
  if (a > b) std::swap(a, b);
  interval.low = std::max(interval.low, a);
  interval.high = std::min(interval.high, b);
  return interval.low <= interval.high;
}

// Narrows `interval` to |origin + t * direction| <= radius, in as many dimensions as the vectors have.
template <class Vector>
bool clip_ball(const Vector& origin, const Vector& direction, double radius, Interval& interval) {
  const double a = direction.squaredNorm(), c = origin.squaredNorm() - radius * radius;
  if (a < 1e-12) return c <= 0.0;
  const double b = origin.dot(direction), discriminant = b * b - a * c;
  if (discriminant < 0.0) return false;
  const double root = std::sqrt(discriminant);
  interval.low = std::max(interval.low, (-b - root) / a);
  interval.high = std::min(interval.high, (-b + root) / a);
  return interval.low <= interval.high;
}

}  // namespace

double reach(const scene::Shape& shape, const Eigen::Vector3d& direction) {
  switch (shape.kind) {
    case scene::ShapeKind::kBox:
      return 0.5 * direction.cwiseAbs().dot(shape.size);
    case scene::ShapeKind::kCylinder:
      return 0.5 * std::abs(direction.z()) * shape.size.z() + shape.size.x() * direction.head<2>().norm();
    case scene::ShapeKind::kSphere:
      return shape.size.x();
  }
  return 0.0;
}

HeightRange height_range(const std::vector<scene::Shape>& shapes, const Pose& pose) {
  HeightRange range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const scene::Shape& shape : shapes) {
    if (!shape.solid) continue;
    const double centre = (pose * shape.pose.translation()).z();
    const Eigen::Vector3d up = (pose.linear() * shape.pose.linear()).transpose() * Eigen::Vector3d::UnitZ();
    const double extent = reach(shape, up);
    range.lowest = std::min(range.lowest, centre - extent);
    range.highest = std::max(range.highest, centre + extent);
  }
  if (range.lowest > range.highest) range.lowest = range.highest = pose.translation().z();
  return range;
}

std::optional<Interval> intersect(const scene::Shape& shape, const Eigen::Vector3d& origin,
                                  const Eigen::Vector3d& direction, Interval within) {
  const Eigen::Matrix3d to_shape = shape.pose.linear().transpose();
  const Eigen::Vector3d o = to_shape * (origin - shape.pose.translation()), d = to_shape * direction;
  Interval interval = within;
  switch (shape.kind) {
    case scene::ShapeKind::kBox:
      for (int axis = 0; axis < 3; ++axis)
        if (!clip_slab(o[axis], d[axis], 0.5 * shape.size[axis], interval)) return std::nullopt;
      return interval;
    case scene::ShapeKind::kCylinder:
      if (!clip_slab(o.z(), d.z(), 0.5 * shape.size.z(), interval)) return std::nullopt;
      if (!clip_ball<Eigen::Vector2d>(o.head<2>(), d.head<2>(), shape.size.x(), interval))
        return std::nullopt;
      return interval;
    case scene::ShapeKind::kSphere:
      if (!clip_ball(o, d, shape.size.x(), interval)) return std::nullopt;
      return interval;
  }
  return std::nullopt;
}

double distance_to_rectangle(const Eigen::Vector2d& point, const Eigen::Vector2d& lower,
                             const Eigen::Vector2d& upper, Eigen::Vector2d* nearest) {
  const Eigen::Vector2d clamped = point.cwiseMax(lower).cwiseMin(upper);
  if (nearest != nullptr) *nearest = clamped;
  return (point - clamped).norm();
}

bool is_finite(const Pose& pose) { return pose.matrix().allFinite(); }

}  // namespace goalnet::world_model
