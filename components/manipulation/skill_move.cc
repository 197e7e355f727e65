// moveto.
#include <algorithm>
#include <cmath>

#include "components/manipulation/place_candidates.h"
#include "components/manipulation/retreat.h"
#include "components/manipulation/skills.h"

namespace goalnet::manipulation {
namespace {

constexpr int kMostStands = 3;
constexpr double kNear = 0.93;  // [m] to the middle of a thing, or to a fixture: the world model says 0.95
constexpr double kNearSupport = 1.12;  // [m] to the edge of a small support: 1.15
constexpr double kSmallSupport = 1.0;  // [m] its longer side
constexpr double kAhead = 1.35;        // [rad] off the robot's front: 1.4

// Whether a robot that stands there is near a fixture and has what it goes to before itself, a little more
// strictly than the world model judges (0.95 m, 1.4 rad): within an arm's reach is not enough. `point`: of a
// burner or a knob, which are judged by their own direction; empty: the nearest point of the fixture counts.
bool stands_before(const Stand& stand, const scene::Fixture& fixture,
                   const std::optional<Eigen::Vector3d>& point) {
  const scene::Bounds bounds = scene::bounds(fixture.shapes);
  const Eigen::Vector3d here(stand.x, stand.y, 0.0);
  Eigen::Vector3d nearest = fixture.pose.inverse() * here;
  nearest = nearest.cwiseMax(bounds.lower).cwiseMin(bounds.upper);
  const Eigen::Vector3d there = fixture.pose * nearest - here, ahead = point ? *point - here : there;
  const double bearing = std::remainder(std::atan2(ahead.y(), ahead.x()) - stand.yaw, 2 * M_PI);
  return std::hypot(there.x(), there.y()) < kNear && std::abs(bearing) < kAhead;
}

// Large and open from above and in front: a worktop, a couch.
bool is_wide(const scene::Region& region) {
  constexpr double kWide = 1.0;  // [m]
  return region.relation == scene::RegionRelation::kOn && region.supports.front().size_y > kWide;
}

// The point of a place within a fixture by which the world model judges whether it lies ahead.
std::optional<Eigen::Vector3d> point_of(const scene::Scene& scene, const std::string& place) {
  if (scene.find_fixture(place) != nullptr) return std::nullopt;
  if (const auto* region = scene.find_region(place); region != nullptr && !region->supports.empty())
    return support_pose(scene, *region, region->supports.front()).translation();
  if (const auto ref = scene.find_part(place)) {
    const auto at_rest = [](const std::string&) { return 0.0; };
    return scene::part_pose(*ref.fixture, *ref.part, at_rest).translation();
  }
  return std::nullopt;
}

// The same for a thing, by itself or by the small support that it stands on.
bool stands_before(const scene::Scene& scene, const Stand& stand, const Eigen::Vector3d& thing,
                   const scene::Region* region) {
  const Eigen::Vector3d here(stand.x, stand.y, 0.0), there = thing - here;
  if (std::abs(std::remainder(std::atan2(there.y(), there.x()) - stand.yaw, 2 * M_PI)) > kAhead) return false;
  if (there.head<2>().norm() < kNear) return true;
  if (region == nullptr) return false;
  for (const auto& support : region->supports) {
    if (std::max(support.size_x, support.size_y) > kSmallSupport) continue;
    const Eigen::Vector3d in = support_pose(scene, *region, support).inverse() * here;
    const Eigen::Vector2d half(support.size_x / 2, support.size_y / 2);
    const Eigen::Vector2d nearest = in.head<2>().cwiseMax(-half).cwiseMin(half);
    if ((nearest - in.head<2>()).norm() < kNearSupport) return true;
  }
  return false;
}

Pose pose_of(const Stand& stand) {
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::AngleAxisd(stand.yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  pose.translation() = Eigen::Vector3d(stand.x, stand.y, stand.lift);
  return pose;
}

// Something for each arm to come near to, without a way to get there.
std::vector<Reach> pointing_at(const Workbench& bench, const Pose& object) {
  std::vector<Reach> out(bench.arm_count());
  for (std::size_t arm = 0; arm < out.size(); ++arm) {
    out[arm].arm = arm;
    out[arm].tool = {object};
  }
  return out;
}

}  // namespace

Expected<Phases> MoveSkill::attempt(Workbench& bench, int number) {
  // Stands that could not be got to are known by now and left out.
  if (number >= kMostStands)
    return fail(Outcome::kMotionFailed, "moveto " + object_ + ": no other way to get there");
  const std::string what = "moveto " + object_;
  if (const auto arm = bench.arm_holding(object_)) {
    const Try here{what, 0, pose_of(bench.stand_of(bench.now()))};
    const auto& facts = bench.world().facts;
    const bool seen_held = facts.empty() || facts.contains({"Grasping", "Robot", object_});
    if (seen_held || !bench.tried().contains(here)) {
      bench.tried().add(here);
      return Phases{};
    }
    // Asked for again, and seen from outside it is not held (it hangs at the edge of a pad): grasp will let
    // go of it and take it anew.
    bench.set_held(*arm, std::nullopt);
  }
  struct Wish {
    std::vector<Reach> reaches;
    bool stand_only = false;
    // Empty: to stand before the furniture.
    std::function<bool(const Configuration&, const Reach&, const std::vector<ArmPositions>&)> accept = {};
  };
  std::vector<Wish> wishes;  // best first
  bool full = true;          // no hand could reach for anything: to stand there is enough
  for (const auto& held : bench.held()) full = full && held.has_value();
  const Pose* pose = bench.world().object(object_);
  std::string place = object_;
  if (pose != nullptr) {
    // To be near means to have it before oneself, not just in reach from the side.
    const auto before_it = [&bench, at = pose->translation()](const Configuration& q, const Reach&,
                                                              const auto&) {
      const Stand stand = bench.stand_of(q);
      const double dx = at.x() - stand.x, dy = at.y() - stand.y;
      return std::hypot(dx, dy) < kNear &&
             std::abs(std::remainder(std::atan2(dy, dx) - stand.yaw, 2 * M_PI)) < 0.7;
    };
    const auto gets_it = [&, before_it](const Configuration& q, const Reach& reach,
                                        const std::vector<ArmPositions>& along) {
      return before_it(q, reach, along) && gets_out(bench, object_, q, reach, along);
    };
    if (!full) wishes.push_back({grasp_reaches(bench, object_), false, gets_it});
    if (!full) wishes.push_back({grasp_reaches(bench, object_), false, before_it});
    const auto* region = region_around(bench, *pose);
    // What no hand can take now (it has fallen over) can be gone to all the same.
    if (full || region == nullptr || is_wide(*region))
      wishes.push_back({pointing_at(bench, *pose), true, before_it});
    if (region != nullptr) place = region->fixture;
  } else if (const auto ref = bench.scene().find_part(object_);
             !full && ref && ref.part->use != scene::PartUse::kDoor) {
    wishes.push_back(
        {ref.part->use == scene::PartUse::kButton ? press_reaches(bench, ref) : part_reaches(bench, ref)});
    place = ref.fixture->name;
  }
  Expected<ReachSolution> solution = fail(Outcome::kMotionFailed, "nothing to go to");
  if (pose != nullptr && bench.checker().rides(object_)) return Phases{};
  const scene::Region* region = bench.scene().find_region(place);
  const scene::Fixture* fixture = bench.scene().find_fixture(region != nullptr ? region->fixture : place);
  const auto point = point_of(bench.scene(), object_);
  const auto before_fixture = [&bench, fixture, point](const Configuration& q, const Reach&, const auto&) {
    return stands_before(bench.stand_of(q), *fixture, point);
  };
  // The last wish is to stand before the furniture.
  if (pose != nullptr) {
    const auto* around = region_around(bench, *pose);
    wishes.push_back(
        {front_reaches(bench, place), full,
         [&bench, at = pose->translation(), around](const Configuration& q, const Reach&, const auto&) {
           return stands_before(bench.scene(), bench.stand_of(q), at, around);
         }});
  }
  wishes.push_back({front_reaches(bench, place), full});
  // With something large in a hand there may be no room for the other one before it.
  if (!full) wishes.push_back({front_reaches(bench, place), true});
  // Elsewhere than where it did not help to go.
  for (const bool anywhere : {false, true}) {
    for (const auto& wish : wishes) {
      if (wish.reaches.empty() || (anywhere && bench.tried().size() == 0)) continue;
      StandSearchOptions options;
      options.stand_only = wish.stand_only;
      options.accept = [&](const Configuration& q, const Reach& reach,
                           const std::vector<ArmPositions>& along) {
        const bool new_place = anywhere || !bench.tried().contains({what, 0, pose_of(bench.stand_of(q))});
        if (!new_place) return false;
        if (wish.accept) return wish.accept(q, reach, along);
        return fixture == nullptr || before_fixture(q, reach, along);
      };
      solution = find_stand(bench, wish.reaches, options);
      if (solution || solution.error().outcome == Outcome::kCancelled) break;
    }
    if (solution || solution.error().outcome == Outcome::kCancelled) break;
  }
  if (!solution) return fail(solution.error().outcome, "moveto " + object_ + ": " + solution.error().message);
  bench.tried().add({what, 0, pose_of(solution->stand)});
  Phases phases;
  add_back_off(phases, bench);
  add_go_to(phases, bench, *solution);
  return phases;
}

}  // namespace goalnet::manipulation
