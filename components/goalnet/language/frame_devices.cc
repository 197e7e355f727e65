// Turning things on and off.
#include <algorithm>

#include "components/goalnet/language/frame_actions.h"
#include "components/goalnet/language/symbol_list.h"

namespace goalnet::inference {

using namespace symbol;

bool FrameActions::is_on(Symbol device) const {
  if (device == kSinkKnob) return now_.is(kSinkKnob, kTapIsOn);
  if (device == kTv_1 || device == kTv_1Remote_1) return now_.is(kTv_1, kIsOn);
  if (device == kMicrowave || device == kMicrowaveButton) return now_.is(kMicrowave, kMicrowaveIsOn);
  if (device == kFridgeButton) return now_.is(kFridge, kWaterDispenserIsOpen);
  for (int i = 0; i < 4; ++i)
    if (device == kStoveFire_1 + i || device == kStoveKnob_1 + i || device == kStove)
      if (now_.is(kStove, static_cast<Symbol>(kStoveFire1 + i))) return true;
  return false;
}

std::string FrameActions::turn_on(Symbol device, bool on, int number) {
  const auto set = [&](Symbol object, Symbol value, const SymAction& toggle) -> Problem {
    return now_.is(object, value) == on ? Problem{} : act(toggle);
  };
  if (device == kSinkKnob) tap_asked_ = on, tap_fills_ = false;
  if (device == kSinkKnob) return set(kSinkKnob, kTapIsOn, {Verb::kTurn, kSinkKnob});
  if (device == kTv_1 || device == kTv_1Remote_1) return set(kTv_1, kIsOn, {Verb::kPress, kTv_1PowerButton});
  if (device == kFridgeButton) return set(kFridge, kWaterDispenserIsOpen, {Verb::kPress, kFridgeButton});
  if (device == kMicrowave || device == kMicrowaveButton) {
    if (on && now_.is(kMicrowave, kDoorIsOpen))
      if (const Problem problem = act({Verb::kClose, kMicrowave}); !problem.empty()) return problem;
    return set(kMicrowave, kMicrowaveIsOn, {Verb::kPress, kMicrowaveButton});
  }
  const auto knob = [&](int i) {
    return set(kStove, static_cast<Symbol>(kStoveFire1 + i),
               {Verb::kTurn, static_cast<Symbol>(kStoveKnob_1 + i)});
  };
  if (device >= kStoveFire_1 && device <= kStoveFire_4) return knob(device - kStoveFire_1);
  if (device >= kStoveKnob_1 && device <= kStoveKnob_4) return knob(device - kStoveKnob_1);
  if (device == kStove) {
    if (number >= 1 && number <= 4) return knob(number - 1);
    if (!on) {  // everything that burns
      for (int i = 0; i < 4; ++i)
        if (const Problem problem = knob(i); !problem.empty()) return problem;
      return {};
    }
    // The burner under what was just put there, else under a pot, else the first.
    for (auto it = history_.rbegin(); it != history_.rend(); ++it)
      for (int i = 0; i < 4; ++i)
        for (const Symbol object : *it)
          if (now_.has(Relation::kOn, object, static_cast<Symbol>(kStoveFire_1 + i))) return knob(i);
    for (int i = 0; i < 4; ++i)
      for (const Symbol object : resolver_.things_at(static_cast<Symbol>(kStoveFire_1 + i), now_))
        if (resolver_.is_of_class(object, "kettle")) return knob(i);
    return knob(0);
  }
  return resolver_.name(device) + " has no switch";
}

// Whether all that the clause is about can be turned on and off.
bool FrameActions::only_devices(const Clause& clause) const {
  return std::all_of(clause.phrases.begin(), clause.phrases.end(), [&](const NounPhrase& phrase) {
    if (phrase.pronoun) return !pronoun(phrase, Sort::kDevice, {}).empty();
    const auto named = phrase.bare() || phrase.everything ? Objects{} : resolver_.named(phrase);
    const Objects devices = resolver_.all(Sort::kDevice, now_);
    return std::any_of(named.begin(), named.end(), [&](Symbol object) {
      return contains(devices, object) || resolver_.is_of_class(object, "burner");
    });
  });
}

// What runs and was not spoken of; of burners where burners were spoken of.
FrameActions::Objects FrameActions::other_devices_on() const {
  const auto spoken = [&](Symbol device) {
    return std::any_of(history_.begin(), history_.end(),
                       [&](const Objects& objects) { return contains(objects, device); });
  };
  Objects result;
  bool burners = false;
  for (Symbol burner = kStoveFire_1; burner <= kStoveFire_4; ++burner) {
    burners = burners || spoken(burner);
    if (resolver_.exists(burner) && is_on(burner) && !spoken(burner)) result.push_back(burner);
  }
  if (burners) return result;
  for (const Symbol device : {kSinkKnob, kMicrowave, kTv_1})
    if (resolver_.exists(device) && is_on(device) && !spoken(device)) result.push_back(device);
  return result;
}

std::string FrameActions::turn(const Clause& clause, int on) {
  const bool up = clause.has_particle("up"), down = clause.has_particle("down");
  const NounPhrase* thing = clause.first(Role::kDirect);
  if (about_television(clause) && (up || (down && clause.verb != "power") || clause.has("channel") ||
                                   clause.has("volume") || clause.has("sound")))
    return television(clause);
  if (on != 0 && (clause.has_particle("off") || (clause.verb == "power" && down))) on = 0;
  if (on < 0 && clause.has_particle("on")) on = 1;
  if (on < 0 && up && thing != nullptr && !thing->pronoun && !thing->bare() && !thing->everything) {
    const auto heated = resolver_.options(*thing, Sort::kDevice, now_);
    if (!heated.empty() && heated.front() == kStove) on = 1;  // "crank the stove up"
  }
  // "put the bowl in the microwave and start"
  if (clause.phrases.empty() && on >= 0 &&
      (clause.frame == Frame::kStart || clause.frame == Frame::kStop || at_home_)) {
    const Objects device = pronoun(it(), Sort::kDevice, {});
    if (!device.empty()) return turn_on(device.front(), on == 1, 0);
  }
  const auto is_knob = [&] {  // those are turned as they are
    if (thing == nullptr || thing->pronoun || thing->bare()) return false;
    const auto knobs = resolver_.options(*thing, Sort::kDevice, now_);
    return thing->has("knob") ||
           (!knobs.empty() &&
            (knobs.front() == kSinkKnob || (knobs.front() >= kStoveKnob_1 && knobs.front() <= kStoveKnob_4)));
  };
  // "switch the pillows on armchair 1 and armchair 2"
  if (on < 0 && clause.verb == "switch" && thing != nullptr && !thing->pronoun && !thing->bare() &&
      resolver_.options(*thing, Sort::kDevice, now_).empty() &&
      !resolver_.options(*thing, Sort::kMovable, now_).empty())
    return swap(clause);
  // "turn tv", "turn the burner": the other way round than it is; "turn" alone, or something with "around",
  // says nothing
  const bool toggles = at_home_ && thing != nullptr && clause.particles.empty() && only_devices(clause);
  if (on < 0 && (clause.verb == "turn" || clause.verb == "switch" || clause.verb == "power") && !is_knob() &&
      !toggles)
    return "it is not clear whether to turn that on or off";
  // "run to the fridge", "push the book onto the shelf"
  if (thing == nullptr && clause.frame == Frame::kStart && clause.first(Role::kDestination) != nullptr)
    return go(clause);
  if (clause.frame == Frame::kStart && clause.first(Role::kDestination) != nullptr && thing != nullptr &&
      !thing->pronoun && resolver_.options(*thing, Sort::kDevice, now_).empty() &&
      !resolver_.options(*thing, Sort::kMovable, now_).empty())
    return put(clause);
  bool any = false;
  for (const NounPhrase& said : clause.phrases) {
    if (said.role != Role::kDirect) continue;
    NounPhrase phrase = said;
    for (const NounPhrase& place : clause.phrases)  // "the burner under the kettle"
      if (place.role == Role::kDestination && (place.where == Where::kUnder || place.where == Where::kNear))
        phrase.at.push_back(place);
    Objects devices;
    if (phrase.pronoun) {
      devices = pronoun(phrase, Sort::kDevice, {});
      // of all that was spoken of, what is not so already: "I spilled water on the stove, turn it off"
      const bool so = on >= 0 && !devices.empty() && is_on(devices.front()) == (on == 1);
      for (auto spoken = history_.rbegin(); so && spoken != history_.rend(); ++spoken)
        for (const Symbol other : *spoken)
          if (contains(resolver_.all(Sort::kDevice, now_), other) && is_on(other) != (on == 1) &&
              is_on(devices.front()) == (on == 1))
            devices = {other};
    } else if (at_home_ && phrase.everything && phrase.rest && phrase.at.empty() && on == 0) {
      devices = other_devices_on();  // "leave burner two burning, turn the rest off"
      any = true;
    } else if (phrase.everything && phrase.at.empty() && on == 0) {  // "turn everything off"
      for (const Symbol device : {kSinkKnob, kMicrowave, kTv_1, kFridgeButton})
        if ((device == kFridgeButton || resolver_.exists(device)) && is_on(device)) devices.push_back(device);
      if (resolver_.exists(kStove)) devices.push_back(kStove);
      if (devices.empty()) return {};
    } else if (!phrase.bare() && !phrase.everything) {
      devices = resolver_.options(phrase, Sort::kDevice, now_);
      const Objects burners = resolver_.options(phrase, Sort::kPlace, now_);
      const bool one_burner = !burners.empty() && resolver_.is_of_class(burners.front(), "burner") &&
                              (phrase.ordinal > 0 || phrase.number > 0 || phrase.all || phrase.plural ||
                               phrase.count > 0 || !phrase.at.empty() || phrase.has("other") ||
                               phrase.has("last") || (at_home_ && phrase.has("free")));
      if (one_burner) {
        Objects chosen_burners = burners;
        if (at_home_ && phrase.has("free"))  // "any burner with nothing on it": those that it changes
          std::erase_if(chosen_burners, [&](Symbol b) { return is_on(b) == (on == 1); });
        else if (!phrase.at.empty() || phrase.number > 0)
          chosen_burners.erase(chosen_burners.begin() + 1, chosen_burners.end());
        else if (phrase.has("other"))
          std::erase_if(chosen_burners, [&](Symbol b) { return is_on(b) == (on == 1); }),
              chosen_burners.erase(chosen_burners.begin() + (chosen_burners.empty() ? 0 : 1),
                                   chosen_burners.end());
        else
          chosen_burners = resolver_.chosen(phrase, burners);
        if (on == 0 && phrase.plural && phrase.count == 0) chosen_burners = burners;
        devices = chosen_burners;
      } else if (!burners.empty() && resolver_.is_of_class(burners.front(), "burner") &&
                 resolver_.exists(kStove)) {
        devices = {Symbol{kStove}};
      } else if (devices.size() > 1) {
        devices = resolver_.chosen(phrase, devices);
      }
      // "start a game on the xbox"
      if (devices.empty() && on == 1 && clause.frame == Frame::kStart && !resolver_.named(phrase).empty() &&
          resolver_.is_of_class(resolver_.named(phrase).front(), "cd"))
        return play(clause);
      // "turn on the kettle" heats it
      if (devices.empty() && on == 1 && !resolver_.named(phrase).empty() &&
          resolver_.is_of_class(resolver_.named(phrase).front(), "kettle"))
        return heat(clause, true);
      // "stop the kettle": what heats it is turned off
      if (devices.empty() && on == 0)
        for (const Symbol heated : resolver_.options(phrase, Sort::kMovable, now_)) {
          const Symbol place = resolver_.place_of(heated, now_);
          if (place == kMicrowave || (place >= kStoveFire_1 && place <= kStoveFire_4)) devices = {place};
        }
    }
    // "the coke is on the stove, get it off": no device is meant
    if (devices.empty() && on == 0 && clause.state == "off" && phrase.pronoun &&
        !pronoun(phrase, Sort::kMovable, {}).empty()) {
      Clause away = clause;
      away.frame = Frame::kTake, away.verb = "take", away.state.clear();
      return take(away);
    }
    // "switch it off" where one thing only is on
    if (devices.empty() && phrase.pronoun && on >= 0) {
      for (const Symbol device : {kSinkKnob, kMicrowave, kTv_1, kStove})
        if (resolver_.exists(device) && (on == 1 || is_on(device))) devices.push_back(device);
      if (devices.size() > 1) devices.clear();
    }
    for (const NounPhrase& left_out : clause.phrases)  // "all burners except the first"
      if (left_out.role == Role::kExcept && !left_out.bare() && !left_out.pronoun)
        for (const Sort sort : {Sort::kPlace, Sort::kDevice})
          for (const Symbol device : resolver_.chosen(left_out, resolver_.options(left_out, sort, now_)))
            std::erase(devices, device);
    if (devices.empty() && phrase.rest && any) continue;
    if (devices.empty()) {
      const bool no_device =
          at_home_ && !phrase.pronoun && !phrase.bare() && !resolver_.named(phrase).empty();
      if (any && !no_device) continue;
      return unknown_thing(phrase, Sort::kDevice);
    }
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
    any = true;
  }
  return any ? Problem{} : "it is not clear what to turn on or off";
}

}  // namespace goalnet::inference
