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
    if ((phrase.role != Role::kDirect && any) || phrase.role == Role::kWith) continue;
    const bool both = phrase.all || phrase.count == 2 || phrase.plural;
    if (!phrase.pronoun && !open && (phrase.everything || (phrase.phrase == "door" && both))) {
      if (const Problem problem = close_all(); !problem.empty()) return problem;
      any = true;
      continue;
    }
    const bool left = phrase.has("left") || clause.has("left") || (both && open);
    const bool right = phrase.has("right") || clause.has("right") || (both && open);
    if (const auto ended = open_or_close_named(phrase, open, left, right)) return *ended;
    any = true;
  }
  return any ? Problem{} : "it is not clear what to " + clause.verb;
}

bool FrameActions::is_openable(Symbol thing) {
  return thing == kFridge || thing == kMicrowave || thing == kBagOfChips_1 || thing == kSinkKnob ||
         thing == kFridgeLeftDoor || thing == kFridgeRightDoor || thing == kFridgeLeft ||
         thing == kFridgeRight;
}

bool FrameActions::is_open(Symbol thing) const {
  return thing == kFridge ? now_.is(kFridge, kLeftDoorIsOpen) || now_.is(kFridge, kRightDoorIsOpen)
                          : thing == kMicrowave && now_.is(kMicrowave, kDoorIsOpen);
}

// "close all the doors"
std::string FrameActions::close_all() {
  for (const Symbol thing : {kFridge, kMicrowave})
    if (resolver_.exists(thing) && is_open(thing))
      if (const Problem problem = open_or_close(thing, false, false, false); !problem.empty()) return problem;
  return {};
}

// Ends the whole clause where it says so or cannot be done.
std::optional<std::string> FrameActions::open_or_close_named(const NounPhrase& phrase, bool open, bool left,
                                                             bool right) {
  Objects things;
  if (phrase.pronoun) {
    things = pronoun_door(phrase);
  } else if (!phrase.bare() && !phrase.everything) {
    if (phrase.phrase == "left door" && resolver_.exists(kFridge))
      return open_or_close(kFridge, open, true, false);
    if (phrase.phrase == "right door" && resolver_.exists(kFridge))
      return open_or_close(kFridge, open, false, true);
    things = resolver_.options(phrase, Sort::kAny, now_);
    if (phrase.phrase == "door" && things.size() > 1) {
      things = door_that_is_meant(things, open, left || right);
      if (open && things.size() > 1)
        return "it is not clear which door to open; say \"the microwave\" or \"the fridge\"";
      if (things.empty()) return Problem{};  // nothing is open
    }
  }
  if (things.empty() && phrase.word == "one" && (left || right) && resolver_.exists(kFridge))
    things = {Symbol{kFridge}};  // "close the left one"
  if (things.empty()) return unknown_thing(phrase, Sort::kAny);
  Symbol thing = things.front();
  for (const Symbol other : things)
    if (!is_openable(thing) && is_openable(other)) thing = other;
  // "close the freezer" is the fridge, and names with a side say which door
  if (const Problem problem = open_or_close(thing, open, left, right); !problem.empty()) return problem;
  remember({thing});
  return std::nullopt;
}

// Of what was spoken of, what has a door or a switch.
FrameActions::Objects FrameActions::pronoun_door(const NounPhrase& phrase) const {
  Objects things = pronoun(phrase, Sort::kAny, {});
  std::erase_if(things, [&](Symbol thing) { return !is_openable(thing); });
  for (auto spoken = history_.rbegin(); spoken != history_.rend() && things.empty(); ++spoken)
    for (const Symbol thing : *spoken)
      if ((is_openable(thing) || (at_home_ && is_switched(thing))) && things.empty()) things = {thing};
  // "take the bowl out of the microwave, then close it"
  for (const Symbol place : last_destination_)
    if (at_home_ && things.empty() && is_openable(place)) things = {place};
  return things;
}

// Which door? The one with two sides where a side is said, the one just spoken of, the one that is open.
FrameActions::Objects FrameActions::door_that_is_meant(Objects things, bool open, bool one_side) const {
  if (one_side) return {Symbol{kFridge}};
  for (auto spoken = history_.rbegin(); spoken != history_.rend() && things.size() > 1; ++spoken)
    for (const Symbol thing : *spoken)
      if (is_openable(thing) && (open || is_open(thing))) things = {thing};
  if (!open && things.size() > 1) std::erase_if(things, [&](Symbol thing) { return !is_open(thing); });
  return things;
}

}  // namespace goalnet::inference
