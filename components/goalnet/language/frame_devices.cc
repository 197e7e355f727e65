// What the frames of doors, knobs and the television ask for.
#include <algorithm>

#include "components/goalnet/language/frame_actions.h"

namespace goalnet::inference {
namespace {

using namespace symbol;

constexpr int kChannels = 6;

}  // namespace

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

std::string FrameActions::turn(const Clause& clause, int on) {
  const bool up = clause.has_particle("up"), down = clause.has_particle("down");
  const NounPhrase* thing = clause.first(Role::kDirect);
  if (about_television(clause) && (up || (down && clause.verb != "power") || clause.has("channel") ||
                                   clause.has("volume") || clause.has("sound")))
    return television(clause);
  if (on != 0 && (clause.has_particle("off") || (clause.verb == "power" && down))) on = 0;
  if (on < 0 && clause.has_particle("on")) on = 1;
  const auto is_knob = [&] {  // those are turned as they are
    if (thing == nullptr || thing->pronoun || thing->bare()) return false;
    const auto knobs = resolver_.options(*thing, Sort::kDevice, now_);
    return thing->has("knob") ||
           (!knobs.empty() &&
            (knobs.front() == kSinkKnob || (knobs.front() >= kStoveKnob_1 && knobs.front() <= kStoveKnob_4)));
  };
  if (on < 0 && (clause.verb == "turn" || clause.verb == "switch" || clause.verb == "power") && !is_knob())
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
    } else if (phrase.everything && phrase.at.empty() && on == 0) {  // "turn everything off"
      for (const Symbol device : {kSinkKnob, kMicrowave, kTv_1, kFridgeButton})
        if ((device == kFridgeButton || resolver_.exists(device)) && is_on(device)) devices.push_back(device);
      if (resolver_.exists(kStove)) devices.push_back(kStove);
      if (devices.empty()) return {};
    } else if (!phrase.bare() && !phrase.everything) {
      devices = resolver_.options(phrase, Sort::kDevice, now_);
      const Objects burners = resolver_.options(phrase, Sort::kPlace, now_);
      const bool one_burner =
          !burners.empty() && resolver_.is_of_class(burners.front(), "burner") &&
          (phrase.ordinal > 0 || phrase.number > 0 || phrase.all || phrase.plural || phrase.count > 0 ||
           !phrase.at.empty() || phrase.has("other") || phrase.has("last"));
      if (one_burner) {
        Objects chosen_burners = burners;
        if (!phrase.at.empty() || phrase.number > 0)
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
    if (devices.empty()) {
      if (any) continue;
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
    any = true;
  }
  return any ? Problem{} : "it is not clear what to turn on or off";
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
  if (thing == kMicrowave)
    return now_.is(kMicrowave, kDoorIsOpen) == open ? Problem{}
                                                    : act({open ? Verb::kOpen : Verb::kClose, kMicrowave});
  if (thing == kBagOfChips_1 && open)
    return now_.is(kBagOfChips_1, kIsOpen) ? Problem{} : act({Verb::kOpen, kBagOfChips_1});
  if (thing == kSinkKnob) return turn_on(kSinkKnob, open, 0);
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
          if (openable(thing) && things.empty()) things = {thing};
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

bool FrameActions::about_television(const Clause& clause) const {
  for (const NounPhrase& phrase : clause.phrases) {
    if (language_.tv_word(phrase.phrase)) return true;
    for (const Symbol named : phrase.phrase.empty() ? Objects{} : resolver_.named(phrase))
      if (named == kTv_1) return true;
    if (phrase.pronoun) {
      const auto it = pronoun(phrase, Sort::kDevice, {});
      if (!it.empty() && it.front() == kTv_1) return true;
      const bool sound =
          clause.frame == Frame::kRaise || clause.frame == Frame::kLower || clause.frame == Frame::kMute;
      if (it.empty() && sound && history_.empty()) return true;  // "make it quiet"
    }
  }
  return clause.has("channel") || clause.has("volume") || clause.has("sound");
}

std::string FrameActions::television(const Clause& clause) {
  if (!resolver_.exists(kTv_1)) return not_here("there is no television here");
  if (!about_television(clause)) return "it is not clear what to " + clause.verb;
  const bool down = clause.has("down") || clause.has("previous") || clause.has("lower") ||
                    clause.has("back") || clause.has("last") || clause.has("before") ||
                    clause.frame == Frame::kLower;
  bool other_things = false;  // "mute the pillow"
  int channel = 0;
  for (const NounPhrase& phrase : clause.phrases) {
    channel = std::max({channel, phrase.number, phrase.ordinal, phrase.pronoun ? phrase.count : 0});
    if (phrase.phrase.empty() || language_.tv_word(phrase.phrase)) continue;
    const auto named = resolver_.named(phrase);
    other_things =
        other_things || (std::find(named.begin(), named.end(), Symbol{kTv_1}) == named.end() &&
                         std::find(named.begin(), named.end(), Symbol{kTv_1Remote_1}) == named.end());
  }
  if (other_things) return "it is not clear what to " + clause.verb;
  const bool channels = clause.has("channel") || clause.frame == Frame::kChange;
  const bool quiet = down || clause.frame == Frame::kMute || clause.has_particle("off");
  if (!channels && quiet && !is_on(kTv_1)) {  // it is silent already
    remember({Symbol{kTv_1}});
    return {};
  }
  if (const Problem problem = turn_on(kTv_1, true, 0); !problem.empty()) return problem;
  remember({Symbol{kTv_1}});
  if (channels) {
    int now = 0;
    for (int i = 1; i <= kChannels; ++i)
      if (now_.is(kTv_1, static_cast<Symbol>(kChannel1 + i - 1))) now = i;
    if (now == 0) return "it is not known which channel is on";
    if (channel > kChannels) return "there are only " + std::to_string(kChannels) + " channels";
    const int target = channel > 0 ? channel : (now - 1 + (down ? kChannels - 1 : 1)) % kChannels + 1;
    const bool up = (target - now + kChannels) % kChannels <= kChannels / 2;
    for (; now != target; now = (now - 1 + (up ? 1 : kChannels - 1)) % kChannels + 1)
      if (const Problem problem =
              act({Verb::kPress, up ? Symbol{kTv_1ChannelUpButton} : Symbol{kTv_1ChannelDownButton}});
          !problem.empty())
        return problem;
    return {};
  }
  if (now_.is(kTv_1, kVolume) != quiet) return {};
  return act({Verb::kPress, quiet ? Symbol{kTv_1VolumeDownButton} : Symbol{kTv_1VolumeUpButton}});
}

}  // namespace goalnet::inference
