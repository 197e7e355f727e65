#include "components/world_model/nearness.h"

#include <algorithm>
#include <cmath>

#include "components/world_model/geometry.h"

namespace goalnet::world_model {
namespace {

Eigen::Vector2d flat(const Eigen::Vector3d& point) { return point.head<2>(); }

}  // namespace

Nearness::Nearness(const scene::Scene& scene, const Params& params) : scene_(scene), params_(params) {
  const auto belonging_to = [&](const scene::Fixture& fixture) {
    const scene::Bounds bounds = scene::bounds(fixture.shapes);
    return Target{&fixture, flat(bounds.lower), flat(bounds.upper), true, Eigen::Vector2d::Zero()};
  };
  for (const std::string& name : scene.symbols) {
    if (const scene::Fixture* fixture = scene.find_fixture(name)) {
      targets_.emplace(name, belonging_to(*fixture));
    } else if (const scene::Region* region = scene.find_region(name)) {
      const scene::Fixture* owner = scene.find_fixture(region->fixture);
      if (owner == nullptr || region->supports.empty()) continue;
      Target target = belonging_to(*owner);
      target.whole = false;
      target.point = flat((owner->pose * region->supports.front().frame).translation());
      targets_.emplace(name, target);
    } else if (const scene::Scene::PartRef part = scene.find_part(name)) {
      Target target = belonging_to(*part.fixture);
      target.whole = false;
      const auto at_rest = [](const std::string&) { return 0.0; };
      target.point = flat(scene::part_pose(*part.fixture, *part.part, at_rest).translation());
      targets_.emplace(name, target);
    }
  }
}

bool Nearness::near(bool was, double distance, const Threshold& threshold, double bearing) const {
  return with_hysteresis(was, distance, threshold) &&
         with_hysteresis(was, std::abs(bearing), params_.near_bearing);
}

// [m] 0 if the small support that carries the object is near; otherwise the distance to the object itself.
double Nearness::object_distance(bool was, const scene::Pose& base, const ObjectView& object,
                                 const Place& place) const {
  const double direct = (flat(object.pose.translation()) - flat(base.translation())).norm();
  if (place.kind != Place::Kind::kRegion) return direct;
  const scene::Region& region = scene_.regions[place.index];
  const scene::Support& support = region.supports[place.support];
  const scene::Fixture* fixture = scene_.find_fixture(region.fixture);
  if (fixture == nullptr || std::max(support.size_x, support.size_y) > params_.small_support) return direct;
  const Eigen::Vector3d here = (fixture->pose * support.frame).inverse() * base.translation();
  const Eigen::Vector2d half(0.5 * support.size_x, 0.5 * support.size_y);
  const double to_support = distance_to_rectangle(flat(here), -half, half);
  return with_hysteresis(was, to_support, params_.near_support) ? 0.0 : direct;
}

void Nearness::update(const scene::Pose& base, const std::vector<ObjectView>& objects,
                      const std::vector<Place>& places) {
  const Eigen::Vector2d here = flat(base.translation());
  const Eigen::Vector2d front = flat(base.linear().col(0)).normalized();
  const auto bearing = [&](const Eigen::Vector2d& point) {
    const Eigen::Vector2d there = point - here;
    if (there.norm() < 1e-6) return 0.0;
    return std::atan2(front.x() * there.y() - front.y() * there.x(), front.dot(there));
  };
  for (std::size_t i = 0; i < objects.size(); ++i) {
    bool& now = near_[scene_.objects[i].name];
    const Eigen::Vector2d there = flat(objects[i].pose.translation());
    // What the robot carries is not near it, it is with it: the demonstrations see it that way.
    now = objects[i].known && !objects[i].held &&
          near(now, object_distance(now, base, objects[i], places[i]), params_.near_object, bearing(there));
  }
  for (const auto& [name, target] : targets_) {
    const scene::Pose to_fixture = target.fixture->pose.inverse();
    Eigen::Vector2d nearest;
    const double distance =
        distance_to_rectangle(flat(to_fixture * base.translation()), target.lower, target.upper, &nearest);
    if (target.whole) {
      nearest = flat(target.fixture->pose * Eigen::Vector3d(nearest.x(), nearest.y(), 0.0));
    } else {
      nearest = target.point;
    }
    bool& now = near_[name];
    now = near(now, distance, params_.near_fixture, bearing(nearest));
  }
}

std::vector<std::string> Nearness::names() const {
  std::vector<std::string> names;
  for (const auto& [name, is_near] : near_)
    if (is_near) names.push_back(name);
  return names;
}

}  // namespace goalnet::world_model
