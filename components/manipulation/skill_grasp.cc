// grasp, and the way there.
#include <cmath>

#include "components/manipulation/place_candidates.h"
#include "components/manipulation/retreat.h"
#include "components/manipulation/skills.h"

namespace goalnet::manipulation {
namespace {

constexpr int kMostStands = 3;

// What the phases of one attempt tell each other.
struct GraspState {
  Pose in_tool = Pose::Identity();  // the object as it was when the fingers had closed
  double height = 0;                // [m] of the object then
};

}  // namespace

// Rather a way from which the hand gets out again with the thing; rather one that the scene lists than one by
// its shape (it lies on its side, say).
Expected<Reach> GraspSkill::find_way(Phases& phases, Workbench& bench) const {
  const std::string what = "grasp " + object_;
  StandSearchOptions options;
  // From the tray: driving would take the object along, and the hand points back.
  options.backwards = bench.checker().rides(object_);
  options.may_drive = !options.backwards;
  Expected<Reach> found = fail(Outcome::kMotionFailed, "");
  bool refused[2] = {false, false};  // ways that can be reached were, because the hand does not get out
  for (const bool anyhow : {false, true}) {
    for (const bool by_shape : {false, true}) {
      if ((by_shape && !only_.empty()) || (anyhow && !refused[by_shape])) continue;
      auto reaches = grasp_reaches(bench, object_, by_shape);
      if (reaches.empty() && !by_shape)
        return fail(Outcome::kMotionFailed,
                    "no empty hand for " + object_ + ", or it cannot be seen; put something down first");
      std::erase_if(reaches, [&](const Reach& r) {
        return failed_.contains(r.tag) || (!only_.empty() && !only_.contains(r.tag));
      });
      if (reaches.empty() && by_shape) continue;
      options.most_reaches =
          options.backwards && !by_shape ? reaches.size() : StandSearchOptions{}.most_reaches;
      options.accept = nullptr;
      if (!anyhow && !options.backwards) {
        options.accept = [&](const Configuration& start, const Reach& reach,
                             const std::vector<ArmPositions>& along) {
          const bool fine = gets_out(bench, object_, start, reach, along);
          refused[by_shape] |= !fine;
          return fine;
        };
      }
      auto way = add_way_there(phases, bench, reaches, options, what, object_);
      if (way || way.error().outcome == Outcome::kCancelled) return way;
      if (found.error().message.empty()) found = std::move(way);
    }
  }
  return found;
}

Expected<Phases> GraspSkill::attempt(Workbench& bench, int) {
  if (const auto arm = bench.arm_holding(object_)) {
    const auto& facts = bench.world().facts;
    if (facts.empty() || facts.contains({"Grasping", "Robot", object_})) return Phases{};
    // Seen from outside it is not held (it hangs at the edge of a pad): let go of it and take it anew.
    bench.set_held(*arm, std::nullopt);
  }
  Phases phases;
  const auto found = find_way(phases, bench);
  if (!found) return tl::unexpected<Error>(found.error());
  const Reach reach = *found;
  // A way that fails is not tried again; it is forgotten when it works, as the skill ends then.
  failed_.insert(reach.tag);

  const auto* model = bench.scene().find_model_of(object_);
  const std::size_t arm = reach.arm;
  const double width = reach.width;
  const auto state = std::make_shared<GraspState>();
  const std::string object = object_;

  phases.push_back(straight("reach", arm, {reach.tool[1]}, reach.tolerances, 0.8));
  expect_unmoved(phases.back(), bench, object_);
  Phase close = fingers("grasp", arm, grip_opening(width, model->grip_force), 0.15);
  close.check = [=](Workbench& b) -> Expected<void> {
    const double opening = b.opening_of(b.world().robot, arm);
    if (opening < 0.4 * width || opening > width + 0.03) {
      return fail(Outcome::kMotionFailed, "the fingers closed to " +
                                              std::to_string(opening * 1000).substr(0, 4) + " mm without " +
                                              object + " between them");
    }
    b.set_held(arm, object);
    state->in_tool = b.held()[arm]->object_in_tool;
    state->height = b.world().object(object)->translation().z();
    return {};
  };
  phases.push_back(close);
  Phase lift = straight("lift", arm, {reach.tool.begin() + 2, reach.tool.end()}, reach.tolerances, 0.6);
  lift.settle = 0.1;
  lift.check = [=](Workbench& b) -> Expected<void> {
    const Pose* now = b.world().object(object);
    const Pose in_tool = b.tool_pose(b.world().robot, arm).inverse() * *now;
    const double slip = (in_tool.translation() - state->in_tool.translation()).norm();
    if (slip > 0.03 || now->translation().z() < state->height + 0.01) {
      b.set_held(arm, std::nullopt);
      return fail(Outcome::kMotionFailed, object + " did not come along when the hand was lifted");
    }
    return {};
  };
  phases.push_back(lift);
  return phases;
}

namespace {

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
  return std::hypot(there.x(), there.y()) < 0.93 && std::abs(bearing) < 1.35;
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
  if (bench.arm_holding(object_)) return Phases{};
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
      return std::hypot(dx, dy) < 0.95 &&
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
    if (full || region == nullptr || is_worktop(*region))
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
  wishes.push_back({front_reaches(bench, place), full});
  for (auto& wish : wishes) {
    if (wish.reaches.empty()) continue;
    StandSearchOptions options;
    options.stand_only = wish.stand_only;
    options.accept = std::move(wish.accept);
    if (!options.accept && fixture != nullptr) options.accept = before_fixture;
    solution = find_stand(bench, wish.reaches, options);
    if (solution || solution.error().outcome == Outcome::kCancelled) break;
  }
  if (!solution) return fail(solution.error().outcome, "moveto " + object_ + ": " + solution.error().message);
  Phases phases;
  add_back_off(phases, bench);
  add_go_to(phases, bench, *solution);
  return phases;
}

}  // namespace goalnet::manipulation
