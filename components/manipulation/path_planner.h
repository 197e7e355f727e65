// Sampling-based planning in joint space: OMPL's RRTConnect between two configurations, then shortcuts.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "components/core/outcome.h"
#include "components/manipulation/joint_path.h"

namespace goalnet::manipulation {

struct PlannerLimits {
  int iterations = 4000;  // of RRTConnect; there is no time limit, so that results repeat
  double resolution =
      0.015;  // [s] spacing of collision checks along edges, in units of `scale` (time at full speed)
  double range = 0.35;  // [s] longest edge of the trees
  int shortcuts = 40;   // attempts to shorten the path
};

struct PathQuery {
  JointVector start, goal;
  JointVector lower, upper;  // bounds of sampling; start and goal lie within
  JointVector scale;         // 1 / velocity limit: distances are times
  IsFree is_free;
  // Draws a configuration from three or more uniform numbers, or nothing; empty: uniform between the bounds.
  std::function<bool(const std::function<double(double, double)>& uniform, JointVector& out)> sample;
  std::function<bool()> stopped;  // asked often; true ends planning with kCancelled
};

// A free polyline from start to goal. Straight if that is free. kMotionFailed if none is found, with the
// reason. The same query gives the same path, whatever was planned before. One thread of a process at a time:
// OMPL's seeds are global.
Expected<JointPath> plan_path(const PathQuery& query, const PlannerLimits& limits);

}  // namespace goalnet::manipulation
