// Knobs, doors and buttons.
#include <algorithm>
#include <cmath>

#include "components/manipulation/grasp_candidates.h"
#include "components/manipulation/skills.h"

namespace goalnet::manipulation {
namespace {

// Tool poses while a joint turns from where it is to a target, the hand holding on to the part.
std::vector<Pose> arc_of(const Workbench& bench, const scene::Scene::PartRef& ref, const Pose& tool,
                         double from, double to, std::vector<double>& positions) {
  const auto at = [&](double q) {
    return scene::part_pose(*ref.fixture, *ref.part, [&](const std::string& joint) {
      return joint == ref.part->joint.name ? q : bench.world().joint(joint);
    });
  };
  const Pose grip = at(from).inverse() * tool;
  const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(to - from) / 0.07)));
  std::vector<Pose> out;
  for (int i = 1; i <= steps; ++i) {
    positions.push_back(from + (to - from) * i / steps);
    out.push_back(at(positions.back()) * grip);
  }
  return out;
}

// Parts that move when this one does: itself and what hangs from it.
std::vector<std::string> moving_with(const scene::Scene::PartRef& ref) {
  std::vector<std::string> out;
  for (const auto& part : ref.fixture->parts) {
    for (const auto* p = &part;; p = &ref.fixture->parts[static_cast<std::size_t>(p->parent)]) {
      if (p == ref.part) {
        out.push_back(part.name);
        break;
      }
      if (p->parent < 0) break;
    }
  }
  return out;
}

}  // namespace

