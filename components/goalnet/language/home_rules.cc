#include "components/goalnet/language/home_rules.h"

#include <algorithm>

#include "components/goalnet/language/symbol_list.h"

namespace goalnet::inference {
namespace {

using namespace symbol;

void heat_things_at(Symbol place, SymState& state) {
  const std::vector<SymFact> facts = state.facts();  // a copy: the state changes
  for (const SymFact fact : facts)
    if ((relation_of(fact) == Relation::kOn || relation_of(fact) == Relation::kIn) &&
        object_of(fact) == place)
      state.add(sym_fact(Relation::kState, subject_of(fact), ktemperatureHigh));
}

}  // namespace

void apply_at_home(const SymAction& action, SymState& state) {
  const SymState before = state;
  apply(action, state);
  switch (action.verb) {
    case Verb::kMoveTo:  // a robot stands at one place; SymSim lets Near pile up
      state.remove_if([&](SymFact fact) {
        return relation_of(fact) == Relation::kNear && subject_of(fact) == kRobot &&
               object_of(fact) != action.x;
      });
      return;
    case Verb::kPourInto:
      for (Symbol content = kWater; content <= kSalt; ++content)
        if (before.is(action.x, content)) state.remove(sym_fact(Relation::kState, action.x, content));
      return;
    case Verb::kPlace:  // the hand lets go of the utensil, not of what it is put into
      state.remove(sym_fact(Relation::kGrasping, kRobot, action.x));
      if (before.holds(action.y)) state.add(sym_fact(Relation::kGrasping, kRobot, action.y));
      return;
    case Verb::kSqueeze:
      for (Symbol content = kWater; content <= kSalt; ++content)
        if (before.is(action.x, content)) state.add(sym_fact(Relation::kState, action.y, content));
      return;
    case Verb::kPress:
      if (action.x == kMicrowaveButton && state.is(kMicrowave, kMicrowaveIsOn))
        heat_things_at(kMicrowave, state);
      return;
    case Verb::kTurn:
      for (int i = 0; i < 4; ++i)
        if (action.x == kStoveKnob_1 + i && state.is(kStove, static_cast<Symbol>(kStoveFire1 + i)))
          heat_things_at(static_cast<Symbol>(kStoveFire_1 + i), state);
      return;
    case Verb::kGrasp:
    case Verb::kKeepIn: {  // nobody knows which door it was
      const Symbol x = action.x, y = action.y;
      const bool fridge = y == kFridge || y == kFridgeLeft || y == kFridgeRight ||
                          (action.verb == Verb::kGrasp && (before.has(Relation::kIn, x, kFridge) ||
                                                           before.has(Relation::kIn, x, kFridgeLeft) ||
                                                           before.has(Relation::kIn, x, kFridgeRight)));
      if (fridge)
        for (const Symbol side : {kLeftDoorIsOpen, kRightDoorIsOpen})
          state.add(sym_fact(Relation::kState, kFridge, side));
      return;
    }
    case Verb::kKeepOn:
      for (int i = 0; i < 4; ++i)
        if (action.y == kStoveFire_1 + i && state.is(kStove, static_cast<Symbol>(kStoveFire1 + i)))
          state.add(sym_fact(Relation::kState, action.x, ktemperatureHigh));
      return;
    default:
      return;
  }
}

SymDelta purpose(const SymAction& action, const SymState& before, const std::vector<Symbol>& handled) {
  SymState after = before;
  apply_at_home(action, after);
  SymDelta change = delta(before, after);
  if (action.verb == Verb::kMoveTo || action.verb == Verb::kGrasp || action.verb == Verb::kPourInto ||
      action.verb == Verb::kKeepOn)
    // Of what is poured only water could come from elsewhere: then the source must be empty in the end.
    std::erase_if(change.removed, [&](SymFact fact) {
      return action.verb != Verb::kPourInto || relation_of(fact) != Relation::kState ||
             object_of(fact) != kWater;
    });
  const auto means = [&](SymFact fact) {
    const Relation relation = relation_of(fact);
    return (relation == Relation::kNear && action.verb != Verb::kMoveTo) ||
           (relation == Relation::kGrasping && action.verb != Verb::kGrasp &&
            action.verb != Verb::kRelease) ||
           (relation == Relation::kState && object_of(fact) == ktemperatureHigh) ||
           (relation == Relation::kState && subject_of(fact) == kFridge &&
            (action.verb == Verb::kGrasp || action.verb == Verb::kKeepIn));
  };
  std::erase_if(change.added, means);
  std::erase_if(change.removed, means);
  std::erase_if(change.added, [&](SymFact fact) {
    if (relation_of(fact) != Relation::kState || object_of(fact) != kWater) return false;
    const Symbol wet = subject_of(fact);
    const bool by_tap = action.verb == Verb::kTurn || action.verb == Verb::kKeepOn;
    return by_tap && !contains(handled, wet);
  });
  return change;
}

}  // namespace goalnet::inference
