// What manipulation asks the executor to follow. The shape follows trajectory_msgs/JointTrajectory, without
// DDS.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace goalnet::executor {

struct TrajectoryPoint {
  std::int64_t time_ns = 0;  // [ns] since the start of the trajectory; strictly increasing, the first >= 0
  std::vector<double> position;  // [rad or m] one for each of JointTrajectory::joints
  std::vector<double> velocity;  // [rad/s or m/s] the same size, or empty: then monotone slopes are chosen
};

// Joints that are not named hold their position. With the first point at 0 the trajectory must begin where
// the command stands (within JointLimits::start_tolerance; a small rest is blended away); with the first
// point later, the executor moves there from the current command along one cubic. It must end at standstill.
struct JointTrajectory {
  std::int64_t stamp_ns =
      0;  // [ns] names the trajectory in ExecutorStatus; not a start time: it starts at once
  std::vector<std::string> joints;
  std::vector<TrajectoryPoint> points;
};

}  // namespace goalnet::executor
