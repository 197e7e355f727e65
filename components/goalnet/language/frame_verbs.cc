// What each frame asks for.
#include <algorithm>

#include "components/goalnet/language/frame_actions.h"

namespace goalnet::inference {
namespace {

using namespace symbol;

}  // namespace

std::string FrameActions::go(const Clause& clause) {
  const NounPhrase* phrase = first(clause, Role::kDestination);
  if (phrase == nullptr) phrase = first(clause, Role::kDirect);
  if (phrase == nullptr) return "it is not clear where to go";
  const auto options = resolver_.options(*phrase, Sort::kAny, now_);
  if (options.empty()) return unknown_thing(*phrase);
  last_ = {options.front()};
  return now_.near(options.front()) ? Problem{} : act({Verb::kMoveTo, options.front()});
}

std::string FrameActions::take(const Clause& clause) {
  Problem problem;
  if (clause.has("scoop")) return scoop(clause);
  // "take the mug to the sink" says where to put it; "take the mug on the shelf" where it is.
  const NounPhrase* destination = first(clause, Role::kDestination);
  if (destination != nullptr && (clause.has("to") || clause.has("into") || clause.has("onto")))
    return put(clause);
  NounPhrase where;
  Clause located = clause;
  if (destination != nullptr) {
    where = *destination;
    where.role = Role::kSource;
    located.phrases.push_back(where);
  }
  const auto objects = direct(located, Sort::kMovable, problem);
  if (!problem.empty()) return problem;
  for (const Symbol object : objects) {
    if (now_.holds(object)) continue;
    if (problem = act({Verb::kGrasp, object}); !problem.empty()) return problem;
  }
  return {};
}

std::string FrameActions::put(const Clause& clause) {
  Problem problem;
  const NounPhrase* destination = first(clause, Role::kDestination);
  if (destination == nullptr) {
    if (clause.has_particle("down")) return release(clause);
    if (clause.has_particle("away") && resolver_.instruction().find(kGarbageBin_1) >= 0 &&
        clause.frame == Frame::kPlace)
      return "it is not clear where to put it";
    // "drop the pillow", "move the mug": only the first has a meaning without a place
    return clause.frame == Frame::kBring ? take(clause)
           : clause.verb == "drop"       ? release(clause)
                                         : Problem("it is not clear where to put it");
  }
  if (clause.verb == "move" && first(clause, Role::kDirect) == nullptr) return go(clause);
  if (clause.has("scoop")) return scoop(clause);
  const Symbol content = mentioned_content(clause, Role::kDirect);
  if (destination->inside && (content == kWater || content == kCoffee)) return pour(clause);
  if (destination->inside && content == kIceCream && destination->phrase != "fridge" &&
      destination->phrase != "freezer" && destination->phrase != "refrigerator")
    return scoop(clause);
  if (destination->inside && content == kSalt) return add_to(clause);
  const auto objects = direct(clause, Sort::kMovable, problem);
  if (!problem.empty()) return problem;
  Symbol target = place(clause, problem);
  if (!problem.empty()) return problem;
  for (const Symbol object : objects) {
    if (target == object) return "a thing cannot be put on itself";
    if (target == kNone) return "it is not clear where to put it";
    if (problem = keep(object, target, destination->inside); !problem.empty()) return problem;
  }
  return {};
}

std::string FrameActions::discard(const Clause& clause) {
  Problem problem;
  const Symbol content = mentioned_content(clause, Role::kDirect);
  const NounPhrase* thing = first(clause, Role::kDirect);
  if (first(clause, Role::kDestination) != nullptr) return put(clause);
  const Symbol bin = resolver_.instruction().find(kGarbageBin_1) >= 0   ? Symbol{kGarbageBin_1}
                     : resolver_.instruction().find(kGarbageBag_1) >= 0 ? Symbol{kGarbageBag_1}
                                                                        : Symbol{kNone};
  if (bin == kNone && content != kNone && thing != nullptr) return pour(clause);
  if (bin == kNone) return "there is no bin here";
  const auto objects = direct(clause, Sort::kMovable, problem);
  if (!problem.empty()) return problem;
  for (const Symbol object : objects)
    if (problem = keep(object, bin, true); !problem.empty()) return problem;
  return {};
}

std::string FrameActions::fill(const Clause& clause) {
  Problem problem;
  const auto vessels = direct(clause, Sort::kVessel, problem);
  if (!problem.empty()) return problem;
  Symbol content = mentioned_content(clause, Role::kWith);
  const NounPhrase* with = first(clause, Role::kWith);
  if (with != nullptr && content == kNone)
    return "it is not known how to fill something with " + with->phrase;
  if (content == kNone) content = kWater;
  for (const Symbol vessel : vessels) {
    if (content == kWater) {
      problem = fill_with_water(vessel);
    } else if (!now_.is(vessel, content)) {
      const Symbol source = vessel_with(content);
      problem = source == kNone ? "nothing here holds that" : act({Verb::kPourInto, source, vessel});
    }
    if (!problem.empty()) return problem;
  }
  return {};
}

std::string FrameActions::pour(const Clause& clause) {
  Problem problem;
  const Symbol content = mentioned_content(clause, Role::kDirect);
  const NounPhrase* destination = first(clause, Role::kDestination);
  const NounPhrase* source_phrase = first(clause, Role::kSource);
  Symbol target = kNone;
  if (destination != nullptr) {
    const auto options = destination->pronoun ? last_ : resolver_.options(*destination, Sort::kVessel, now_);
    if (!options.empty())
      target = options.front();
    else if (resolver_.options(*destination, Sort::kPlace, now_).empty())
      return unknown_thing(*destination);
  }
  Symbol source = kNone;
  if (source_phrase != nullptr) {
    const auto options = resolver_.options(*source_phrase, Sort::kVessel, now_);
    if (options.empty()) return unknown_thing(*source_phrase);
    source = options.front();
  } else if (content != kNone) {
    source = vessel_with(content);
    if (source == kNone && content == kWater && target != kNone) {
      last_ = {target};
      return fill_with_water(target);
    }
    if (source == kNone) {  // "pour the coke": the can itself
      const auto objects = direct(clause, Sort::kVessel, problem);
      if (!problem.empty()) return "nothing here holds that";
      source = objects.front();
    }
  } else {
    const auto objects = direct(clause, Sort::kMovable, problem);
    if (!problem.empty()) return problem;
    source = objects.front();
  }
  if (target == source) return "a thing cannot be poured into itself";
  last_ = {target == kNone ? source : target};
  return act(target == kNone ? SymAction{Verb::kPour, source} : SymAction{Verb::kPourInto, source, target});
}

std::string FrameActions::empty(const Clause& clause) {
  if (mentioned_content(clause, Role::kDirect) != kNone) return pour(clause);
  const NounPhrase* destination = first(clause, Role::kDestination);
  if (destination != nullptr && !resolver_.options(*destination, Sort::kVessel, now_).empty())
    return pour(clause);
  Problem problem;
  const auto vessels = direct(clause, Sort::kVessel, problem);
  if (!problem.empty()) return problem;
  for (const Symbol vessel : vessels)
    if (problem = act({Verb::kPour, vessel}); !problem.empty()) return problem;
  return {};
}

std::string FrameActions::turn(const Clause& clause, int on) {
  if (clause.has("volume") || clause.has("channel")) return television(clause);
  if (on < 0)
    on = clause.has_particle("off") || clause.has("off") ? 0
         : clause.has_particle("on") || clause.has("on") ? 1
                                                         : -1;
  if (on < 0 && (clause.verb == "turn" || clause.verb == "switch" || clause.verb == "power"))
    return "it is not clear whether to turn that on or off";
  Problem problem;
  bool any = false;
  for (const NounPhrase& phrase : clause.phrases) {
    auto options = resolver_.options(phrase, Sort::kDevice, now_);
    if (phrase.phrase == "burner" || phrase.phrase == "stove fire" || phrase.phrase == "fire" ||
        phrase.phrase == "flame")
      options = phrase.ordinal > 0 || phrase.count > 0 ? resolver_.options(phrase, Sort::kPlace, now_)
                                                       : std::vector<Symbol>{kStove};
    if (phrase.pronoun) options = last_;
    if (options.empty()) {
      if (any) continue;  // "the burner under the kettle"
      return "there is nothing called " + phrase.phrase + " here that could be turned on or off";
    }
    const int number = phrase.ordinal > 0 ? phrase.ordinal : phrase.count;
    Symbol device = options.front();
    if (number > 0 && options.size() >= static_cast<std::size_t>(number) && device != kStove)
      device = options[static_cast<std::size_t>(number - 1)];
    if (device == kStove && resolver_.instruction().find(kStove) < 0) return "there is no stove here";
    bool want = on == 1;
    if (on < 0) {
      const bool is_on =
          (device == kSinkKnob && now_.is(kSinkKnob, kTapIsOn)) || (device == kTv_1 && now_.is(kTv_1, kIsOn));
      want = !is_on;
    }
    if (problem = turn_on(device, want, number); !problem.empty()) return problem;
    any = true;
    if (device == kStove) break;  // "the burner of the stove" is one thing
  }
  return any ? Problem{} : "it is not clear what to turn on or off";
}

std::string FrameActions::door(const Clause& clause, bool open) {
  const bool left = clause.has("left"), right = clause.has("right");
  const auto has = [&](Symbol object) { return resolver_.instruction().find(object) >= 0; };
  if (clause.phrases.empty()) return "it is not clear what to " + clause.verb;
  bool any = false;
  Problem problem;
  for (const NounPhrase& phrase : clause.phrases) {
    const auto options = resolver_.options(phrase, Sort::kAny, now_);
    const std::string& name = phrase.phrase;
    const bool fridge = name.find("fridge") != std::string::npos || name == "freezer" ||
                        name == "refrigerator" || name == "icebox";
    if (fridge && has(kFridge)) {
      const bool use_right = right || (!left && name.find("right") != std::string::npos);
      if (open) {
        const Symbol state = use_right ? kRightDoorIsOpen : kLeftDoorIsOpen;
        if (!now_.is(kFridge, state))
          problem = act({Verb::kOpen, use_right ? Symbol{kFridgeRightDoor} : Symbol{kFridgeLeftDoor}});
      } else {
        for (const Symbol side : {kFridgeLeftDoor, kFridgeRightDoor}) {
          const bool wanted =
              (!left && !right) || (left && side == kFridgeLeftDoor) || (right && side == kFridgeRightDoor);
          const Symbol state = side == kFridgeLeftDoor ? kLeftDoorIsOpen : kRightDoorIsOpen;
          if (wanted && now_.is(kFridge, state)) problem = act({Verb::kClose, side});
        }
      }
      any = true;
    } else if (!options.empty() && options.front() == kMicrowave) {
      if (now_.is(kMicrowave, kDoorIsOpen) != open)
        problem = act({open ? Verb::kOpen : Verb::kClose, kMicrowave});
      any = true;
    } else if (!options.empty() && options.front() == kBagOfChips_1 && open) {
      if (!now_.is(kBagOfChips_1, kIsOpen)) problem = act({Verb::kOpen, kBagOfChips_1});
      any = true;
    } else if (!options.empty() && (options.front() == kSinkKnob)) {
      problem = turn_on(kSinkKnob, open, 0);
      any = true;
    }
    if (!problem.empty()) return problem;
  }
  return any ? Problem{} : "there is no door on " + clause.phrases.front().phrase;
}

std::string FrameActions::wash(const Clause& clause) {
  Problem problem;
  if (resolver_.instruction().find(kSink) < 0) return "there is no sink here";
  const auto objects = direct(clause, Sort::kMovable, problem);
  if (!problem.empty()) return problem;
  for (const Symbol object : objects)
    if (problem = keep(object, kSink, false); !problem.empty()) return problem;
  const bool wet =
      std::all_of(objects.begin(), objects.end(), [&](Symbol object) { return now_.is(object, kWater); });
  return wet ? Problem{} : turn_on(kSinkKnob, true, 0);
}

std::string FrameActions::heat(const Clause& clause, bool boil) {
  Problem problem;
  const NounPhrase* destination = first(clause, Role::kDestination);
  const NounPhrase* with = first(clause, Role::kWith);
  Symbol content = mentioned_content(clause, Role::kDirect);
  std::vector<Symbol> objects;
  bool microwave = clause.verb == "microwave" || clause.verb == "nuke" || clause.has("microwave");
  if (content == kWater) {
    // In what? What the sentence says, else what holds water, else the kettle.
    Symbol vessel = kNone;
    for (const NounPhrase& phrase : clause.phrases) {
      const auto options = resolver_.options(phrase, Sort::kVessel, now_);
      if (phrase.role != Role::kDirect && !options.empty()) vessel = options.front();
    }
    if (vessel == kNone) vessel = vessel_with(kWater);
    if (vessel == kNone)
      for (const Symbol option : resolver_.all(Sort::kVessel, now_))
        if (resolver_.is_of_class(option, "kettle")) vessel = option;
    if (vessel == kNone) return "there is no pot here";
    if (problem = fill_with_water(vessel); !problem.empty()) return problem;
    objects = {vessel};
  } else if (content != kNone && vessel_with(content) != kNone) {
    objects = {vessel_with(content)};
  } else {
    objects = direct(clause, Sort::kMovable, problem);
    if (!problem.empty()) return problem;
  }
  last_ = objects;
  if (!microwave && !boil && destination == nullptr && with == nullptr &&
      !resolver_.is_of_class(objects.front(), "kettle"))
    microwave = resolver_.instruction().find(kMicrowave) >= 0;
  if (microwave) {
    for (const Symbol object : objects)
      if (problem = keep(object, kMicrowave, true); !problem.empty()) return problem;
    return turn_on(kMicrowave, true, 0);
  }
  for (const Symbol object : objects) {
    const Symbol burner = burner_for(object);
    if (burner == kNone) return "there is no stove here";
    if (!now_.has(Relation::kOn, object, burner))
      if (problem = act({Verb::kKeepOn, object, burner}); !problem.empty()) return problem;
    if (problem = turn_on(burner, true, 0); !problem.empty()) return problem;
  }
  return {};
}

std::string FrameActions::add_to(const Clause& clause) {
  Problem problem;
  const NounPhrase* destination = first(clause, Role::kDestination);
  if (destination == nullptr) destination = first(clause, Role::kWith);
  if (destination == nullptr) return "it is not clear where to " + clause.verb + " it";
  const auto targets = destination->pronoun ? last_ : resolver_.options(*destination, Sort::kMovable, now_);
  if (targets.empty()) return unknown_thing(*destination);
  const Symbol target = targets.front();
  const Symbol content = mentioned_content(clause, Role::kDirect);
  if (content == kIceCream) return scoop(clause);
  if (content == kWater) return pour(clause);
  const auto objects = direct(clause, Sort::kMovable, problem);
  if (!problem.empty()) return problem;
  for (const Symbol object : objects) {
    if (object == target) return "a thing cannot be added to itself";
    if (now_.has(Relation::kIsSqueezeable, object))
      problem = act({Verb::kSqueeze, object, target});
    else if (object == kSalt_1 || object == kRamen_1 || object == kBoiledEgg_1)
      problem = act({Verb::kAdd, object, target});
    else if (content != kNone && vessel_with(content) != kNone)
      problem = act({Verb::kPourInto, vessel_with(content), target});
    else
      problem = keep(object, target, true);
    if (!problem.empty()) return problem;
  }
  last_ = {target};
  return {};
}

std::string FrameActions::scoop(const Clause& clause) {
  const NounPhrase* destination = first(clause, Role::kDestination);
  Symbol source = kNone;
  for (const Symbol option : resolver_.all(Sort::kMovable, now_))
    if (now_.is(option, kScoopsLeft) && !resolver_.class_of(option)->utensil) source = option;
  if (source == kNone || resolver_.instruction().find(kSpoon_1) < 0) return "there is nothing here to scoop";
  if (!now_.is(kSpoon_1, kScoopsLeft))
    if (const Problem problem = act({Verb::kScoop, kSpoon_1, source}); !problem.empty()) return problem;
  if (destination == nullptr) return {};
  const auto targets = destination->pronoun ? last_ : resolver_.options(*destination, Sort::kVessel, now_);
  if (targets.empty()) return unknown_thing(*destination);
  last_ = {targets.front()};
  return act({Verb::kAdd, kIceCreamScoop, targets.front()});
}

std::string FrameActions::insert(const Clause& clause) {
  Problem problem;
  const auto objects = direct(clause, Sort::kMovable, problem);
  const Symbol target = place(clause, problem);
  if (!problem.empty()) return problem;
  if (target == kNone) return "it is not clear where to " + clause.verb + " it";
  return keep(objects.front(), target, true);
}

std::string FrameActions::release(const Clause& clause) {
  if (first(clause, Role::kDestination) != nullptr && !clause.has("go")) return put(clause);
  std::vector<Symbol> objects;
  for (const NounPhrase& phrase : clause.phrases) {
    std::vector<Symbol> options;
    if (phrase.pronoun) {
      for (const SymFact fact : now_.facts())
        if (relation_of(fact) == Relation::kGrasping) options.push_back(object_of(fact));
    } else {
      options = resolver_.options(phrase, Sort::kMovable, now_);
      std::erase_if(options, [&](Symbol object) { return !now_.holds(object); });
      options = resolver_.chosen(phrase, options);
    }
    if (options.empty()) return "the robot does not hold that";
    objects.insert(objects.end(), options.begin(), options.end());
  }
  if (objects.empty()) return "it is not clear what to let go of";
  for (const Symbol object : objects)
    if (const Problem problem = act({Verb::kRelease, object}); !problem.empty()) return problem;
  return {};
}

std::string FrameActions::television(const Clause& clause) {
  if (resolver_.instruction().find(kTv_1) < 0) return "there is no television here";
  const bool down =
      clause.has("down") || clause.has("previous") || clause.has("lower") || clause.frame == Frame::kLower;
  if (clause.has("channel"))
    return turn_on(kTv_1, true, 0).empty()
               ? act({Verb::kPress, down ? Symbol{kTv_1ChannelDownButton} : Symbol{kTv_1ChannelUpButton}})
               : "the television does not go on";
  const bool tv = clause.has("volume") || clause.has("tv") || clause.has("television") || clause.has("sound");
  if (!tv) return "it is not clear what to " + clause.verb;
  const bool quiet = down || clause.frame == Frame::kMute;
  if (now_.is(kTv_1, kVolume) != quiet) return {};
  return act({Verb::kPress, quiet ? Symbol{kTv_1VolumeDownButton} : Symbol{kTv_1VolumeUpButton}});
}

}  // namespace goalnet::inference
