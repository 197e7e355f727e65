// Free spots on surfaces and in containers for something that a hand holds.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "components/manipulation/workbench.h"

namespace goalnet::manipulation {

// [m] between what is put down and its neighbours; room for fingers is checked by reaching itself.
constexpr double kPlaceGap = 0.02;

struct PlaceCandidate {
  Pose object = Pose::Identity();           // upright, resting on the surface, in the map frame
  std::vector<Eigen::Vector3d> approaches;  // [m] offsets from which the object may come, last leg straight
  double preference = 0;                    // [s] lower is better
};

// Spots of one region. Named spots for which the object is meant come first (a vessel under the tap), then a
// grid. Every spot is free for the object's footprint at some heading; `headings` about up are tried for
// each.
std::vector<PlaceCandidate> place_candidates(Workbench& bench, const std::string& object,
                                             const scene::Region& region, int headings = 12);

// The outlet of a fixture (a tap) under which a point lies, at most `distance` [m] beside its stream; null:
// none.
const scene::FillRule* outlet_near(const scene::Scene& scene, const scene::Fixture& fixture,
                                   const Eigen::Vector3d& point, double distance);

// How high above the surface the thing must be let go [m] so that the hand that holds it does not touch it: a
// spoon is thinner than the fingers are long. `turn`: as from other_end().
double let_go_height(const Workbench& bench, std::size_t arm, const Pose& turn = Pose::Identity());

// For what stands as well on its other end (a cushion, a book, nothing that holds something): the pose, in
// its frame when it stands upright, of the same thing the other way up, in the same space.
std::optional<Pose> other_end(const scene::ObjectModel& model);

// The regions that a name stands for: itself, or the compartments within it (Fridge).
std::vector<const scene::Region*> regions_of(const scene::Scene& scene, const std::string& name);

// Pose in the map frame of a support's middle.
Pose support_pose(const scene::Scene& scene, const scene::Region& region, const scene::Support& support);

}  // namespace goalnet::manipulation
