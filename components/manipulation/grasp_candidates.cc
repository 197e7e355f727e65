#include "components/manipulation/grasp_candidates.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace goalnet::manipulation {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kDegree = std::numbers::pi / 180;

// Tool axes from the approach direction (out of the hand) and the closing direction.
Pose tool_pose(const Vector3d& at, const Vector3d& approach, const Vector3d& closing) {
  Pose pose = Pose::Identity();
  Matrix3d r;
  r.col(2) = approach.normalized();
  r.col(1) = (closing - closing.dot(r.col(2)) * r.col(2)).normalized();
  r.col(0) = r.col(1).cross(r.col(2));
  pose.linear() = r;
  pose.translation() = at;
  return pose;
}

Pose flipped(const Pose& pose) { return pose * Eigen::AngleAxisd(std::numbers::pi, Vector3d::UnitZ()); }

std::vector<double> angles_of(const scene::Grasp& grasp, int turns) {
  double low = grasp.angle_min, high = grasp.angle_max;
  if (high - low < 1e-9) {
    if (grasp.kind == scene::GraspKind::kPinch || std::abs(low) > 1e-9) return {low};
    high = low + 2 * std::numbers::pi;
  }
  const double span = high - low;
  const bool full = span > 2 * std::numbers::pi - 1e-6;
  const int n = std::max(1, static_cast<int>(std::round(turns * span / (2 * std::numbers::pi))));
  std::vector<double> out;
  if (full) {
    for (int i = 0; i < n; ++i) out.push_back(low + span * i / n);
  } else {
    for (int i = 0; i <= n; ++i) out.push_back(low + span * i / n);
  }
  return out;
}

class Builder {
 public:
  Builder(const robot::Gripper& gripper, std::vector<GraspCandidate>& out) : gripper_(gripper), out_(out) {}

  void around(std::size_t index, const scene::Grasp& g, int turns) {
    const double middle = 0.5 * (g.low + g.high);
    for (const double angle : angles_of(g, turns)) {
      const Vector3d from(std::cos(angle), std::sin(angle), 0);
      for (const double tilt : tilts(g.tilt_max)) {
        // Leaning: the hand comes from a little above (positive) or below the plane.
        const Vector3d approach = -(std::cos(tilt) * from + std::sin(tilt) * Vector3d::UnitZ());
        const Vector3d closing = Vector3d::UnitZ().cross(from);
        for (const double z : {middle, g.low + 0.85 * (g.high - g.low), g.low + 0.15 * (g.high - g.low)}) {
          // Leaning fingers cover more height; what is long is better held in its middle.
          const double off = std::abs(z - middle) / std::max(1e-6, 0.5 * (g.high - g.low));
          const Vector3d at = Vector3d(0, 0, z) + approach * (g.depth - gripper_.tip);
          add(index, g, tool_pose(at, approach, closing), std::abs(tilt - comfortable(g)) + 0.15 * off);
          if (g.high - g.low < 0.005) break;
        }
      }
    }
  }

  void rim(std::size_t index, const scene::Grasp& g, int turns) {
    for (const double angle : angles_of(g, turns)) {
      const Vector3d radial(std::cos(angle), std::sin(angle), 0);
      for (const double fraction : {0.5, 0.85, 0.2}) {
        const double tilt = fraction * g.tilt_max;
        const Vector3d approach = -(std::cos(tilt) * Vector3d::UnitZ() + std::sin(tilt) * radial);
        const Vector3d at = radial * g.radius + approach * (g.depth - gripper_.tip);
        add(index, g, tool_pose(at, approach, radial), std::abs(fraction - 0.5));
      }
    }
  }

  void pinch(std::size_t index, const scene::Grasp& g) {
    for (const double share : {0.5, 0.0, 1.0}) {
      const double z = g.low + share * (g.high - g.low);
      const Vector3d at = Vector3d(0, 0, z) + Vector3d::UnitX() * (g.depth - gripper_.tip);
      add(index, g, tool_pose(at, Vector3d::UnitX(), Vector3d::UnitY()), std::abs(share - 0.5));
      if (g.high - g.low < 1e-6) break;
    }
  }

 private:
  static double comfortable(const scene::Grasp& g) { return std::min(0.5, 0.7 * g.tilt_max); }
  static std::vector<double> tilts(double tilt_max) {
    if (tilt_max < 1e-6) return {0.0};
    if (tilt_max < 25 * kDegree) return {0.0, 0.8 * tilt_max, -0.8 * tilt_max};
    return {0.5 * tilt_max, 0.8 * tilt_max, 0.25 * tilt_max, 0.0};
  }
  void add(std::size_t index, const scene::Grasp& g, const Pose& in_frame, double preference) {
    GraspCandidate c;
    c.grasp = index;
    c.width = g.width;
    c.opening = std::min(2 * gripper_.open, g.open_width > 0 ? g.open_width : g.width + 0.04);
    c.preference = preference + 0.6 * static_cast<double>(index);
    c.tool = g.frame * in_frame;
    out_.push_back(c);
    c.tool = g.frame * flipped(in_frame);
    out_.push_back(c);
  }

  const robot::Gripper& gripper_;
  std::vector<GraspCandidate>& out_;
};

}  // namespace

std::vector<GraspCandidate> grasp_candidates(const std::vector<scene::Grasp>& grasps,
                                             const robot::Gripper& gripper, int turns) {
  std::vector<GraspCandidate> out;
  Builder builder(gripper, out);
  for (std::size_t i = 0; i < grasps.size(); ++i) {
    switch (grasps[i].kind) {
      case scene::GraspKind::kAround:
        builder.around(i, grasps[i], turns);
        break;
      case scene::GraspKind::kRim:
        builder.rim(i, grasps[i], turns);
        break;
      case scene::GraspKind::kPinch:
        builder.pinch(i, grasps[i]);
        break;
    }
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const auto& a, const auto& b) { return a.preference < b.preference; });
  return out;
}

}  // namespace goalnet::manipulation
