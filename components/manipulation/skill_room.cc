// What stands in the way of an action is put aside first.
#include <algorithm>

#include "components/manipulation/skills.h"

namespace goalnet::manipulation {
namespace {

constexpr int kMostMoved = 4;   // things put aside for one action
constexpr int kMostNested = 2;  // things in the way of things in the way

bool has_free_hand(const Workbench& bench) {
  const auto& held = bench.held();
  return std::any_of(held.begin(), held.end(), [](const auto& hand) { return !hand; });
}

}  // namespace

RoomSkill::RoomSkill(std::unique_ptr<Skill> doing, std::set<std::string> staying, int nested)
    : doing_(std::move(doing)), staying_(std::move(staying)), nested_(nested) {}

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
    bench.set_staying(staying_);
    bench.note_in_the_way(std::nullopt);
    auto phases = doing_->attempt(bench, failed_attempts_);
    if (phases || phases.error().outcome != Outcome::kMotionFailed) return phases;
    const auto what = bench.in_the_way();
    if (!what || moved_ >= kMostMoved || nested_ >= kMostNested || !has_free_hand(bench)) return phases;
    begin_moving(bench, *what);
  }
}

}  // namespace goalnet::manipulation
