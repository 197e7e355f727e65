// Geometry of primitive shapes, as far as facts need it.
#pragma once

#include <optional>
#include <vector>

#include "components/scene/shape.h"

namespace goalnet::world_model {

using scene::Pose;

// How far the shape reaches from its centre along a unit direction given in the shape's own frame [m].
double reach(const scene::Shape& shape, const Eigen::Vector3d& direction);

// Heights of the lowest and the highest point of solid shapes whose owner stands at `pose` [m].
struct HeightRange {
  double lowest = 0.0;
  double highest = 0.0;
};
HeightRange height_range(const std::vector<scene::Shape>& shapes, const Pose& pose);

// The part of the line origin + t * direction, low <= t <= high, that lies inside the shape. Origin and
// direction (unit) are in the frame of the shape's owner.
struct Interval {
  double low = 0.0;
  double high = 0.0;
};
std::optional<Interval> intersect(const scene::Shape& shape, const Eigen::Vector3d& origin,
                                  const Eigen::Vector3d& direction, Interval within);

// Distance from a point to an axis-aligned rectangle; 0 inside [m]. Tells the nearest point on request.
double distance_to_rectangle(const Eigen::Vector2d& point, const Eigen::Vector2d& lower,
                             const Eigen::Vector2d& upper, Eigen::Vector2d* nearest = nullptr);

bool is_finite(const Pose& pose);

}  // namespace goalnet::world_model
