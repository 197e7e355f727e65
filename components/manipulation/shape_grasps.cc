#include "components/manipulation/shape_grasps.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace goalnet::manipulation {
namespace {

using Eigen::Vector3d;

constexpr double kPads = 0.015;        // [m] of the fingers, from their tips, that press
constexpr double kThinnest = 0.004;    // [m] that fingers close upon
constexpr double kPlay = 0.018;        // [m] more than its width that the fingers open at least
constexpr double kWide = 0.040;        // [m] the same where there is room
constexpr double kOffGround = 0.006;   // [m] that finger tips keep from what it lies on
constexpr double kDeep = 0.030;        // [m] that finger tips reach into it at most
constexpr double kDeepest = 0.055;     // [m] the same for round things, which are held by their middle
constexpr double kPastMiddle = 0.008;  // [m] that they reach past its middle: round things slip out otherwise
constexpr double kSteepest = 0.35;     // upward part of an approach that is no longer from a side
constexpr double kLean[] = {0.0, 0.45, -0.45};              // [rad] of the approach, towards the third axis
constexpr double kAlong[] = {0.0, 0.25, -0.25, 0.4, -0.4};  // of its length, from its middle

// A part of space between two planes across one of the thing's axes.
struct Slab {
  int axis = 0;
  double low = 0, high = 0;  // [m]
};

// Extents in the thing's own frame of all shapes that reach into every one of the slabs.
std::optional<scene::Bounds> extents(const std::vector<scene::Shape>& shapes,
                                     const std::vector<Slab>& slabs) {
  std::optional<scene::Bounds> all;
  for (const auto& shape : shapes) {
    const auto box = scene::bounds({shape});
    const bool inside = std::all_of(slabs.begin(), slabs.end(), [&](const Slab& slab) {
      return box.upper[slab.axis] > slab.low && box.lower[slab.axis] < slab.high;
    });
    if (!inside) continue;
    if (!all) {
      all = box;
    } else {
      all->lower = all->lower.cwiseMin(box.lower);
      all->upper = all->upper.cwiseMax(box.upper);
    }
  }
  return all;
}

class Builder {
 public:
  Builder(const scene::ObjectModel& model, const Pose& object, const robot::Gripper& gripper)
      : model_(model), object_(object), gripper_(gripper), whole_(scene::bounds(model.shapes)) {}

  // Closing along `across`, coming along `in` (against the axis if `sign` is positive), anywhere along the
  // third axis.
  void add(int across, int in, double sign) {
    const int along = 3 - across - in;
    const Vector3d from = sign * Vector3d::Unit(in);
    const double up = (object_.linear() * from).z();
    if (up < -0.2) return;  // from below
    const double length = whole_.upper[along] - whole_.lower[along];
    for (const double share : kAlong) {
      const double at = 0.5 * (whole_.lower[along] + whole_.upper[along]) + share * length;
      const Slab fingers{along, at - gripper_.pad_width / 2, at + gripper_.pad_width / 2};
      const auto box = extents(model_.shapes, {fingers});
      if (!box) continue;
      const double wide = box->upper[across] - box->lower[across];
      if (wide < kThinnest || wide + kPlay > 2 * gripper_.open) continue;
      const double thick = box->upper[in] - box->lower[in];
      const double ground = up > 1 - kSteepest ? kOffGround : 0.0;
      const double deep = std::min(thick - ground, std::clamp(thick / 2 + kPastMiddle, kDeep, kDeepest));
      if (deep < 0.003) continue;
      // What lies between the pads may be narrower than what they pass on the way: a bottle's neck.
      const double tips = sign > 0 ? box->upper[in] - deep : box->lower[in] + deep;
      const Slab pads{in, std::min(tips, tips + sign * kPads), std::max(tips, tips + sign * kPads)};
      const auto between = extents(model_.shapes, {fingers, pads});
      if (!between) continue;
      const double width = between->upper[across] - between->lower[across];
      if (width < kThinnest) continue;
      Vector3d tip = Vector3d::Zero();
      tip[across] = 0.5 * (between->lower[across] + between->upper[across]);
      tip[along] = at;
      tip[in] = tips;
      for (const double lean : kLean)
        add(tip, across, std::cos(lean) * from + std::sin(lean) * Vector3d::Unit(along), width, wide,
            std::abs(lean) + std::abs(share) + 0.4 * (1 - up));
    }
  }

  std::vector<GraspCandidate> take() {
    std::stable_sort(out_.begin(), out_.end(),
                     [](const auto& a, const auto& b) { return a.preference < b.preference; });
    return std::move(out_);
  }

 private:
  void add(const Vector3d& tip, int across, const Vector3d& from, double width, double wide,
           double preference) {
    if ((object_.linear() * from).z() < -0.2) return;
    for (const double wider : {kWide, kPlay}) {
      for (const double turn : {1.0, -1.0}) {
        GraspCandidate c;
        c.tool.linear().col(2) = -from;
        c.tool.linear().col(1) = turn * Vector3d::Unit(across);
        c.tool.linear().col(0) = c.tool.linear().col(1).cross(c.tool.linear().col(2));
        c.tool.translation() = tip + from * gripper_.tip;
        c.grasp = static_cast<std::size_t>(across);
        c.width = width;
        c.opening = std::min(2 * gripper_.open, wide + wider);
        c.preference = preference + (wider == kWide ? 0.0 : 0.3);
        out_.push_back(c);
      }
    }
  }

  const scene::ObjectModel& model_;
  const Pose& object_;
  const robot::Gripper& gripper_;
  const scene::Bounds whole_;
  std::vector<GraspCandidate> out_;
};

}  // namespace

std::vector<GraspCandidate> shape_grasps(const scene::ObjectModel& model, const Pose& object,
                                         const robot::Gripper& gripper) {
  Builder builder(model, object, gripper);
  for (int across = 0; across < 3; ++across) {
    for (int in = 0; in < 3; ++in) {
      if (in == across) continue;
      for (const double sign : {1.0, -1.0}) builder.add(across, in, sign);
    }
  }
  return builder.take();
}

}  // namespace goalnet::manipulation
