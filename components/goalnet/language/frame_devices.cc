// What can be switched, and switching it.
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

std::string FrameActions::toggle_to(bool on, Symbol object, Symbol value, const SymAction& toggle) {
  return now_.is(object, value) == on ? Problem{} : act(toggle);
}

std::string FrameActions::turn_knob(int number, bool on) {
  return toggle_to(on, kStove, static_cast<Symbol>(kStoveFire1 + number),
                   {Verb::kTurn, static_cast<Symbol>(kStoveKnob_1 + number)});
}

// Of the burner under what was just put there, else under a pot, else the first.
int FrameActions::knob_that_is_meant() const {
  for (auto it = history_.rbegin(); it != history_.rend(); ++it)
    for (int i = 0; i < 4; ++i)
      for (const Symbol object : *it)
        if (now_.has(Relation::kOn, object, static_cast<Symbol>(kStoveFire_1 + i))) return i;
  for (int i = 0; i < 4; ++i)
    for (const Symbol object : resolver_.things_at(static_cast<Symbol>(kStoveFire_1 + i), now_))
      if (resolver_.is_of_class(object, "kettle")) return i;
  return 0;
}

std::string FrameActions::turn_on(Symbol device, bool on, int number) {
  if (device == kSinkKnob) tap_asked_ = on, tap_fills_ = false;
  if (device == kSinkKnob) return toggle_to(on, kSinkKnob, kTapIsOn, {Verb::kTurn, kSinkKnob});
  if (device == kTv_1 || device == kTv_1Remote_1)
    return toggle_to(on, kTv_1, kIsOn, {Verb::kPress, kTv_1PowerButton});
  if (device == kFridgeButton)
    return toggle_to(on, kFridge, kWaterDispenserIsOpen, {Verb::kPress, kFridgeButton});
  if (device == kMicrowave || device == kMicrowaveButton) {
    if (on && now_.is(kMicrowave, kDoorIsOpen))
      if (const Problem problem = act({Verb::kClose, kMicrowave}); !problem.empty()) return problem;
    return toggle_to(on, kMicrowave, kMicrowaveIsOn, {Verb::kPress, kMicrowaveButton});
  }
  if (device >= kStoveFire_1 && device <= kStoveFire_4) return turn_knob(device - kStoveFire_1, on);
  if (device >= kStoveKnob_1 && device <= kStoveKnob_4) return turn_knob(device - kStoveKnob_1, on);
  if (device == kStove) {
    if (number >= 1 && number <= 4) return turn_knob(number - 1, on);
    if (on) return turn_knob(knob_that_is_meant(), on);
    for (int i = 0; i < 4; ++i)  // everything that burns
      if (const Problem problem = turn_knob(i, on); !problem.empty()) return problem;
    return {};
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

// All that runs, and the stove whether it burns or not.
FrameActions::Objects FrameActions::devices_to_turn_off() const {
  Objects devices;
  for (const Symbol device : {kSinkKnob, kMicrowave, kTv_1, kFridgeButton})
    if ((device == kFridgeButton || resolver_.exists(device)) && is_on(device)) devices.push_back(device);
  if (resolver_.exists(kStove)) devices.push_back(kStove);
  return devices;
}

// "switch it off" where one thing only is on
FrameActions::Objects FrameActions::only_device_left(int on) const {
  Objects devices;
  for (const Symbol device : {kSinkKnob, kMicrowave, kTv_1, kStove})
    if (resolver_.exists(device) && (on == 1 || is_on(device))) devices.push_back(device);
  if (devices.size() > 1) devices.clear();
  return devices;
}

FrameActions::Objects FrameActions::named_devices(const NounPhrase& phrase, int on) {
  const Objects devices = resolver_.options(phrase, Sort::kDevice, now_);
  const Objects burners = resolver_.options(phrase, Sort::kPlace, now_);
  if (!burners.empty() && resolver_.is_of_class(burners.front(), "burner")) {
    const bool which = phrase.ordinal > 0 || phrase.number > 0 || phrase.all || phrase.plural ||
                       phrase.count > 0 || !phrase.at.empty() || phrase.has("other") || phrase.has("last") ||
                       (at_home_ && phrase.has("free"));
    if (which) return burners_that_are_meant(phrase, burners, on);
    if (resolver_.exists(kStove)) return {Symbol{kStove}};
  }
  return devices.size() > 1 ? resolver_.chosen(phrase, devices) : devices;
}

FrameActions::Objects FrameActions::burners_that_are_meant(const NounPhrase& phrase, const Objects& burners,
                                                           int on) {
  Objects meant = burners;
  const auto first_only = [&] {
    if (meant.size() > 1) meant.erase(meant.begin() + 1, meant.end());
  };
  const auto is_so = [&](Symbol burner) { return is_on(burner) == (on == 1); };
  if (at_home_ && phrase.has("free")) {  // "any burner with nothing on it": those that it changes
    std::erase_if(meant, is_so);
  } else if (!phrase.at.empty() || phrase.number > 0) {
    first_only();
  } else if (phrase.has("other")) {
    std::erase_if(meant, is_so);
    first_only();
  } else {
    meant = resolver_.chosen(phrase, burners);
  }
  return on == 0 && phrase.plural && phrase.count == 0 ? burners : meant;
}

}  // namespace goalnet::inference
