// What turning, starting and stopping means, and which devices.
#include <algorithm>

#include "components/goalnet/language/frame_actions.h"
#include "components/goalnet/language/symbol_list.h"

namespace goalnet::inference {

using namespace symbol;

// `on`: 1 on, 0 off, -1 the clause's particles tell, else the other way round than it is.
std::string FrameActions::turn(const Clause& clause, int on) {
  const bool up = clause.has_particle("up"), down = clause.has_particle("down");
  if (about_television(clause) && (up || (down && clause.verb != "power") || clause.has("channel") ||
                                   clause.has("volume") || clause.has("sound")))
    return television(clause);
  on = on_or_off(clause, on);
  // "put the bowl in the microwave and start"
  if (clause.phrases.empty() && on >= 0 &&
      (clause.frame == Frame::kStart || clause.frame == Frame::kStop || at_home_)) {
    const Objects device = pronoun(it(), Sort::kDevice, {});
    if (!device.empty()) return turn_on(device.front(), on == 1, 0);
  }
  if (const auto moved = turn_what_moves(clause, on)) return *moved;
  bool any = false;
  for (const NounPhrase& phrase : clause.phrases)
    if (phrase.role == Role::kDirect)
      if (const auto ended = turn_named(clause, phrase, on, any)) return *ended;
  return any ? Problem{} : "it is not clear what to turn on or off";
}

int FrameActions::on_or_off(const Clause& clause, int on) {
  const bool up = clause.has_particle("up"), down = clause.has_particle("down");
  if (on != 0 && (clause.has_particle("off") || (clause.verb == "power" && down))) on = 0;
  if (on < 0 && clause.has_particle("on")) on = 1;
  const NounPhrase* thing = clause.first(Role::kDirect);
  if (on >= 0 || !up || thing == nullptr || thing->pronoun || thing->bare() || thing->everything) return on;
  const auto heated = resolver_.options(*thing, Sort::kDevice, now_);
  return !heated.empty() && heated.front() == kStove ? 1 : on;  // "crank the stove up"
}

// Those are turned as they are.
bool FrameActions::names_knob(const NounPhrase& phrase) {
  if (phrase.pronoun || phrase.bare()) return false;
  const auto knobs = resolver_.options(phrase, Sort::kDevice, now_);
  return phrase.has("knob") ||
         (!knobs.empty() &&
          (knobs.front() == kSinkKnob || (knobs.front() >= kStoveKnob_1 && knobs.front() <= kStoveKnob_4)));
}

// "Switch the pillows" and "run to the fridge" turn nothing on or off; "turn the book" says too little.
std::optional<std::string> FrameActions::turn_what_moves(const Clause& clause, int on) {
  const NounPhrase* thing = clause.first(Role::kDirect);
  const auto moves = [&] {
    return resolver_.options(*thing, Sort::kDevice, now_).empty() &&
           !resolver_.options(*thing, Sort::kMovable, now_).empty();
  };
  // "switch the pillows on armchair 1 and armchair 2"
  if (on < 0 && clause.verb == "switch" && thing != nullptr && !thing->pronoun && !thing->bare() && moves())
    return swap(clause);
  // "turn tv", "turn the burner": the other way round than it is; "turn" alone, or something with "around",
  // says nothing
  const bool toggles = at_home_ && thing != nullptr && clause.particles.empty() && only_devices(clause);
  if (on < 0 && (clause.verb == "turn" || clause.verb == "switch" || clause.verb == "power") &&
      !(thing != nullptr && names_knob(*thing)) && !toggles)
    return "it is not clear whether to turn that on or off";
  // "run to the fridge", "push the book onto the shelf"
  if (clause.frame != Frame::kStart || clause.first(Role::kDestination) == nullptr) return std::nullopt;
  if (thing == nullptr) return go(clause);
  if (!thing->pronoun && moves()) return put(clause);
  return std::nullopt;
}

// Turns what one phrase means; ends the whole clause where it says so or cannot be done. `any`: something was
// turned, or nothing else is on.
std::optional<std::string> FrameActions::turn_named(const Clause& clause, const NounPhrase& said, int on,
                                                    bool& any) {
  NounPhrase phrase = said;
  for (const NounPhrase& place : clause.phrases)  // "the burner under the kettle"
    if (place.role == Role::kDestination && (place.where == Where::kUnder || place.where == Where::kNear))
      phrase.at.push_back(place);
  Objects devices;
  const bool everything = phrase.everything && phrase.at.empty() && on == 0;
  if (phrase.pronoun) {
    devices = pronoun_device(phrase, on);
  } else if (at_home_ && everything && phrase.rest) {
    devices = other_devices_on();  // "leave burner two burning, turn the rest off"
    any = true;
  } else if (everything) {  // "turn everything off"
    devices = devices_to_turn_off();
    if (devices.empty()) return Problem{};
  } else if (!phrase.bare() && !phrase.everything) {
    devices = named_devices(phrase, on);
    if (devices.empty())
      if (const auto used = turn_what_is_used(clause, phrase, on, devices)) return *used;
  }
  // "the coke is on the stove, get it off": no device is meant
  if (devices.empty() && on == 0 && clause.state == "off" && phrase.pronoun &&
      !pronoun(phrase, Sort::kMovable, {}).empty()) {
    Clause away = clause;
    away.frame = Frame::kTake, away.verb = "take", away.state.clear();
    return take(away);
  }
  if (devices.empty() && phrase.pronoun && on >= 0) devices = only_device_left(on);
  leave_out_excepted(clause, devices);
  if (devices.empty() && phrase.rest && any) return std::nullopt;
  if (devices.empty()) {
    const bool no_device = at_home_ && !phrase.pronoun && !phrase.bare() && !resolver_.named(phrase).empty();
    if (any && !no_device) return std::nullopt;
    return unknown_thing(phrase, Sort::kDevice);
  }
  if (const Problem problem = turn_devices(clause, devices, on, phrase); !problem.empty()) return problem;
  any = true;
  return std::nullopt;
}

// Of all that was spoken of, what is not so already: "I spilled water on the stove, turn it off"
FrameActions::Objects FrameActions::pronoun_device(const NounPhrase& phrase, int on) const {
  Objects devices = pronoun(phrase, Sort::kDevice, {});
  const bool so = on >= 0 && !devices.empty() && is_on(devices.front()) == (on == 1);
  for (auto spoken = history_.rbegin(); so && spoken != history_.rend(); ++spoken)
    for (const Symbol other : *spoken)
      if (contains(resolver_.all(Sort::kDevice, now_), other) && is_on(other) != (on == 1) &&
          is_on(devices.front()) == (on == 1))
        devices = {other};
  return devices;
}

// What is no device, but needs or is needed by one; fills in `devices` where that is to be turned.
std::optional<std::string> FrameActions::turn_what_is_used(const Clause& clause, const NounPhrase& phrase,
                                                           int on, Objects& devices) {
  const auto names = [&](std::string_view kind) {
    return !resolver_.named(phrase).empty() && resolver_.is_of_class(resolver_.named(phrase).front(), kind);
  };
  // "start a game on the xbox"
  if (on == 1 && clause.frame == Frame::kStart && names("cd")) return play(clause);
  if (on == 1 && names("kettle")) return heat(clause, true);  // "turn on the kettle" heats it
  // "stop the kettle": what heats it is turned off
  if (on == 0)
    for (const Symbol heated : resolver_.options(phrase, Sort::kMovable, now_)) {
      const Symbol place = resolver_.place_of(heated, now_);
      if (place == kMicrowave || (place >= kStoveFire_1 && place <= kStoveFire_4)) devices = {place};
    }
  return std::nullopt;
}

// "all burners except the first"
void FrameActions::leave_out_excepted(const Clause& clause, Objects& devices) {
  for (const NounPhrase& left_out : clause.phrases)
    if (left_out.role == Role::kExcept && !left_out.bare() && !left_out.pronoun)
      for (const Sort sort : {Sort::kPlace, Sort::kDevice})
        for (const Symbol device : resolver_.chosen(left_out, resolver_.options(left_out, sort, now_)))
          std::erase(devices, device);
}

std::string FrameActions::turn_devices(const Clause& clause, const Objects& devices, int on,
                                       const NounPhrase& phrase) {
  for (const Symbol device : devices) {
    if (device == kFridge && clause.frame != Frame::kNone) return "the fridge cannot be turned on or off";
    const bool want = on < 0 ? !is_on(device) : on == 1;
    if (const Problem problem = turn_on(device, want, phrase.ordinal > 0 ? phrase.ordinal : phrase.number);
        !problem.empty())
      return problem;
  }
  remember(devices);
  if (contains(devices, kStove) && on == 1)  // "switch on a burner and put the kettle on it"
    for (Symbol i = 0; i < 4; ++i)
      if (now_.is(kStove, static_cast<Symbol>(kStoveFire1 + i)) &&
          !start_.is(kStove, static_cast<Symbol>(kStoveFire1 + i)))
        remember({static_cast<Symbol>(kStoveFire_1 + i)});
  return {};
}

}  // namespace goalnet::inference
