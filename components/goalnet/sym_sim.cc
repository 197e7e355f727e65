#include "components/goalnet/sym_sim.h"

#include <algorithm>
#include <array>
#include <optional>

namespace goalnet::inference {
namespace {

using namespace symbol;

constexpr std::array<Symbol, 11> kContents = {
    kWater, kCoffee, kCoke, kEnergyDrink, kIceCream, kChocolate, kCanadaDry, kVanilla, kSalt, kRamen, kEgg};
constexpr std::size_t kPoured = 9;  // pouring carries the first nine; ramen and egg stay behind

void toggle(SymState& state, SymFact fact) { state.has(fact) ? state.remove(fact) : state.add(fact); }

template <class Act>
void for_each(const SymState& state, Relation relation, Act act) {
  const std::vector<SymFact> facts = state.facts();  // a copy: act() changes the state
  for (const SymFact fact : facts)
    if (relation_of(fact) == relation) act(subject_of(fact), object_of(fact));
}

void set_channel(SymState& state, int step) {
  if (!state.is(kTv_1, kIsOn)) return;
  for (int i = 0; i < 6; ++i) {
    if (!state.is(kTv_1, static_cast<Symbol>(kChannel1 + i))) continue;
    state.remove(sym_fact(Relation::kState, kTv_1, static_cast<Symbol>(kChannel1 + i)));
    state.add(sym_fact(Relation::kState, kTv_1, static_cast<Symbol>(kChannel1 + (i + step + 6) % 6)));
    return;
  }
}

void press(Symbol button, SymState& state) {
  const SymFact volume = sym_fact(Relation::kState, kTv_1, kVolume);
  switch (button) {
    case kMicrowaveButton:  // the recorded simulator's heating rule has its arguments swapped: it never fires
      return toggle(state, sym_fact(Relation::kState, kMicrowave, kMicrowaveIsOn));
    case kFridgeButton:
      toggle(state, sym_fact(Relation::kState, kFridge, kWaterDispenserIsOpen));
      if (state.is(kFridge, kWaterDispenserIsOpen))
        for_each(state, Relation::kGrasping,
                 [&](Symbol, Symbol held) { state.add(sym_fact(Relation::kState, held, kWater)); });
      return;
    case kTv_1PowerButton:
    case kTv_1Remote_1PowerButton:
      return toggle(state, sym_fact(Relation::kState, kTv_1, kIsOn));
    case kTv_1ChannelUpButton:
    case kTv_1Remote_1ChannelUpButton:
      return set_channel(state, 1);
    case kTv_1ChannelDownButton:
    case kTv_1Remote_1ChannelDownButton:
      return set_channel(state, -1);
    case kTv_1VolumeUpButton:
    case kTv_1Remote_1VolumeUpButton:
      if (state.is(kTv_1, kIsOn)) state.add(volume);
      return;
    case kTv_1VolumeDownButton:
    case kTv_1Remote_1VolumeDownButton:
    case kTv_1Remote_1MuteButton:
      if (state.is(kTv_1, kIsOn)) state.remove(volume);
      return;
    default:
      return;
  }
}

void turn(Symbol knob, SymState& state) {
  if (knob == kSinkKnob) {
    toggle(state, sym_fact(Relation::kState, kSinkKnob, kTapIsOn));
    if (state.is(kSinkKnob, kTapIsOn))
      for_each(state, Relation::kOn, [&](Symbol x, Symbol where) {
        if (where == kSink) state.add(sym_fact(Relation::kState, x, kWater));
      });
  } else if (knob >= kStoveKnob_1 && knob <= kStoveKnob_4) {
    const Symbol fire = static_cast<Symbol>(kStoveFire1 + (knob - kStoveKnob_1));
    toggle(state, sym_fact(Relation::kState, kStove, fire));
    if (state.is(kStove, fire))
      for_each(state, Relation::kOn, [&](Symbol x, Symbol where) {
        if (where == fire) state.add(sym_fact(Relation::kState, x, ktemperatureHigh));
      });
  }
}

// The door state that opening `door` sets.
std::optional<SymFact> door_fact(Symbol door) {
  switch (door) {
    case kMicrowave:
      return sym_fact(Relation::kState, kMicrowave, kDoorIsOpen);
    case kFridgeLeftDoor:
      return sym_fact(Relation::kState, kFridge, kLeftDoorIsOpen);
    case kFridgeRightDoor:
      return sym_fact(Relation::kState, kFridge, kRightDoorIsOpen);
    case kBagOfChips_1:
      return sym_fact(Relation::kState, kBagOfChips_1, kIsOpen);
    default:
      return std::nullopt;
  }
}

// What must hold before an action: at most two objects held, one to be near, one door open, one fact true.
struct Needs {
  bool possible = true;
  std::array<Symbol, 2> held = {kNone, kNone};
  Symbol near = kNone;
  Symbol open = kNone;  // a door, as open() names it
  std::optional<SymFact> true_fact, false_fact;
};

Needs needs_of_press(Symbol button) {
  Needs needs;
  switch (button) {
    case kMicrowaveButton:
      needs.near = kMicrowave;
      break;
    case kFridgeButton:
      needs.near = kFridge;
      break;
    case kTv_1PowerButton:
    case kTv_1ChannelUpButton:
    case kTv_1ChannelDownButton:
    case kTv_1VolumeUpButton:
    case kTv_1VolumeDownButton:
    case kTv_1Remote_1MuteButton:
      needs.near = kTv_1;
      break;
    case kTv_1Remote_1PowerButton:
    case kTv_1Remote_1ChannelUpButton:
    case kTv_1Remote_1ChannelDownButton:
    case kTv_1Remote_1VolumeUpButton:
    case kTv_1Remote_1VolumeDownButton:
      needs.held[0] = kTv_1Remote_1;
      break;
    default:
      needs.possible = false;
  }
  return needs;
}

Needs needs_of_keep(const SymAction& action) {
  Needs needs;
  needs.held[0] = action.x;
  needs.near = action.y;
  if (action.verb == Verb::kKeepOn && action.y >= kStoveFire1 && action.y <= kStoveFire4) needs.near = kStove;
  if (action.verb == Verb::kKeepIn) {
    if (action.y == kMicrowave) needs.open = kMicrowave;
    if (action.y == kFridgeLeft) needs.near = kFridge, needs.open = kFridgeLeftDoor;
    if (action.y == kFridgeRight) needs.near = kFridge, needs.open = kFridgeRightDoor;
    if (action.y == kGarbageBag_1) needs.near = kNone, needs.held[1] = kGarbageBag_1;
  }
  return needs;
}

Needs needs_of(const SymAction& action) {
  Needs needs;
  switch (action.verb) {
    case Verb::kMoveTo:
      break;
    case Verb::kGrasp:
      needs.near = action.x;
      needs.true_fact = sym_fact(Relation::kIsGraspable, action.x);
      needs.false_fact = sym_fact(Relation::kGrasping, kRobot, action.x);
      break;
    case Verb::kRelease:
      needs.true_fact = sym_fact(Relation::kGrasping, kRobot, action.x);
      break;
    case Verb::kPress:
      return needs_of_press(action.x);
    case Verb::kTurn:
      needs.possible = action.x >= kSinkKnob && action.x <= kStoveKnob_4 && action.x != kStove;
      needs.near = action.x == kSinkKnob ? kSink : kStove;
      break;
    case Verb::kOpen:
    case Verb::kClose: {
      const auto door = door_fact(action.x);
      needs.possible = door && !(action.verb == Verb::kClose && action.x == kBagOfChips_1);
      if (!door) break;
      (action.verb == Verb::kOpen ? needs.false_fact : needs.true_fact) = door;
      if (action.x == kBagOfChips_1) {
        needs.held[0] = kBagOfChips_1;
        needs.false_fact.reset();  // opening an open bag changes nothing, but is allowed
      } else {
        needs.near = action.x == kMicrowave ? kMicrowave : kFridge;
      }
      break;
    }
    case Verb::kKeepOn:
    case Verb::kKeepIn:
    case Verb::kKeepNear:
      return needs_of_keep(action);
    case Verb::kPour:
      needs.held[0] = action.x;
      break;
    case Verb::kSqueeze:
      needs.true_fact = sym_fact(Relation::kIsSqueezeable, action.x);
      needs.held = {action.x, action.y};
      break;
    case Verb::kScoop:
      needs.true_fact = sym_fact(Relation::kState, action.y, kScoopsLeft);
      needs.held = {action.x, action.y};
      break;
    case Verb::kPourInto:
      needs.held = {action.x, action.y};
      break;
    case Verb::kAdd:
      if (action.x == kIceCreamScoop) {
        needs.held[0] = kSpoon_1;
        needs.true_fact = sym_fact(Relation::kState, kSpoon_1, kScoopsLeft);
      } else {
        needs.possible = action.x == kSalt_1 || action.x == kRamen_1 || action.x == kBoiledEgg_1;
        needs.held = {action.x, action.y};
      }
      break;
    case Verb::kPlace:
      needs.possible = action.x == kFork_1 || action.x == kSpoon_1;
      needs.held[0] = action.y;
      break;
    case Verb::kInsert:
      needs.true_fact = sym_fact(Relation::kState, action.x, kCD);
      needs.held = {action.x, action.y};
      break;
    case Verb::kStop:
      needs.possible = false;
  }
  return needs;
}

void apply_add(const SymAction& action, SymState& state) {
  const auto contains = [&](Symbol value) { state.add(sym_fact(Relation::kState, action.y, value)); };
  if (action.x == kIceCreamScoop) {
    contains(kIceCream);
    state.remove(sym_fact(Relation::kState, kSpoon_1, kScoopsLeft));
  } else if (action.x == kSalt_1) {
    contains(kSalt);
  } else {
    contains(action.x == kRamen_1 ? kRamen : kEgg);
    state.remove(sym_fact(Relation::kGrasping, kRobot, action.x));
    state.add(sym_fact(Relation::kIn, action.x, action.y));
  }
}

void apply_keep(const SymAction& action, SymState& state) {
  const Relation relation = action.verb == Verb::kKeepOn   ? Relation::kOn
                            : action.verb == Verb::kKeepIn ? Relation::kIn
                                                           : Relation::kNear;
  state.remove(sym_fact(Relation::kGrasping, kRobot, action.x));
  state.add(sym_fact(relation, action.x, action.y));
  if (relation != Relation::kOn) return;
  if (action.y == kSink && state.is(kSinkKnob, kTapIsOn)) {
    state.add(sym_fact(Relation::kState, action.x, kWater));
    state.remove(sym_fact(Relation::kState, action.x, ktemperatureHigh));
  }
  if (action.y >= kStoveFire1 && action.y <= kStoveFire4 && state.is(kStove, action.y))
    state.add(sym_fact(Relation::kState, action.x, ktemperatureHigh));
}

}  // namespace

bool applicable(const SymAction& action, const SymState& state) {
  const Needs needs = needs_of(action);
  if (!needs.possible) return false;
  for (const Symbol held : needs.held)
    if (held != kNone && !state.holds(held)) return false;
  if (needs.near != kNone && !state.near(needs.near)) return false;
  if (needs.open != kNone && !state.has(*door_fact(needs.open))) return false;
  if (needs.true_fact && !state.has(*needs.true_fact)) return false;
  return !needs.false_fact || !state.has(*needs.false_fact);
}

void apply(const SymAction& action, SymState& state) {
  const Symbol x = action.x, y = action.y;
  switch (action.verb) {
    case Verb::kStop:
      return;
    case Verb::kMoveTo: {
      std::vector<SymFact> over;  // mostly empty
      for (const SymFact fact : state.facts())
        if (relation_of(fact) == Relation::kNear && subject_of(fact) == x && object_of(fact) != x &&
            object_of(fact) != kRobot && !state.holds(object_of(fact)))
          over.push_back(fact);
      for (const SymFact fact : over) state.remove(fact);
      state.add(sym_fact(Relation::kNear, kRobot, x));
      return;
    }
    case Verb::kGrasp:
      state.remove_if([&](SymFact fact) {
        return relation_of(fact) <= Relation::kIn && (subject_of(fact) == x) != (object_of(fact) == x);
      });
      state.add(sym_fact(Relation::kGrasping, kRobot, x));
      return;
    case Verb::kRelease:
      state.remove(sym_fact(Relation::kGrasping, kRobot, x));
      return;
    case Verb::kPress:
      return press(x, state);
    case Verb::kTurn:
      return turn(x, state);
    case Verb::kOpen:
      if (const auto door = door_fact(x)) state.add(*door);
      if (x == kMicrowave) state.remove(sym_fact(Relation::kState, kMicrowave, kMicrowaveIsOn));
      if (x == kFridgeLeftDoor) state.remove(sym_fact(Relation::kState, kFridge, kWaterDispenserIsOpen));
      return;
    case Verb::kClose:
      if (const auto door = door_fact(x)) state.remove(*door);
      return;
    case Verb::kKeepOn:
    case Verb::kKeepIn:
    case Verb::kKeepNear:
      return apply_keep(action, state);
    case Verb::kPour:
      for (const Symbol content : kContents) state.remove(sym_fact(Relation::kState, x, content));
      return;
    case Verb::kPourInto:
      for (std::size_t i = 0; i < kPoured; ++i)
        if (state.is(x, kContents[i])) state.add(sym_fact(Relation::kState, y, kContents[i]));
      return;
    case Verb::kAdd:
      return apply_add(action, state);
    case Verb::kSqueeze:
      if (state.is(x, kChocolate)) state.add(sym_fact(Relation::kState, y, kChocolate));
      return;
    case Verb::kScoop:
      return state.add(sym_fact(Relation::kState, x, kScoopsLeft));
    case Verb::kPlace:
      state.remove(sym_fact(Relation::kGrasping, kRobot, y));
      state.add(sym_fact(Relation::kState, y, x == kFork_1 ? kFork : kSpoon));
      return state.add(sym_fact(Relation::kIn, x, y));
    case Verb::kInsert:
      state.add(sym_fact(Relation::kState, y, kCD));
      state.remove(sym_fact(Relation::kGrasping, kRobot, x));
      return state.add(sym_fact(Relation::kIn, x, y));
  }
}

std::vector<SymAction> with_means(const SymAction& action, const SymState& state) {
  std::vector<SymAction> run;
  const Needs needs = needs_of(action);
  if (!needs.possible) return run;
  SymState now = state;
  const auto act = [&](const SymAction& step) {
    if (!applicable(step, now)) return false;
    apply(step, now);
    run.push_back(step);
    return true;
  };
  const auto go = [&](Symbol place) {
    return place == kNone || now.near(place) || act({Verb::kMoveTo, place});
  };
  for (const Symbol held : needs.held)
    if (held != kNone && !now.holds(held) && !(go(held) && act({Verb::kGrasp, held}))) return {};
  if (!go(needs.near)) return {};
  if (needs.open != kNone && !now.has(*door_fact(needs.open)) && !act({Verb::kOpen, needs.open})) return {};
  if (!act(action)) return {};
  return run;
}

}  // namespace goalnet::inference
