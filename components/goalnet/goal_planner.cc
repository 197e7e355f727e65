#include "components/goalnet/goal_planner.h"

#include <algorithm>

namespace goalnet::inference {
namespace {

using namespace symbol;

bool is_held_vessel(SymFact fact) { return relation_of(fact) == Relation::kGrasping; }

void offer_state(std::vector<SymAction>& list, const SymState& state, Symbol object, Symbol value) {
  const auto offer = [&](Verb verb, Symbol x, Symbol y = kNone) { list.push_back({verb, x, y}); };
  if (value == kTapIsOn) offer(Verb::kTurn, kSinkKnob);
  if (value >= kStoveFire1 && value <= kStoveFire4)
    offer(Verb::kTurn, static_cast<Symbol>(kStoveKnob_1 + (value - kStoveFire1)));
  if (value == kMicrowaveIsOn) offer(Verb::kPress, kMicrowaveButton), offer(Verb::kOpen, kMicrowave);
  if (value == kWaterDispenserIsOpen) offer(Verb::kPress, kFridgeButton), offer(Verb::kOpen, kFridgeLeftDoor);
  if (value == kDoorIsOpen) offer(Verb::kOpen, kMicrowave), offer(Verb::kClose, kMicrowave);
  if (value == kLeftDoorIsOpen) offer(Verb::kOpen, kFridgeLeftDoor), offer(Verb::kClose, kFridgeLeftDoor);
  if (value == kRightDoorIsOpen) offer(Verb::kOpen, kFridgeRightDoor), offer(Verb::kClose, kFridgeRightDoor);
  if (value == kIsOpen) offer(Verb::kOpen, kBagOfChips_1);
  if (value == kIsOn) {
    offer(Verb::kPress, state.holds(kTv_1Remote_1) ? kTv_1Remote_1PowerButton : kTv_1PowerButton);
  }
  const bool remote = state.holds(kTv_1Remote_1);
  if (value == kVolume)
    for (const Symbol button : {remote ? kTv_1Remote_1VolumeUpButton : kTv_1VolumeUpButton,
                                remote ? kTv_1Remote_1VolumeDownButton : kTv_1VolumeDownButton})
      offer(Verb::kPress, button);
  if (value >= kChannel1 && value <= kChannel6)
    for (const Symbol button : {remote ? kTv_1Remote_1ChannelUpButton : kTv_1ChannelUpButton,
                                remote ? kTv_1Remote_1ChannelDownButton : kTv_1ChannelDownButton})
      offer(Verb::kPress, button);
  if (value == kWater) {
    offer(Verb::kKeepOn, object, kSink), offer(Verb::kTurn, kSinkKnob), offer(Verb::kPress, kFridgeButton);
  }
  if (value == ktemperatureHigh)
    for (int i = 0; i < 4; ++i)
      offer(Verb::kKeepOn, object, static_cast<Symbol>(kStoveFire1 + i)),
          offer(Verb::kTurn, static_cast<Symbol>(kStoveKnob_1 + i));
  if (value >= kWater && value <= kEgg) {
    offer(Verb::kPour, object);
    for (const SymFact fact : state.facts())
      if (relation_of(fact) == Relation::kState && object_of(fact) == value && subject_of(fact) != object)
        offer(Verb::kPourInto, subject_of(fact), object), offer(Verb::kSqueeze, subject_of(fact), object);
    if (value == kSalt) offer(Verb::kAdd, kSalt_1, object);
    if (value == kRamen) offer(Verb::kAdd, kRamen_1, object);
    if (value == kEgg) offer(Verb::kAdd, kBoiledEgg_1, object);
    if (value == kIceCream) offer(Verb::kAdd, kIceCreamScoop, object);
  }
  if (value == kScoopsLeft) {
    for (const SymFact fact : state.facts())
      if (relation_of(fact) == Relation::kState && object_of(fact) == kScoopsLeft &&
          subject_of(fact) != object)
        offer(Verb::kScoop, object, subject_of(fact));
    for (const SymFact fact : state.facts())
      if (is_held_vessel(fact)) offer(Verb::kAdd, kIceCreamScoop, object_of(fact));
  }
  if (value == kFork) offer(Verb::kPlace, kFork_1, object);
  if (value == kSpoon) offer(Verb::kPlace, kSpoon_1, object);
  if (value == kCD)
    for (const SymFact fact : state.facts())
      if (relation_of(fact) == Relation::kState && object_of(fact) == kCD && subject_of(fact) != object)
        offer(Verb::kInsert, subject_of(fact), object);
}

// Actions that could make one predicate of the goal true (or false).
void offer_for(std::vector<SymAction>& list, const SymState& state, SymFact fact, bool positive) {
  const Symbol a = subject_of(fact), b = object_of(fact);
  const auto offer = [&](Verb verb, Symbol x, Symbol y = kNone) { list.push_back({verb, x, y}); };
  switch (relation_of(fact)) {
    case Relation::kNear:
      if (!positive)
        offer(Verb::kGrasp, b), offer(Verb::kGrasp, a), offer(Verb::kMoveTo, a);
      else if (a == kRobot)
        offer(Verb::kMoveTo, b);
      else
        offer(Verb::kKeepNear, a, b);
      return;
    case Relation::kOn:
      if (positive)
        offer(Verb::kKeepOn, a, b);
      else
        offer(Verb::kGrasp, a), offer(Verb::kGrasp, b);
      return;
    case Relation::kIn:
      if (!positive) return offer(Verb::kGrasp, a), offer(Verb::kGrasp, b);
      offer(Verb::kKeepIn, a, b), offer(Verb::kInsert, a, b), offer(Verb::kAdd, a, b),
          offer(Verb::kPlace, a, b);
      return;
    case Relation::kGrasping:
      if (positive) return offer(Verb::kGrasp, b);
      offer(Verb::kRelease, b);
      return;
    case Relation::kState:
      return offer_state(list, state, a, b);
    default:
      return;
  }
}

}  // namespace

SymGoal to_sym_goal(const Goal& goal, Symbols& symbols) {
  SymGoal result;
  const auto convert = [&](const std::vector<Predicate>& from, std::vector<SymFact>& to) {
    to = to_sym_state(FactSet(from), symbols).facts();
  };
  convert(goal.positive, result.positive);
  convert(goal.negative, result.negative);
  return result;
}

bool satisfied(const SymGoal& goal, const SymState& state) {
  return std::all_of(goal.positive.begin(), goal.positive.end(), [&](SymFact f) { return state.has(f); }) &&
         std::none_of(goal.negative.begin(), goal.negative.end(), [&](SymFact f) { return state.has(f); });
}

std::optional<std::vector<SymAction>> GoalPlanner::plan(const SymGoal& goal, const SymState& state) const {
  if (satisfied(goal, state)) return std::vector<SymAction>{};
  std::vector<SymAction> offers;
  for (const SymFact fact : goal.positive)
    if (!state.has(fact)) offer_for(offers, state, fact, true);
  for (const SymFact fact : goal.negative)
    if (state.has(fact)) offer_for(offers, state, fact, false);

  const auto reached_by = [&](std::span<const SymAction> run) {
    SymState after = state;
    for (const SymAction& action : run) apply(action, after);
    return satisfied(goal, after) ? std::optional(delta(state, after)) : std::nullopt;
  };
  // One action, the one that changes least besides; then the natural run to one action, the shortest.
  std::optional<std::vector<SymAction>> best;
  std::size_t best_cost = 0;
  for (const SymAction& offer : offers) {
    const auto run = with_means(offer, state);
    if (run.empty()) continue;
    const auto change = reached_by(run);
    if (!change) continue;
    const std::size_t cost = run.size() * 1000 + change->added.size() + change->removed.size();
    if (!best || cost < best_cost) best = run, best_cost = cost;
  }
  if (best) return best;
  if (full_planner_) {
    auto plan = full_planner_(goal, state);
    if (plan) return plan;
  }
  // One predicate after the other; accepted when all hold in the end.
  std::vector<SymAction> actions;
  SymState now = state;
  for (int round = 0; round < 2 && !satisfied(goal, now); ++round) {
    const auto reach = [&](SymFact fact, bool positive) {
      if (now.has(fact) == positive) return;
      const SymGoal one{positive ? std::vector{fact} : std::vector<SymFact>{},
                        positive ? std::vector<SymFact>{} : std::vector{fact}};
      std::vector<SymAction> single;
      offer_for(single, now, fact, positive);
      for (const SymAction& offer : single) {
        const auto run = with_means(offer, now);
        SymState after = now;
        for (const SymAction& action : run) apply(action, after);
        if (run.empty() || !satisfied(one, after)) continue;
        actions.insert(actions.end(), run.begin(), run.end());
        now = after;
        return;
      }
    };
    for (const SymFact fact : goal.negative) reach(fact, false);
    for (const SymFact fact : goal.positive) reach(fact, true);
  }
  if (satisfied(goal, now)) return actions;
  return std::nullopt;
}

}  // namespace goalnet::inference
