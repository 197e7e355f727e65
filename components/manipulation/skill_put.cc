// keep-in a bin or bag, keep-on a plate, add (what is not poured), place-utensil, insert: something goes into
// or onto another movable thing.
#include <cmath>
#include <numbers>

#include "components/manipulation/put_ways.h"
#include "components/manipulation/skills.h"
#include "components/manipulation/two_hands.h"

namespace goalnet::manipulation {
namespace {

// Whether something has come to be in or on the receiver: below its mouth and within it. The world model
// judges more strictly; this is for a second attempt while the hand is still there.
bool went_in(const Workbench& bench, const std::string& object, const std::string& receiver) {
  const Pose* thing = bench.world().object(object);
  const Pose* holder = bench.world().object(receiver);
  if (thing == nullptr || holder == nullptr) return false;
  const auto& cavity = *bench.scene().find_model_of(receiver)->cavity;
  const auto& model = *bench.scene().find_model_of(object);
  const Eigen::Vector3d middle = *holder * cavity.mouth * Eigen::Vector3d::Zero();
  const auto box = scene::bounds(model.shapes);
  const Eigen::Vector3d at = *thing * Eigen::Vector3d(0.5 * (box.lower + box.upper));
  const double reach = cavity.radius + 0.5 * (box.upper - box.lower).norm();
  return lowest_height(model.shapes, *thing) < middle.z() && (at - middle).head<2>().norm() < reach;
}

}  // namespace

Expected<std::vector<Reach>> PutSkill::ways(Workbench& bench, std::size_t arm, const Pose& receiver) const {
  auto found = put_ways(bench, held_, receiver_, receiver);
  if (!found) return tl::unexpected<Error>(found.error());
  const Pose grip = bench.held()[arm]->object_in_tool.inverse();
  std::vector<Reach> reaches;
  for (std::size_t i = 0; i < found->size(); ++i) {
    if (failed_.contains(i)) continue;
    const PutWay& way = (*found)[i];
    Reach reach;
    reach.arm = arm;
    for (const Pose& pose : way.object) reach.tool.push_back(pose * grip);
    const int thing = bench.checker().attachment(arm);
    if (const auto other = bench.arm_holding(receiver_)) {
      reach.tolerances.allow_self(thing, bench.checker().attachment(*other), way.gap);
    } else {
      reach.tolerances.allow(thing, bench.checker().body(receiver_), way.gap);
    }
    reach.opening = bench.opening_of(bench.now(), arm);
    reach.preference = way.preference;
    reach.tag = i;
    reaches.push_back(std::move(reach));
  }
  return reaches;
}

Expected<Phases> PutSkill::use(Workbench& bench, std::size_t arm) {
  const Pose* pose = bench.world().object(receiver_);
  if (pose == nullptr) return fail(Outcome::kMotionFailed, what_ + ": " + receiver_ + " cannot be seen");
  const auto here = ways(bench, arm, *pose);
  if (!here) return fail(here.error().outcome, what_ + ": " + here.error().message);
  Phases phases;
  Expected<Reach> found = fail(Outcome::kMotionFailed, "");
  if (const auto other = bench.arm_holding(receiver_)) {
    const auto at = [&](const Pose& held) { return ways(bench, arm, held).value_or(std::vector<Reach>()); };
    found = add_way_with_both(phases, bench, *other, at, what_);
  } else {
    StandSearchOptions options;
    options.backwards = bench.checker().rides(receiver_);
    options.may_drive = !options.backwards;
    options.most_reaches = here->size();
    found = add_way_there(phases, bench, *here, options, what_, receiver_);
  }
  if (!found) return tl::unexpected<Error>(found.error());
  const Reach reach = *found;
  failed_.insert(reach.tag);
  Phase lower = straight("put in", arm, {reach.tool.begin() + 1, reach.tool.end()}, reach.tolerances, 0.5);
  lower.settle = 0.1;
  expect_unmoved(lower, bench, receiver_);
  phases.push_back(lower);
  Tolerances touch;
  touch.allow_all(bench.checker().hand_parts(arm), bench.checker().body(held_));
  add_let_go(phases, bench, arm, 0.03, touch, Eigen::Vector3d(0, 0, 0.05));
  Phase& last = phases.back();
  last.settle = 0.4;  // falling into a deep bin takes a quarter of a second
  last.check = [object = held_, receiver = receiver_, what = what_](Workbench& b) -> Expected<void> {
    if (went_in(b, object, receiver)) return {};
    return fail(Outcome::kMotionFailed, what + ": " + object + " missed " + receiver);
  };
  return phases;
}

}  // namespace goalnet::manipulation
