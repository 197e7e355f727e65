// Near Robot X: close to the base and in front of it, so that the hands get there without driving.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "components/scene/scene.h"
#include "components/world_model/params.h"
#include "components/world_model/support.h"

namespace goalnet::world_model {

// Judges objects by their middle, fixtures by their nearest point, and what belongs to a fixture (regions,
// knobs: names among the scene's symbols) by the fixture's distance and its own direction.
class Nearness {
 public:
  Nearness(const scene::Scene& scene, const Params& params);

  // `base` is the robot's base in the map frame; its x axis points to the front.
  // `places` tells what each object stands on.
  void update(const scene::Pose& base, const std::vector<ObjectView>& objects,
              const std::vector<Place>& places);
  // The names that are near, sorted.
  std::vector<std::string> names() const;

 private:
  struct Target {
    const scene::Fixture* fixture = nullptr;  // the fixture itself, or the one that it belongs to
    Eigen::Vector2d lower = Eigen::Vector2d::Zero(),
                    upper = Eigen::Vector2d::Zero();  // footprint, fixture's frame
    bool whole = true;                                // the fixture, not a part of it
    Eigen::Vector2d point = Eigen::Vector2d::Zero();  // of a part: in the map frame
  };
  double object_distance(bool was, const scene::Pose& base, const ObjectView& object,
                         const Place& place) const;
  bool near(bool was, double distance, const Threshold& threshold, double bearing) const;

  const scene::Scene& scene_;
  const Params& params_;
  std::map<std::string, Target> targets_;
  std::map<std::string, bool> near_;
};

}  // namespace goalnet::world_model
