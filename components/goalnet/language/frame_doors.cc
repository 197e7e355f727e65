// Opening and closing.
#include <algorithm>

#include "components/goalnet/language/frame_actions.h"

namespace goalnet::inference {

using namespace symbol;

bool FrameActions::is_switched(Symbol thing) {
  return thing == kTv_1 || thing == kStove || (thing >= kStoveFire_1 && thing <= kStoveFire_4);
}

std::string FrameActions::open_or_close(Symbol thing, bool open, bool left, bool right) {
  if (thing == kFridgeLeftDoor || thing == kFridgeLeft) return open_or_close(kFridge, open, true, false);
  if (thing == kFridgeRightDoor || thing == kFridgeRight) return open_or_close(kFridge, open, false, true);
  if (thing == kFridge) {
    if (open && !left && !right) left = !now_.is(kFridge, kRightDoorIsOpen);
    for (const bool is_left : {true, false}) {
      const bool wanted = is_left ? left || (!open && !right) : right || (!open && !left);
      const Symbol state = is_left ? Symbol{kLeftDoorIsOpen} : Symbol{kRightDoorIsOpen};
      if (!wanted || now_.is(kFridge, state) == open) continue;
      const Symbol door = is_left ? Symbol{kFridgeLeftDoor} : Symbol{kFridgeRightDoor};
      if (const Problem problem = act({open ? Verb::kOpen : Verb::kClose, door}); !problem.empty())
        return problem;
    }
    return {};
  }
  // It is opened for what is taken out or put in, though the benchmark's rules need no open door for that.
  const auto opened_for = [&](const SymAction& macro) {
    return macro.y == kMicrowave || start_.has(Relation::kIn, macro.x, kMicrowave);
  };
  if (at_home_ && thing == kMicrowave && !open && !now_.is(kMicrowave, kDoorIsOpen) &&
      std::any_of(macros_.begin(), macros_.end(), opened_for)) {
    macros_.push_back({Verb::kClose, kMicrowave});
    steps_.emplace_back();
    steps_.back().removed = {sym_fact(Relation::kState, kMicrowave, kDoorIsOpen)};
    return {};
  }
  if (thing == kMicrowave)
    return now_.is(kMicrowave, kDoorIsOpen) == open ? Problem{}
                                                    : act({open ? Verb::kOpen : Verb::kClose, kMicrowave});
  if (thing == kBagOfChips_1 && open)
    return now_.is(kBagOfChips_1, kIsOpen) ? Problem{} : act({Verb::kOpen, kBagOfChips_1});
  if (thing == kSinkKnob) return turn_on(kSinkKnob, open, 0);
  // "close the tv", "open the gas": as people say who translate from their own language
  if (at_home_ && is_switched(thing)) return turn_on(thing, open, 0);
  return resolver_.name(thing) + " cannot be " + (open ? "opened" : "closed");
}

std::string FrameActions::door(const Clause& clause, bool open) {
  const auto openable = [](Symbol thing) {
    return thing == kFridge || thing == kMicrowave || thing == kBagOfChips_1 || thing == kSinkKnob ||
           thing == kFridgeLeftDoor || thing == kFridgeRightDoor || thing == kFridgeLeft ||
           thing == kFridgeRight;
  };
  const auto is_open = [&](Symbol thing) {
    return thing == kFridge ? now_.is(kFridge, kLeftDoorIsOpen) || now_.is(kFridge, kRightDoorIsOpen)
                            : thing == kMicrowave && now_.is(kMicrowave, kDoorIsOpen);
  };
  if (at_home_ && clause.phrases.empty() && clause.particles.empty() && !clause.weak && !history_.empty()) {
    Clause that = clause;  // "go to the fridge and open"
    that.phrases = {it()};
    return door(that, open);
  }
  if (clause.phrases.empty()) return "it is not clear what to " + clause.verb;
  if (!open && (clause.has_particle("off") || clause.has_particle("down")))
    return turn(clause, 0);  // "shut the tv off"
  bool any = false;
  for (const NounPhrase& phrase : clause.phrases) {
    if (phrase.role != Role::kDirect && any) continue;
    if (phrase.role == Role::kWith) continue;
    const bool both = phrase.all || phrase.count == 2 || phrase.plural;
    const bool left = phrase.has("left") || clause.has("left") || (both && open);
    const bool right = phrase.has("right") || clause.has("right") || (both && open);
    Objects things;
    if (phrase.pronoun) {
      things = pronoun(phrase, Sort::kAny, {});
      std::erase_if(things, [&](Symbol thing) { return !openable(thing); });
      for (auto it = history_.rbegin(); it != history_.rend() && things.empty(); ++it)
        for (const Symbol thing : *it)
          if ((openable(thing) || (at_home_ && is_switched(thing))) && things.empty()) things = {thing};
      // "take the bowl out of the microwave, then close it"
      for (const Symbol place : last_destination_)
        if (at_home_ && things.empty() && openable(place)) things = {place};
    } else if (!open && (phrase.everything || (phrase.phrase == "door" && both))) {  // "close all the doors"
      any = true;
      for (const Symbol thing : {kFridge, kMicrowave})
        if (resolver_.exists(thing) && is_open(thing))
          if (const Problem problem = open_or_close(thing, false, false, false); !problem.empty())
            return problem;
      continue;
    } else if (!phrase.bare() && !phrase.everything) {
      const bool only_door =
          phrase.phrase == "door" ||
          ((phrase.phrase == "left door" || phrase.phrase == "right door") && resolver_.exists(kFridge));
      things = only_door && phrase.phrase != "door" ? Objects{Symbol{kFridge}}
                                                    : resolver_.options(phrase, Sort::kAny, now_);
      if (only_door && phrase.phrase == "left door") return open_or_close(kFridge, open, true, false);
      if (only_door && phrase.phrase == "right door") return open_or_close(kFridge, open, false, true);
      if (phrase.phrase == "door" &&
          things.size() > 1) {  // which? the one that is open, the one just spoken of
        if (left || right) things = {Symbol{kFridge}};
        for (auto it = history_.rbegin(); it != history_.rend() && things.size() > 1; ++it)
          for (const Symbol thing : *it)
            if (openable(thing) && (open || is_open(thing))) things = {thing};
        if (!open && things.size() > 1) std::erase_if(things, [&](Symbol thing) { return !is_open(thing); });
        if (open && things.size() > 1)
          return "it is not clear which door to open; say \"the microwave\" or \"the fridge\"";
        if (things.empty()) return {};  // nothing is open
      }
    }
    if (things.empty() && phrase.word == "one" && (left || right) && resolver_.exists(kFridge))
      things = {Symbol{kFridge}};  // "close the left one"
    if (things.empty()) return unknown_thing(phrase, Sort::kAny);
    Symbol thing = things.front();
    for (const Symbol other : things)
      if (!openable(thing) && openable(other)) thing = other;
    // "close the freezer" is the fridge, and names with a side say which door
    if (const Problem problem = open_or_close(thing, open, left, right); !problem.empty()) return problem;
    remember({thing});
    any = true;
  }
  return any ? Problem{} : "it is not clear what to " + clause.verb;
}

}  // namespace goalnet::inference
