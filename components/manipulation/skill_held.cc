// What all actions with a held thing share: whether it is in a hand, and in the right way.
#include <algorithm>

#include "components/manipulation/grasp_candidates.h"
#include "components/manipulation/skills.h"

namespace goalnet::manipulation {
namespace {

constexpr double kLies = 0.3;           // [rad] something that leans more has fallen over
constexpr std::size_t kMostGrips = 16;  // looked at: a search for each
constexpr std::size_t kEnough = 4;      // grips that would do
constexpr int kMostRooms = 3;           // things put aside before one place is free

// Much the same grip: where one does not do, the other will not either.
bool alike(const Pose& a, const Pose& b) {
  const Eigen::Quaterniond turn_a(a.linear()), turn_b(b.linear());
  return turn_a.angularDistance(turn_b) < 0.4 && (a.translation() - b.translation()).norm() < 0.03;
}

}  // namespace

Expected<Phases> HeldSkill::attempt(Workbench& bench, int number) {
  if (takes_anew_ && !bench.arm_holding(held_)) return take_->attempt(bench, number);
  takes_anew_ = false;
  std::string occupant;
  if (moving_ == Moving::kNot && rooms_made_ < kMostRooms) {
    auto put = make_room(bench, occupant);
    if (put && !has_free_hand(bench)) {
      if (!std::exchange(asked_for_hand_, true)) {
        bench.note_wants_hand(true);
        return fail(Outcome::kMotionFailed, what_ + ": no hand is free to put " + occupant + " aside");
      }
    } else if (put) {
      ++rooms_made_;
      begin_moving(std::move(occupant), std::move(put));
    }
  }
  if (moving_ != Moving::kNot) {
    auto phases = move_aside(bench, number);
    if (phases ? moving_ != Moving::kNot : phases.error().outcome == Outcome::kCancelled) return phases;
    if (!phases) rooms_made_ = kMostRooms;
    moving_ = Moving::kNot;  // done, or in vain
    if (phases && rooms_made_ < kMostRooms) return attempt(bench, number);
  }
  const auto arm = bench.arm_holding(held_);
  if (!arm) return fail(Outcome::kMotionFailed, what_ + ": " + held_ + " is not in a hand");
  only_prepared_ = false;
  auto phases = use(bench, *arm);
  const bool in_vain = !phases && phases.error().outcome == Outcome::kMotionFailed;
  if (!in_vain) return phases;
  std::set<std::size_t> grips;
  if (!take_ && another_grip_may_help(bench)) grips = other_grips(bench, *arm);
  if (bench.stopped()) return fail(Outcome::kCancelled, what_ + ": cancelled");
  if (grips.empty() && does_with_less()) phases = use(bench, *arm);
  if (grips.empty() && phases) return phases;
  if (grips.empty()) {
    if (!receiver_may_move(bench)) {
      const Pose* receiver = receiver_.empty() ? nullptr : bench.world().object(receiver_);
      if (receiver != nullptr && aside_.empty() && tilt_of(*receiver) > kLies) bench.note_wants_hand(true);
      return phases;
    }
    begin_moving(receiver_, std::make_unique<PlaceSkill>(receiver_, PlaceSkill::Where::kNearest, ""));
    auto aside = move_aside(bench, number);
    if (aside || aside.error().outcome == Outcome::kCancelled) return aside;
    return fail(phases.error().outcome, phases.error().message + "; nor elsewhere: " + aside.error().message);
  }
  auto down = PlaceSkill(held_, PlaceSkill::Where::kNearest, "").use(bench, *arm);
  if (!down) return phases;
  take_ = std::make_unique<GraspSkill>(held_, std::move(grips));
  takes_anew_ = true;
  return down;
}

// Not twice, and not where another place would be no better.
bool HeldSkill::receiver_may_move(const Workbench& bench) const {
  const Pose* pose = receiver_.empty() ? nullptr : bench.world().object(receiver_);
  if (pose == nullptr || !aside_.empty() || bench.supposes()) return false;
  if (bench.arm_holding(receiver_)) return true;
  const auto* region = region_around(bench, *pose);
  const bool has_hand = has_free_hand(bench);
  if (has_hand && tilt_of(*pose) > kLies) return true;  // put down, it stands
  return has_hand && region != nullptr && !is_worktop(bench.scene(), *region);
}

void HeldSkill::begin_moving(std::string thing, std::unique_ptr<Skill> put) {
  aside_ = std::move(thing);
  take_aside_ = std::make_unique<GraspSkill>(aside_);
  put_aside_ = std::move(put);
  moving_ = Moving::kTakes;
}

Expected<Phases> HeldSkill::move_aside(Workbench& bench, int number) {
  const bool in_hand = bench.arm_holding(aside_).has_value();
  if (moving_ == Moving::kTakes && in_hand) moving_ = Moving::kPuts;
  if (moving_ == Moving::kPuts && !in_hand) moving_ = Moving::kNot;
  if (moving_ == Moving::kNot) {
    failed_.clear();  // they failed in another place
    return Phases{};
  }
  return (moving_ == Moving::kTakes ? take_aside_ : put_aside_)->attempt(bench, number);
}

// Tags, as in grasp_reaches, of ways to hold the thing with which use() finds a solution.
std::set<std::size_t> HeldSkill::other_grips(Workbench& bench, std::size_t arm) {
  std::set<std::size_t> good;
  const auto candidates =
      grasp_candidates(bench.scene().find_model_of(held_)->grasps, bench.model().arms[arm].gripper);
  std::vector<Pose> seen{bench.held()[arm]->object_in_tool.inverse()};
  const std::set<std::size_t> failed = std::exchange(failed_, {});
  std::size_t found = 0;
  for (const auto& candidate : candidates) {
    const auto known = [&](const Pose& tool) { return alike(tool, candidate.tool); };
    if (std::any_of(seen.begin(), seen.end(), known)) continue;
    seen.push_back(candidate.tool);
    bench.suppose_grip(arm, candidate.tool.inverse());
    const bool works = use(bench, arm).has_value();
    bench.end_supposition();
    failed_.clear();
    if (works) {
      for (std::size_t i = 0; i < candidates.size(); ++i)
        if (alike(candidates[i].tool, candidate.tool)) good.insert(arm * 10'000 + i);
      ++found;
    }
    if (found == kEnough || seen.size() > kMostGrips || bench.stopped()) break;
  }
  failed_ = failed;
  return good;
}

}  // namespace goalnet::manipulation
