#include "components/scene/fit.h"

#include <algorithm>
#include <map>

namespace goalnet::scene {
namespace {

using Eigen::Vector3d;

// Half the width of what goes in first when a long thing is stood into something: its end at +x.
double tip_girth(const ObjectModel& model) {
  double most = 0;
  const double end = bounds(model.shapes).upper.x() - 0.02;
  for (const auto& shape : model.shapes) {
    const Vector3d half = half_extents(shape);
    if (shape.pose.translation().x() + half.x() > end) most = std::max(most, half.y());
  }
  return most;
}

}  // namespace

double girth(const ObjectModel& model) {
  double most = 0;
  for (const auto& shape : model.shapes) {
    const Vector3d half = half_extents(shape);
    const Vector3d at = shape.pose.translation();
    const Eigen::Matrix3d turn = shape.pose.linear();
    if (shape.kind == ShapeKind::kSphere || (shape.kind == ShapeKind::kCylinder && turn(2, 2) > 0.99)) {
      most = std::max(most, at.head<2>().norm() + half.x());
      continue;
    }
    for (int corner = 0; corner < 8; ++corner) {
      const Vector3d sign((corner & 1) ? 1 : -1, (corner & 2) ? 1 : -1, (corner & 4) ? 1 : -1);
      most = std::max(most, (shape.pose * Vector3d(half.cwiseProduct(sign))).head<2>().norm());
    }
  }
  return most;
}

bool goes_through(const ObjectModel& thing, const Cavity& cavity) {
  if (cavity.slot) return true;
  if (thing.has_property("IsPlacable")) return tip_girth(thing) + 0.5 * kPlay <= cavity.radius;
  return cavity.shallow() || girth(thing) + kPlay <= cavity.radius;
}

bool goes_under(const ObjectModel& thing, const Region& region) {
  return std::any_of(region.supports.begin(), region.supports.end(), [&](const Support& support) {
    return !support.reserved &&
           (support.clearance <= 0.01 || support.clearance >= thing.height() + kHeadroom);
  });
}

std::vector<std::pair<std::string, std::string>> unfit_pairs(const Scene& scene) {
  std::vector<std::pair<std::string, std::string>> out;
  for (const auto& object : scene.objects) {
    const ObjectModel& thing = scene.model_of(object);
    std::map<std::string, bool> within;  // a larger place: whether any of its compartments will do
    for (const auto& region : scene.regions) {
      const bool fits = goes_under(thing, region);
      if (!fits) out.emplace_back(object.name, region.name);
      if (!region.within.empty()) within[region.within] = within[region.within] || fits;
    }
    for (const auto& [name, fits] : within)
      if (!fits) out.emplace_back(object.name, name);
    const bool goes_in_whole =
        thing.has_property("IsPlacable") || (thing.has_property("IsAddable") && !thing.cavity);
    for (const auto& receiver : scene.objects) {
      const ObjectModel& holder = scene.model_of(receiver);
      // Salt and syrup have openings too, but nothing is put into them.
      if (&receiver == &object || !holder.cavity || holder.has_property("IsAddable") ||
          holder.has_property("IsSqueezeable"))
        continue;
      if (!goes_in_whole && !holder.has_property("IsPlaceableIn")) continue;
      if (!goes_through(thing, *holder.cavity)) out.emplace_back(object.name, receiver.name);
    }
  }
  return out;
}

}  // namespace goalnet::scene
