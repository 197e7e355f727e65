#include "components/visualization/path_drawing.h"

#include <algorithm>
#include <cmath>

namespace goalnet::visualization {
namespace {

constexpr std::size_t kMostPoints = 200;  // of a line
constexpr double kLeast = 0.02;           // [m] shorter ways are not drawn
constexpr double kFloor = 0.02;           // [m] the base's way is drawn this much above the floor
constexpr double kWidth = 0.012;          // [m]

bool finite(const Eigen::Vector3d& point) { return point.allFinite() && point.norm() < 1e4; }

double extent(const std::vector<Eigen::Vector3d>& points) {
  double most = 0.0;
  for (const Eigen::Vector3d& point : points) most = std::max(most, (point - points.front()).norm());
  return most;
}

}  // namespace

void draw_path(const robot::RobotModel& robot, const robot::Kinematics& kinematics, std::vector<double> q,
               const PlannedMotion& motion, std::vector<Drawing>& out) {
  if (q.size() != robot.joints.size() || motion.points.empty()) return;
  std::vector<int> links{kinematics.link_index(robot.base.link)};
  for (const robot::Arm& arm : robot.arms) links.push_back(kinematics.link_index(arm.tool_link));
  std::vector<std::vector<Eigen::Vector3d>> ways(links.size());
  std::vector<robot::Pose> poses;
  const std::size_t stride = (motion.points.size() + kMostPoints - 1) / kMostPoints;
  for (std::size_t i = 0; i < motion.points.size(); i += stride) {
    // The last point is always drawn.
    const auto& point = motion.points[i + stride < motion.points.size() ? i : motion.points.size() - 1];
    if (point.size() != motion.joints.size()) return;
    for (std::size_t j = 0; j < point.size(); ++j) {
      if (const int index = robot.index_of(motion.joints[j]); index >= 0)
        q[static_cast<std::size_t>(index)] = point[j];
    }
    kinematics.forward(q, poses);
    for (std::size_t k = 0; k < links.size(); ++k) {
      if (links[k] < 0) continue;
      Eigen::Vector3d place = poses[static_cast<std::size_t>(links[k])].translation();
      if (!finite(place)) return;
      if (k == 0) place.z() = kFloor;
      ways[k].push_back(place);
    }
  }
  for (std::size_t k = 0; k < ways.size(); ++k) {
    if (ways[k].size() < 2 || extent(ways[k]) < kLeast) continue;
    Drawing drawing;
    drawing.group = "path";
    drawing.id = static_cast<std::int32_t>(k);
    drawing.kind = DrawingKind::kLine;
    drawing.size.x() = kWidth;
    drawing.color =
        k == 0 ? std::array<float, 4>{0.1f, 0.5f, 1.0f, 0.9f} : std::array<float, 4>{0.9f, 0.2f, 0.8f, 0.9f};
    drawing.points = std::move(ways[k]);
    out.push_back(std::move(drawing));
  }
}

}  // namespace goalnet::visualization
