#include "sim/device_geometry.h"

#include <algorithm>
#include <cmath>

namespace goalnet::sim {
namespace {

scene::Pose mouth_of(const scene::ObjectModel& model, const scene::Pose& object) {
  return object * model.cavity->mouth;
}

bool upright(const scene::ObjectModel& model, const scene::Pose& object) {
  return mouth_tilt(model, object) < 0.6;
}

// Where contents leave a tilted vessel: the lowest point of the mouth's edge.
Eigen::Vector3d lip(const scene::ObjectModel& model, const scene::Pose& object) {
  const scene::Pose mouth = mouth_of(model, object);
  const Eigen::Vector3d axis = mouth.linear().col(2);
  Eigen::Vector3d down = -Eigen::Vector3d::UnitZ() + axis.z() * axis;
  if (down.norm() < 1e-6) return mouth.translation();
  return mouth.translation() + model.cavity->radius * down.normalized();
}

}  // namespace

double mouth_tilt(const scene::ObjectModel& model, const scene::Pose& object) {
  if (!model.cavity) return 0.0;
  return std::acos(std::clamp(mouth_of(model, object).linear()(2, 2), -1.0, 1.0));
}

bool in_region(const scene::Scene& scene, const scene::Region& region, const scene::Pose& object,
               double slack) {
  const scene::Fixture* fixture = scene.find_fixture(region.fixture);
  if (fixture == nullptr) return false;
  for (const auto& support : region.supports) {
    const Eigen::Vector3d local =
        (fixture->pose * support.frame).inverse() * Eigen::Vector3d(object.translation());
    if (std::abs(local.x()) > support.size_x / 2.0 || std::abs(local.y()) > support.size_y / 2.0) continue;
    const double top = region.relation == scene::RegionRelation::kOn ? slack : support.clearance;
    if (local.z() > -0.02 && local.z() < top) return true;
  }
  return false;
}

Eigen::Vector3d outlet_position(const scene::Scene& scene, const scene::FillRule& rule,
                                const std::function<double(const std::string&)>& joint) {
  const scene::Fixture* fixture = scene.find_fixture(rule.fixture);
  if (fixture == nullptr) return rule.outlet;
  if (!rule.part.empty()) {
    const auto found = scene.find_part(rule.part);
    if (found) return scene::part_pose(*found.fixture, *found.part, joint) * rule.outlet;
  }
  return fixture->pose * rule.outlet;
}

int vessel_below(const scene::Scene& scene, const std::vector<scene::Pose>& objects,
                 const Eigen::Vector3d& outlet, double reach) {
  int best = -1;
  double highest = outlet.z() - reach;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const scene::ObjectModel& model = scene.model_of(scene.objects[i]);
    if (!model.cavity || !model.cavity->liquid || !upright(model, objects[i])) continue;
    const Eigen::Vector3d mouth = mouth_of(model, objects[i]).translation();
    const double off_axis = (mouth - outlet).head<2>().norm();
    if (off_axis > model.cavity->radius || mouth.z() > outlet.z() || mouth.z() < highest) continue;
    highest = mouth.z();
    best = static_cast<int>(i);
  }
  return best;
}

bool pours(const scene::ObjectModel& giver, const scene::Pose& pose) {
  // A spoon, which has no cavity: turned over.
  return giver.cavity ? mouth_tilt(giver, pose) >= giver.cavity->pour_tilt : pose.linear()(2, 2) <= 0.35;
}

bool pours_into(const scene::ObjectModel& giver, const scene::Pose& giver_pose,
                const scene::ObjectModel& receiver, const scene::Pose& receiver_pose) {
  if (!receiver.cavity || !upright(receiver, receiver_pose) || !pours(giver, giver_pose)) return false;
  const Eigen::Vector3d from = giver.cavity ? lip(giver, giver_pose) : tool_tip(giver, giver_pose);
  const Eigen::Vector3d mouth = mouth_of(receiver, receiver_pose).translation();
  // A stream spreads a little: 1 cm beyond the edge still counts.
  return (mouth - from).head<2>().norm() < receiver.cavity->radius + 0.01 && from.z() > mouth.z() - 0.01 &&
         from.z() < mouth.z() + 0.4;
}

bool inside_cavity(const scene::ObjectModel& model, const scene::Pose& object, const Eigen::Vector3d& point) {
  if (!model.cavity) return false;
  const Eigen::Vector3d local = mouth_of(model, object).inverse() * point;
  // A cavity's radius is that of its opening: what leans against the wall is a little beyond it.
  return local.head<2>().norm() < model.cavity->radius + 0.006 && local.z() < 0.0 &&
         local.z() > -model.cavity->depth - 0.01;
}

Eigen::Vector3d lowest_point(const scene::ObjectModel& model, const scene::Pose& object) {
  Eigen::Vector3d lowest = object.translation();
  for (const auto& shape : model.shapes) {
    const scene::Pose pose = object * shape.pose;
    const Eigen::Vector3d half = scene::half_extents(shape);
    const Eigen::Vector3d down =
        -(pose.linear().transpose() * Eigen::Vector3d::UnitZ());  // in the shape's frame
    Eigen::Vector3d local = down * half.x();                      // sphere
    if (shape.kind != scene::ShapeKind::kSphere) {
      for (int axis = 0; axis < 3; ++axis) local[axis] = down[axis] < 0.0 ? -half[axis] : half[axis];
    }
    if (shape.kind == scene::ShapeKind::kCylinder) {
      const double across = down.head<2>().norm();
      local.head<2>() =
          across < 1e-6 ? Eigen::Vector2d::Zero() : Eigen::Vector2d(down.head<2>() / across * half.x());
    }
    const Eigen::Vector3d point = pose * local;
    if (point.z() < lowest.z()) lowest = point;
  }
  return lowest;
}

Eigen::Vector3d tool_tip(const scene::ObjectModel& model, const scene::Pose& object) {
  const scene::Bounds box = scene::bounds(model.shapes);
  // 1.5 cm before the very end: the middle of a spoon's bowl.
  return object * Eigen::Vector3d(box.upper.x() - 0.015, 0.0, 0.5 * (box.lower.z() + box.upper.z()));
}

}  // namespace goalnet::sim
