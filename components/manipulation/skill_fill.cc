// fill, at a dispenser.
#include <numbers>

#include "components/manipulation/skills.h"

namespace goalnet::manipulation {

Expected<Phases> FillSkill::use(Workbench& bench, std::size_t arm) {
  const auto& scene = bench.scene();
  const auto* fixture = scene.find_fixture(outlet_.fixture);
  Eigen::Vector3d outlet = fixture->pose * outlet_.outlet;
  if (const auto ref = scene.find_part(outlet_.part); !outlet_.part.empty() && ref) {
    outlet = scene::part_pose(*ref.fixture, *ref.part,
                              [&](const std::string& joint) { return bench.world().joint(joint); }) *
             outlet_.outlet;
  }
  const auto& cavity = *scene.find_model_of(held_)->cavity;
  const Eigen::Vector3d in_front = -fixture->pose.linear().col(0);
  const Pose grip = bench.held()[arm]->object_in_tool.inverse();
  std::vector<Reach> reaches;
  for (const double below : {0.05, 0.09, 0.14}) {
    for (int h = 0; h < 16; ++h) {
      Pose under = Pose::Identity();
      under.linear() =
          Eigen::AngleAxisd(h * std::numbers::pi / 8, Eigen::Vector3d::UnitZ()).toRotationMatrix();
      under.translation() =
          outlet - Eigen::Vector3d(0, 0, below) - under.linear() * cavity.mouth.translation();
      Reach reach;
      reach.arm = arm;
      reach.tag = reaches.size();
      reach.tool = {moved(under, 0.16 * in_front) * grip, under * grip};
      reach.opening = bench.opening_of(bench.now(), arm);
      reach.preference = 5.0 * below;
      reaches.push_back(std::move(reach));
    }
  }
  std::erase_if(reaches, [&](const Reach& r) { return failed_.contains(r.tag); });
  StandSearchOptions options;
  options.most_reaches = reaches.size();
  Phases phases;
  const auto found = add_way_there(phases, bench, reaches, options, what_);
  if (!found) return tl::unexpected<Error>(found.error());
  const Reach reach = *found;
  failed_.insert(reach.tag);
  Phase there = straight("fill", arm, {reach.tool[1]}, reach.tolerances, 0.5);
  there.settle = outlet_.after + 0.5;
  there.check = [vessel = held_, adds = outlet_.adds, what = what_](Workbench& b) -> Expected<void> {
    for (const auto& value : adds) {
      if (!b.world().facts.contains({"state", vessel, value}))
        return fail(Outcome::kMotionFailed, what + ": nothing ran into it");
    }
    return {};
  };
  phases.push_back(there);
  phases.push_back(straight("return", arm, {reach.tool[0]}, reach.tolerances, 0.8));
  return phases;
}

}  // namespace goalnet::manipulation