Expected<Phases> TurnSkill::attempt(Workbench& bench, int number) {
  const auto ref = bench.scene().find_part(part_);
  const double from = bench.world().joint(ref.part->joint.name);
  const double full = on_ ? ref.part->on_position : ref.part->off_position;
  const bool door = ref.part->use == scene::PartUse::kDoor;
  // Already there: within a tenth of the way.
  const double way = std::abs(ref.part->on_position - ref.part->off_position);
  if (std::abs(full - from) < 0.12 * way) return Phases{};
  const std::string what = (on_ ? (door ? "open " : "turn on ") : (door ? "close " : "turn off ")) + part_;

  const auto base = part_reaches(bench, ref);
  if (base.empty()) return fail(Outcome::kMotionFailed, what + ": no empty hand; put something down first");
  Expected<ReachSolution> solution = fail(Outcome::kMotionFailed, "");
  std::vector<Reach> reaches;
  double to = full;
  std::vector<double> positions;
  // A door need not open fully; each attempt may settle for less.
  for (const double share : {1.0, 0.9, 0.8, 0.7}) {
    if (share < 1.0 && (!door || !on_)) break;
    to = from + (full - from) * share;
    reaches = base;
    positions.clear();
    for (auto& reach : reaches) {
      positions.clear();
      const auto arc = arc_of(bench, ref, reach.tool.back(), from, to, positions);
      reach.tool.insert(reach.tool.end(), arc.begin(), arc.end());
      // The hand must also get away from there.
      reach.tool.push_back(backed(arc.back(), bench.params().approach_distance));
      for (const auto& name : moving_with(ref)) {
        reach.tolerances.allow_all(bench.checker().all_parts(), bench.checker().body(name));
      }
    }
    std::erase_if(reaches, [&](const Reach& r) { return failed_.contains(r.tag); });
    StandSearchOptions options;
    options.most_reaches = 200;
    options.accept = [&](const Configuration& start, const Reach& reach,
                         const std::vector<ArmPositions>& along) {
      // The door swings: look at it together with the arm that swings it.
      Tolerances grip;
      for (const auto& name : moving_with(ref)) {
        grip.allow_all(bench.checker().hand_parts(reach.arm), bench.checker().body(name));
      }
      const CollisionQuery query{&bench.checker().all_parts(), 0.01, &grip, false};
      bool free = true;
      std::size_t k =
          0;  // `along` is denser than the arc: walk on to the posture that holds each of its poses
      const Pose base_pose = bench.arm_base_pose(start, reach.arm);
      for (std::size_t i = 0; i < positions.size() && free; ++i) {
        const Eigen::Vector3d at = base_pose.inverse() * reach.tool[2 + i].translation();
        while (k + 1 < along.size() &&
               (bench.arm(reach.arm).forward(along[k]).translation() - at).norm() > 1e-4)
          ++k;
        bench.checker().pose_joint(bench.world(), ref.part->joint.name, positions[i]);
        free = !bench.checker().collides(bench.with_arm(start, reach.arm, along[k]), query);
      }
      bench.checker().pose_joint(bench.world(), ref.part->joint.name, from);
      return free;
    };
    solution = find_stand(bench, reaches, options);
    if (solution || solution.error().outcome == Outcome::kCancelled) break;
  }
  if (!solution) return fail(solution.error().outcome, what + ": " + solution.error().message);
  (void)number;
  const Reach reach = reaches[solution->reach];
  failed_.insert(reach.tag);
  const std::size_t arm = reach.arm;
  const auto& gripper = bench.model().arms[arm].gripper;
  const double width = grasp_candidates(ref.part->grasps, gripper, 24)[reach.tag % 10'000].width;
  const std::string joint = ref.part->joint.name;

  Phases phases;
  add_way(phases, bench, *solution, reach);
  Tolerances hand;
  hand.allow_all(bench.checker().hand_parts(arm), bench.checker().body(ref.part->name));
  phases.push_back(straight("reach", arm, {reach.tool[1]}, hand, 0.8));
  Phase close = fingers("grasp", arm, grip_opening(width, door ? 50.0 : 40.0), 0.15);
  close.check = [=](Workbench& b) -> Expected<void> {
    const double opening = b.opening_of(b.world().robot, arm);
    if (opening < 0.4 * width || opening > width + 0.03) {
      return fail(Outcome::kMotionFailed, what + ": the fingers closed without the handle between them");
    }
    return {};
  };
  phases.push_back(close);
  Phase turn = straight(door ? "swing" : "turn", arm, {reach.tool.begin() + 2, reach.tool.end() - 1},
                        reach.tolerances, 0.6);
  turn.settle = 0.1;
  turn.check = [=](Workbench& b) -> Expected<void> {
    const double now = b.world().joint(joint);
    if (std::abs(now - to) > 0.25 * std::abs(to - from)) {
      return fail(Outcome::kMotionFailed, what + ": the joint stands at " + std::to_string(now).substr(0, 5) +
                                              " instead of " + std::to_string(to).substr(0, 5));
    }
    return {};
  };
  phases.push_back(turn);
  Tolerances touch;
  for (const auto& name : moving_with(ref))
    touch.allow_all(bench.checker().hand_parts(arm), bench.checker().body(name));
  add_let_go(phases, bench, arm, 0.05, touch, Eigen::Vector3d::Zero());
  return phases;
}

Expected<Phases> PressSkill::attempt(Workbench& bench, int) {
  const auto ref = bench.scene().find_part(button_);
  const auto* spot = bench.scene().rules.find_spot(button_);
  if (spot != nullptr && bench.world().object(spot->object) == nullptr)
    return fail(Outcome::kMotionFailed, "press " + button_ + ": " + spot->object + " cannot be seen");
  auto reaches = spot != nullptr ? spot_reaches(bench, *spot) : press_reaches(bench, ref);
  if (reaches.empty())
    return fail(Outcome::kMotionFailed, "press " + button_ + ": no empty hand; put something down first");
  std::erase_if(reaches, [&](const Reach& r) { return failed_.contains(r.tag); });
  Phases phases;
  const auto found = add_way_there(phases, bench, reaches, {}, "press " + button_);
  if (!found) return tl::unexpected<Error>(found.error());
  const Reach reach = *found;
  failed_.insert(reach.tag);
  Phase push = straight("press", reach.arm, {reach.tool[1]}, reach.tolerances, spot != nullptr ? 0.25 : 0.5);
  push.settle = 0.1;
  if (spot == nullptr) {
    push.check = [joint = ref.part->joint.name, on = ref.part->on_position,
                  button = button_](Workbench& b) -> Expected<void> {
      if (b.world().joint(joint) < 0.6 * on) return fail(Outcome::kMotionFailed, button + " did not go down");
      return {};
    };
  }
  phases.push_back(push);
  phases.push_back(straight("retreat", reach.arm, {reach.tool[0]}, reach.tolerances));
  return phases;
}

}  // namespace goalnet::manipulation
