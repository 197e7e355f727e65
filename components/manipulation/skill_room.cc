// What stands in the way of an action is put aside first.
#include <algorithm>

#include "components/manipulation/skills.h"

namespace goalnet::manipulation {
namespace {

constexpr int kMostMoved = 4;   // things put aside for one action
constexpr int kMostNested = 2;  // things in the way of things in the way

// What a hand holds that the action does not need.
std::optional<std::string> may_be_put_down(const Workbench& bench, const std::set<std::string>& staying) {
  for (const auto& hand : bench.held())
    if (hand && !staying.contains(hand->name)) return hand->name;
  return std::nullopt;
}

std::set<std::string> everything(const Workbench& bench) {
  std::set<std::string> names;
  for (const auto& object : bench.scene().objects) names.insert(object.name);
  return names;
}

}  // namespace

RoomSkill::RoomSkill(std::unique_ptr<Skill> doing, std::set<std::string> staying, int nested, Maker again)
    : doing_(std::move(doing)), staying_(std::move(staying)), nested_(nested), again_(std::move(again)) {}

bool RoomSkill::may_move_more() const { return moved_ < kMostMoved && nested_ < kMostNested; }

void RoomSkill::begin_moving(const Workbench& bench, const InTheWay& what) {
  aside_ = what.things.front();
  std::set<std::string> staying = staying_;
  staying.insert(aside_);
  take_ = std::make_unique<RoomSkill>(std::make_unique<GraspSkill>(aside_), std::move(staying), nested_ + 1);
  const Pose* pose = bench.world().object(aside_);
  const auto* region = pose != nullptr ? region_around(bench, *pose) : nullptr;
  put_ = std::make_unique<PlaceSkill>(aside_, PlaceSkill::Where::kNearest,
                                      region != nullptr ? region->name : "", what.place);
  moving_ = Moving::kTakes;
  ++moved_;
}

// With both hands full: one is freed first.
void RoomSkill::begin_putting_down(const std::string& thing, const std::optional<InTheWay>& what) {
  aside_ = thing;
  put_ = std::make_unique<PlaceSkill>(aside_, PlaceSkill::Where::kNearest, "",
                                      what ? std::optional(what->place) : std::nullopt);
  moving_ = Moving::kPuts;
  ++moved_;
}

// What a hand holds that the action does not need, and without which it finds a way.
std::optional<std::string> RoomSkill::hindering(Workbench& bench) const {
  for (std::size_t arm = 0; again_ && arm < bench.arm_count(); ++arm) {
    const auto held = bench.held()[arm];
    if (!held || staying_.contains(held->name)) continue;
    bench.suppose_put_down(arm);
    const auto skill = again_(bench);
    const bool works = skill && skill->attempt(bench, 0).has_value();
    bench.end_supposition();
    if (works) return held->name;
    if (bench.stopped()) break;
  }
  return std::nullopt;
}

// Empty: moved, or it cannot be.
Expected<Phases> RoomSkill::move(Workbench& bench, int number) {
  const bool in_hand = bench.arm_holding(aside_).has_value();
  if (moving_ == Moving::kTakes && in_hand) moving_ = Moving::kPuts;
  if (moving_ == Moving::kPuts && !in_hand) moving_ = Moving::kNot;
  if (moving_ == Moving::kNot) return Phases{};
  auto phases = (moving_ == Moving::kTakes ? take_ : put_)->attempt(bench, number);
  if (phases || phases.error().outcome == Outcome::kCancelled) return phases;
  staying_.insert(aside_);
  moving_ = Moving::kNot;
  return Phases{};
}

Expected<Phases> RoomSkill::attempt(Workbench& bench, int number) {
  if (moving_ == Moving::kNot && number > last_number_) ++failed_attempts_;
  last_number_ = number;
  for (;;) {
    if (moving_ != Moving::kNot) {
      auto phases = move(bench, number);
      if (!phases || moving_ != Moving::kNot) return phases;
    }
    bench.set_staying(may_move_more() ? staying_ : everything(bench));
    bench.note_in_the_way(std::nullopt);
    bench.note_wants_hand(false);
    auto phases = doing_->attempt(bench, failed_attempts_);
    if (phases || phases.error().outcome != Outcome::kMotionFailed) return phases;
    const auto what = bench.in_the_way();
    if (!may_move_more() || bench.stopped()) return phases;
    if (!what && !bench.wants_hand()) {
      const auto thing = hindering(bench);
      if (!thing) return phases;
      begin_putting_down(*thing, std::nullopt);
    } else if (has_free_hand(bench)) {
      if (!what) return phases;
      begin_moving(bench, *what);
    } else {
      const auto thing = may_be_put_down(bench, staying_);
      if (!thing) return phases;
      begin_putting_down(*thing, what);
    }
  }
}

}  // namespace goalnet::manipulation
