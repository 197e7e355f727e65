#include "components/world_model/support.h"

#include <cmath>
#include <limits>

#include "components/world_model/geometry.h"

namespace goalnet::world_model {
Support::Support(const scene::Scene& scene, const Params& params) : scene_(scene), params_(params) {
  for (const scene::Region& region : scene.regions) {
    const scene::Fixture* fixture = scene.find_fixture(region.fixture);
    auto& frames = support_frames_.emplace_back();
    for (const scene::Support& support : region.supports)
      frames.push_back((fixture != nullptr ? fixture->pose : scene::Pose::Identity()) * support.frame);
  }
  for (const scene::Object& object : scene.objects) {
    const scene::ObjectModel& model = scene.model_of(object);
    const scene::Bounds bounds = scene::bounds(model.shapes);
    middle_.push_back(0.5 * (bounds.lower + bounds.upper));
    footprint_radius_.push_back(model.footprint_radius());
  }
  places_.resize(scene.objects.size());
  extents_.resize(scene.objects.size());
}

void Support::update(const std::vector<ObjectView>& objects, const TrayView& tray) {
  objects_ = objects;
  tray_ = tray;
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    if (!objects_[i].known) continue;
    const HeightRange range = height_range(scene_.model_of(scene_.objects[i]).shapes, objects_[i].pose);
    extents_[i] = {objects_[i].pose * middle_[i], range.lowest, range.highest};
  }
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    if (!objects_[i].known || objects_[i].held) {
      places_[i] = {};
      continue;
    }
    if (places_[i].kind != Place::Kind::kNone && fits(i, places_[i], true, nullptr)) continue;
    places_[i] = objects_[i].resting ? find(i) : Place{};
  }
}

Place Support::find(std::size_t object) const {
  for (const Place::Kind kind : {Place::Kind::kInObject, Place::Kind::kOnObject})
    for (std::size_t other = 0; other < objects_.size(); ++other)
      if (const Place place{kind, other, 0}; fits(object, place, false, nullptr)) return place;
  if (const Place place{Place::Kind::kTray, 0, 0}; fits(object, place, false, nullptr)) return place;
  Place best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t r = 0; r < scene_.regions.size(); ++r)
    for (std::size_t s = 0; s < scene_.regions[r].supports.size(); ++s) {
      double gap = 0.0;
      const Place place{Place::Kind::kRegion, r, s};
      if (!fits(object, place, false, &gap) || gap >= least) continue;
      least = gap;
      best = place;
    }
  return best;
}

bool Support::carries_in_hollow(std::size_t object) const {
  return scene_.model_of(scene_.objects[object]).cavity.has_value();
}

bool Support::fits(std::size_t object, const Place& place, bool loose, double* gap) const {
  switch (place.kind) {
    case Place::Kind::kNone:
      return false;
    case Place::Kind::kInObject:
      return in_object(object, place.index, loose);
    case Place::Kind::kOnObject:
      return on_object(object, place.index, loose, gap);
    case Place::Kind::kTray:
      return tray_.present && on_surface(extents_[object], tray_.pose, tray_.lower, tray_.upper, loose, gap);
    case Place::Kind::kRegion: {
      const scene::Region& region = scene_.regions[place.index];
      const scene::Support& support = region.supports[place.support];
      const scene::Pose& frame = support_frames_[place.index][place.support];
      if (region.relation == scene::RegionRelation::kIn) {
        if (gap != nullptr) *gap = extents_[object].lowest - frame.translation().z();
        return in_region(extents_[object], frame, support, loose);
      }
      const Eigen::Vector2d half(0.5 * support.size_x, 0.5 * support.size_y);
      return on_surface(extents_[object], frame, -half, half, loose, gap);
    }
  }
  return false;
}

bool Support::on_surface(const Extent& extent, const scene::Pose& frame, const Eigen::Vector2d& lower,
                         const Eigen::Vector2d& upper, bool loose, double* gap) const {
  const double height = std::abs(extent.lowest - frame.translation().z());
  const Eigen::Vector3d local = frame.inverse() * extent.middle;
  if (gap != nullptr) *gap = height;
  return with_hysteresis(loose, height, params_.surface_gap) &&
         with_hysteresis(loose, distance_to_rectangle(local.head<2>(), lower, upper), params_.edge);
}

bool Support::in_region(const Extent& extent, const scene::Pose& frame, const scene::Support& support,
                        bool loose) const {
  const Eigen::Vector3d local = frame.inverse() * extent.middle;
  const Eigen::Vector2d half(0.5 * support.size_x, 0.5 * support.size_y);
  const double below = -(extent.lowest - frame.translation().z());
  const double above = extent.middle.z() - (frame.translation().z() + support.clearance);
  return with_hysteresis(loose, distance_to_rectangle(local.head<2>(), -half, half), params_.edge) &&
         with_hysteresis(loose, below, params_.surface_gap) && with_hysteresis(loose, above, {0.0, 0.0});
}

// Inside the hollow of another object: the lowest part below its mouth, the middle not beside it.
bool Support::in_object(std::size_t object, std::size_t other, bool loose) const {
  if (object == other || !objects_[other].known) return false;
  const scene::ObjectModel& model = scene_.model_of(scene_.objects[other]);
  if (!model.cavity || model.cavity->shallow()) return false;
  const scene::Pose mouth = objects_[other].pose * model.cavity->mouth;
  if (mouth.linear().col(2).z() < 0.5) return false;  // lies on its side
  const double margin = loose ? params_.edge.exit : params_.edge.enter;
  // A long thing leans out of a cup: its middle may be above the mouth and a little beside it.
  const Eigen::Vector3d middle = mouth.inverse() * extents_[object].middle;
  const double sideways = middle.head<2>().norm() - model.cavity->radius - std::max(0.0, 0.5 * middle.z());
  const double depth_below_mouth = mouth.translation().z() - extents_[object].lowest;
  const double bottom = mouth.translation().z() - model.cavity->depth;
  return sideways <= margin && depth_below_mouth >= (loose ? 0.2 : 0.3) * model.cavity->depth &&
         extents_[object].lowest >= bottom - params_.surface_gap.exit &&
         extents_[object].lowest > extents_[other].lowest;
}

bool Support::on_object(std::size_t object, std::size_t other, bool loose, double* gap) const {
  if (object == other || !objects_[other].known) return false;
  const scene::ObjectModel& model = scene_.model_of(scene_.objects[other]);
  // A shallow hollow carries on its floor, everything else on its top.
  double top = extents_[other].highest;
  const bool shallow = model.cavity && model.cavity->shallow();
  if (model.cavity && !shallow) return false;  // nothing stands on an open cup
  const double floor =
      shallow ? (objects_[other].pose * model.cavity->mouth).translation().z() - model.cavity->depth : top;
  const double below = floor - extents_[object].lowest, above = extents_[object].lowest - top;
  const double height = std::max(below, above);
  const double sideways =
      (extents_[object].middle - extents_[other].middle).head<2>().norm() - footprint_radius_[other];
  if (gap != nullptr) *gap = std::max(0.0, height);
  return with_hysteresis(loose, height, params_.surface_gap) &&
         with_hysteresis(loose, sideways, params_.edge) &&
         extents_[object].lowest > extents_[other].lowest + 0.002;
}

}  // namespace goalnet::world_model
