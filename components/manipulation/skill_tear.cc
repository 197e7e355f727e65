// open, for bags.
#include "components/manipulation/grasp_candidates.h"
#include "components/manipulation/skills.h"
#include "components/manipulation/two_hands.h"

namespace goalnet::manipulation {
namespace {

constexpr double kPull = 0.015;  // [m]
constexpr double kForce = 10.0;  // [N] of the pulling fingers: the holding hand bears more

}  // namespace

Expected<Phases> TearSkill::use(Workbench& bench, std::size_t holder) {
  std::size_t arm = bench.arm_count();
  for (std::size_t other = 0; other < bench.arm_count(); ++other)
    if (other != holder && !bench.held()[other]) arm = other;
  if (arm == bench.arm_count())
    return fail(Outcome::kMotionFailed, what_ + ": no empty hand; put something down first");
  const auto& model = *bench.scene().find_model_of(held_);
  const auto& gripper = bench.model().arms[arm].gripper;
  const auto candidates = grasp_candidates(model.grasps, gripper);
  const double top = model.height();
  const auto ways = [&](const Pose& held) {
    std::vector<Reach> reaches;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      if (failed_.contains(i)) continue;
      const Pose tool = held * candidates[i].tool;
      Reach reach;
      reach.arm = arm;
      reach.tool = {backed(tool, bench.params().approach_distance), tool, backed(tool, kPull)};
      for (const int part : bench.checker().hand_parts(arm))
        reach.tolerances.allow_self(part, bench.checker().attachment(holder), -1.0);
      reach.opening = candidates[i].opening;
      // Near its top edge.
      reach.preference = candidates[i].preference + 20.0 * (top - candidates[i].tool.translation().z());
      reach.tag = i;
      reaches.push_back(std::move(reach));
    }
    return reaches;
  };
  Phases phases;
  const auto found = add_way_with_both(phases, bench, holder, ways, what_);
  if (!found) return tl::unexpected<Error>(found.error());
  const Reach reach = *found;
  failed_.insert(reach.tag);
  const double width = candidates[reach.tag].width;
  phases.push_back(straight("reach", arm, {reach.tool[1]}, reach.tolerances, 0.6));
  Phase close = fingers("take", arm, grip_opening(width, kForce), 0.4);
  close.check = [=, what = what_](Workbench& b) -> Expected<void> {
    const double opening = b.opening_of(b.world().robot, arm);
    if (opening > 0.4 * width && opening < width + 0.03) return {};
    return fail(Outcome::kMotionFailed, what + ": the fingers closed without it between them");
  };
  phases.push_back(close);
  Phase pull = straight("pull", arm, {reach.tool[2]}, reach.tolerances, 0.2);
  pull.settle = 0.2;
  phases.push_back(pull);
  Phase open = fingers("let go", arm, std::min(0.119, width + 0.04), 0.1);
  phases.push_back(open);
  phases.push_back(straight("retreat", arm, {reach.tool[0]}, reach.tolerances));
  return phases;
}

}  // namespace goalnet::manipulation
