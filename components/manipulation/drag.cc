#include "components/manipulation/drag.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "components/manipulation/phases.h"
#include "components/manipulation/place_candidates.h"
#include "components/manipulation/skills.h"

namespace goalnet::manipulation {
namespace {

using Eigen::Vector3d;

constexpr double kDeep = 0.001;  // [m] into the surface: pressed, gently
constexpr double kAbove = 0.06;  // [m] of the finger tips before and after
constexpr double kJustAbove =
    0.015;  // [m] the same under a low board, where the hand comes along its own axis
constexpr double kAlongItself = 0.12;       // [m] so far
constexpr double kTips = 10.0;              // [s] rather slid than tipped over, though that may help as well
constexpr double kLevel = 0.8;              // [rad] of tilt from which it does
constexpr double kSafe = 0.02;              // [m] that its middle keeps from the edge of what it lies on
constexpr double kFlat = 0.15;              // sine of the slope of what can be pressed upon
constexpr double kSameTop = 0.003;          // [m] between parts that are equally high
constexpr double kFingerThickness = 0.014;  // [m]
constexpr double kDistances[] = {0.03, 0.06, 0.10, 0.15, 0.20, 0.26, 0.32};  // [m]
constexpr double kTilts[] = {0.0, 0.45, 0.9, 1.3};  // [rad] of the hand, from straight down
constexpr int kDirections = 8;
constexpr std::size_t kMostTargets = 6;

// Where fingers may press from above: in the middle of its highest parts, and beside.
std::vector<Vector3d> tops(const scene::ObjectModel& model, const Pose& object) {
  std::vector<Vector3d> out;
  double highest = -1e9;
  const auto top_of = [&](const scene::Shape& shape) {
    const Pose pose = object * shape.pose;
    return pose.translation().z() + pose.linear().row(2).cwiseAbs().dot(scene::half_extents(shape));
  };
  for (const auto& shape : model.shapes) highest = std::max(highest, top_of(shape));
  for (const auto& shape : model.shapes) {
    const Pose pose = object * shape.pose;
    const Eigen::RowVector3d up = pose.linear().row(2).cwiseAbs();
    if (up.maxCoeff() < std::sqrt(1 - kFlat * kFlat) || top_of(shape) < highest - kSameTop) continue;
    Vector3d middle = pose.translation();
    middle.z() = top_of(shape);
    out.push_back(middle);
    const Vector3d half = scene::half_extents(shape);
    for (int axis = 0; axis < 3; ++axis) {
      if (up[axis] > kFlat || half[axis] < 0.02) continue;
      for (const double share : {-0.5, 0.5}) {
        Vector3d beside = middle + share * half[axis] * pose.linear().col(axis);
        beside.z() = middle.z();
        out.push_back(beside);
      }
    }
  }
  return out;
}

// The tool with closed fingers whose lowest corner presses on a point.
Pose pressing(const robot::Gripper& gripper, const Vector3d& point, double heading, double tilt) {
  Pose tool = Pose::Identity();
  tool.linear() = (Eigen::AngleAxisd(heading, Vector3d::UnitZ()) *
                   Eigen::AngleAxisd(std::numbers::pi - tilt, Vector3d::UnitY()))
                      .toRotationMatrix();
  // Tilted, one edge of the tips is lowest; else all of them press.
  const double edge = tilt > 0 ? 0.5 * gripper.pad_width : 0.0;
  const Vector3d low = tool.linear() * Vector3d(-edge, 0, gripper.tip),
                 other = tool.linear() * Vector3d(edge, 0, gripper.tip);
  tool.translation() = point - (low.z() < other.z() ? low : other) - Vector3d(0, 0, kDeep);
  return tool;
}

// Whether the middle of a thing is over a support when it has moved; on the floor it is.
bool stays_up(const Workbench& bench, const Pose& object, const Vector3d& middle) {
  const auto* region = region_around(bench, object);
  if (region == nullptr) return object.translation().z() < 0.3;
  return std::ranges::any_of(region->supports, [&](const scene::Support& support) {
    const Vector3d in = support_pose(bench.scene(), *region, support).inverse() * middle;
    return std::abs(in.x()) < support.size_x / 2 - kSafe && std::abs(in.y()) < support.size_y / 2 - kSafe &&
           in.z() > -0.03 && in.z() < std::max(support.clearance, 0.3);
  });
}

// Whether a thing pressed upon at a point slides, instead of tipping over: press and pull must go through
// what it stands on, however hard they are.
class Sliding {
 public:
  Sliding(const Workbench& bench, const scene::ObjectModel& model, const Pose& object)
      : object_(object), box_(scene::bounds(model.shapes)), ground_(lowest_height(model.shapes, object)) {
    const auto* region = region_around(bench, object);
    const auto* fixture = region != nullptr ? bench.scene().find_fixture(region->fixture) : nullptr;
    friction_ = model.friction * (fixture != nullptr ? fixture->friction : kFloorFriction);
  }
  bool works(const Vector3d& point, const Vector3d& by) const {
    const double height = point.z() - ground_;
    const Vector3d through =
        point + kSureness * friction_ * height * by.normalized() - Vector3d(0, 0, height);
    const Vector3d in = object_.inverse() * through;
    return (in.array() > box_.lower.array() - kSlack).all() &&
           (in.array() < box_.upper.array() + kSlack).all();
  }
  // The middle of the thing if it tips over that way, before it is moved.
  Vector3d tipped(const Vector3d& by) const {
    const Vector3d middle = 0.5 * (box_.lower + box_.upper), half = 0.5 * (box_.upper - box_.lower);
    const Vector3d along = object_.linear().transpose() * by.normalized();
    const Eigen::RowVector3d up = object_.linear().row(2);
    const double ahead = along.cwiseAbs().dot(half), height = up.cwiseAbs().dot(half);
    return object_ * middle + (ahead + height) * by.normalized();
  }

