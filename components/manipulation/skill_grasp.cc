// grasp.
#include "components/manipulation/drag.h"
#include "components/manipulation/retreat.h"
#include "components/manipulation/skills.h"

namespace goalnet::manipulation {
namespace {

constexpr int kMostDrags = 4;
constexpr int kFewIterations = 1'500;

// What the phases of one attempt tell each other.
struct GraspState {
  Pose in_tool = Pose::Identity();  // the object as it was when the fingers had closed
  double height = 0;                // [m] of the object then
};

}  // namespace

// Rather a way from which the hand gets out again with the thing; rather one that the scene lists than one by
// its shape (it lies on its side, say). Before one from which it does not, what is in the way is put aside.
Expected<Reach> GraspSkill::find_way(Phases& phases, Workbench& bench) const {
  const std::string what = "grasp " + object_;
  StandSearchOptions options;
  // From the tray: driving would take the object along, and the hand points back.
  options.backwards = bench.checker().rides(object_);
  options.may_drive = !options.backwards;
  Expected<Reach> found = fail(Outcome::kMotionFailed, "");
  bool refused[2] = {false, false};  // ways that can be reached were, because the hand does not get out
  for (const bool anyhow : {false, true}) {
    if (anyhow && bench.in_the_way()) break;
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

Expected<Phases> GraspSkill::drag(Workbench& bench) {
  auto reaches = drag_reaches(bench, object_);
  std::erase_if(reaches, [&](const Reach& r) { return failed_.contains(r.tag); });
  StandSearchOptions options;
  options.most_reaches = 2 * StandSearchOptions{}.most_reaches;
  options.looks_for_obstacles = false;
  Phases phases;
  const auto found = add_way_there(phases, bench, reaches, options, "drag " + object_, object_);
  if (!found) return tl::unexpected<Error>(found.error());
  const Reach reach = *found;
  failed_.insert(reach.tag);
  ++dragged_;
  drags_ = true;
  const auto end = reach.tool.end();
  phases.push_back(straight("press", reach.arm, {reach.tool.begin() + 1, end - 2}, reach.tolerances, 0.4));
  expect_unmoved(phases.back(), bench, object_);
  phases.push_back(straight("drag", reach.arm, {end[-2]}, reach.tolerances, 0.3));
  Phase away = straight("lift off", reach.arm, {end[-1]}, reach.tolerances, 0.8);
  away.settle = 0.2;
  away.check = [object = object_, before = bench.world().object(object_)->translation().eval(),
                wanted =
                    (end[-2].translation() - end[-3].translation()).norm()](Workbench& b) -> Expected<void> {
    const Pose* now = b.world().object(object);
    if (now != nullptr && (now->translation() - before).norm() > 0.5 * wanted) return {};
    return fail(Outcome::kMotionFailed, object + " did not come along when it was dragged");
  };
  phases.push_back(away);
  // From low over things the way to another grasp is hard to find: rather from the posture for driving.
  Phase tuck;
  tuck.stage = "tuck";
  tuck.plan = [arm = reach.arm](Workbench& b) { return b.tuck(arm, kFewIterations); };
  tuck.optional = true;
  phases.push_back(tuck);
  return phases;
}

Expected<Phases> GraspSkill::attempt(Workbench& bench, int) {
  if (const auto arm = bench.arm_holding(object_)) {
    const auto& facts = bench.world().facts;
    if (facts.empty() || facts.contains({"Grasping", "Robot", object_})) return Phases{};
    // Seen from outside it is not held (it hangs at the edge of a pad): let go of it and take it anew.
    bench.set_held(*arm, std::nullopt);
  }
  drags_ = false;
  Phases phases;
  const auto found = find_way(phases, bench);
  if (!found) {
    const bool may_help = found.error().outcome == Outcome::kMotionFailed && !bench.in_the_way();
    if (may_help && only_.empty() && dragged_ < kMostDrags) {
      if (auto dragging = drag(bench)) return dragging;
    }
    return tl::unexpected<Error>(found.error());
  }
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
  lift.plan = [plan = lift.plan, arm, up = std::vector<Pose>{reach.tool.begin() + 2, reach.tool.end()}](
                  Workbench& b) -> Expected<JointTrajectory> {
    auto motion = plan(b);
    return motion ? motion : b.move_straight(arm, up, brushing(b, arm), 0.4);
  };
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

}  // namespace goalnet::manipulation