 private:
  static constexpr double kFloorFriction = 0.8, kSureness = 1.15;
  static constexpr double kSlack = 0.003;  // [m] it does not lie quite level
  const Pose object_;
  const scene::Bounds box_;
  const double ground_;
  double friction_ = 0.0;
};

// What stands upright with something in it is better not pulled at its rim.
bool may_spill(const Workbench& bench, const std::string& object, const scene::ObjectModel& model,
               const Pose& pose) {
  return model.cavity && model.cavity->liquid && tilt_of(pose) < 0.5 &&
         std::ranges::any_of(bench.world().facts, [&](const Predicate& fact) {
           return fact.relation == "state" && fact.subject == object;
         });
}

bool has_room(const Workbench& bench, const Reach& reach, const Vector3d& by) {
  const Configuration q = bench.with_fingers(bench.now(), reach.arm, reach.opening);
  for (std::size_t i = 0; i < reach.tool.size(); ++i) {
    const bool first = i == 0;
    if (bench.checker().hand_collides(q, reach.arm, moved(reach.tool[i], by),
                                      first ? bench.params().margin : bench.params().contact_margin,
                                      first ? Tolerances() : reach.tolerances))
      return false;
  }
  return true;
}

// How to move the thing so that a hand gets around it that does not where it is; the shortest ways first.
std::vector<Vector3d> targets(Workbench& bench, const std::string& object, const Pose& pose,
                              const Vector3d& middle) {
  std::vector<Reach> blocked;
  for (const bool by_shape : {false, true}) {
    for (auto& reach : grasp_reaches(bench, object, by_shape))
      if (!has_room(bench, reach, Vector3d::Zero())) blocked.push_back(std::move(reach));
  }
  const auto* region = region_around(bench, pose);
  const auto* fixture = region != nullptr ? bench.scene().find_fixture(region->fixture) : nullptr;
  const Vector3d front = fixture != nullptr ? -fixture->pose.linear().col(0) : Vector3d(-Vector3d::UnitX());
  std::vector<Vector3d> out;
  for (const double distance : kDistances) {
    for (int direction = 0; direction < kDirections; ++direction) {
      const Vector3d by =
          distance *
          (Eigen::AngleAxisd(direction * 2 * std::numbers::pi / kDirections, Vector3d::UnitZ()) * front);
      const Pose there = moved(pose, by + Vector3d(0, 0, 0.004));
      if (!stays_up(bench, pose, middle + by) || !bench.checker().object_fits(object, there, 0.001, {}))
        continue;
      if (std::ranges::none_of(blocked, [&](const Reach& reach) { return has_room(bench, reach, by); }))
        continue;
      out.push_back(by);
      if (out.size() == kMostTargets) return out;
    }
  }
  return out;
}

}  // namespace

std::vector<Reach> drag_reaches(Workbench& bench, const std::string& object) {
  std::vector<Reach> out;
  const auto* model = bench.scene().find_model_of(object);
  const Pose* pose = bench.world().object(object);
  if (model == nullptr || pose == nullptr || bench.checker().rides(object)) return out;
  if (may_spill(bench, object, *model, *pose)) return out;
  const auto points = tops(*model, *pose);
  const auto box = scene::bounds(model->shapes);
  const Vector3d middle = *pose * Vector3d(0.5 * (box.lower + box.upper));
  if (points.empty()) return out;
  const Sliding sliding(bench, *model, *pose);
  std::size_t tag = kDrag;
  for (const Vector3d& by : targets(bench, object, *pose, middle)) {
    for (std::size_t arm = 0; arm < bench.arm_count(); ++arm) {
      for (const Vector3d& point : points) {
        for (const double tilt : kTilts) {
          for (int h = 0; h < kDirections; ++h, ++tag) {
            const bool slides = sliding.works(point, by);
            if (bench.held()[arm] || !(slides || stays_up(bench, *pose, sliding.tipped(by) + by))) continue;
            const Pose press = pressing(bench.model().arms[arm].gripper, point,
                                        h * 2 * std::numbers::pi / kDirections, tilt);
            const bool level = tilt > kLevel;
            const Vector3d up(0, 0, level ? kJustAbove : kAbove);
            Reach reach;
            reach.arm = arm;
            reach.tool = {moved(press, up), press, moved(press, by), moved(press, by + up)};
            if (level) reach.tool.insert(reach.tool.begin(), backed(reach.tool.front(), kAlongItself));
            reach.tolerances.allow_all(bench.checker().hand_parts(arm), bench.checker().body(object));
            reach.preference =
                20.0 * by.norm() + tilt + 5.0 * (point - middle).head<2>().norm() + (slides ? 0.0 : kTips);
            reach.tag = tag;
            out.push_back(std::move(reach));
          }
        }
      }
    }
  }
  return out;
}

}  // namespace goalnet::manipulation
