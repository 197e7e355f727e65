// What the frames of water, heat and food ask for.
#include <algorithm>

#include "components/goalnet/language/frame_actions.h"

namespace goalnet::inference {
namespace {

using namespace symbol;

constexpr int kMostScoops = 5;

}  // namespace

std::string FrameActions::fill_with_water(Symbol vessel) {
  if (now_.is(vessel, kWater)) return {};
  if (!resolver_.exists(kSink)) return not_here("there is no tap here to take water from");
  if (!now_.has(Relation::kOn, vessel, kSink))
    if (const Problem problem = act({Verb::kKeepOn, vessel, kSink}); !problem.empty()) return problem;
  if (now_.is(vessel, kWater)) return {};
  if (now_.is(kSinkKnob, kTapIsOn))  // it ran past the vessel: once more
    if (const Problem problem = act({Verb::kTurn, kSinkKnob}); !problem.empty()) return problem;
  return act({Verb::kTurn, kSinkKnob});
}

std::string FrameActions::fill_one(Symbol vessel, Symbol content) {
  if (now_.is(vessel, content)) return {};
  const Symbol source = vessel_with(content);
  if (source != kNone && source != vessel && content != kWater) return act({Verb::kPourInto, source, vessel});
  if (content == kWater) return fill_with_water(vessel);
  if (content == kIceCream) return scoop_into(vessel, 1);
  return "nothing here holds that to pour it";
}

std::string FrameActions::fill(const Clause& said) {
  Clause clause = said;
  // "fill water into the mug"
  const NounPhrase* thing = clause.first(Role::kDirect);
  Symbol content = mentioned_content(clause, Role::kWith);
  if (thing != nullptr && content == kNone && clause.first(Role::kDestination) != nullptr &&
      language_.content(thing->phrase) != kNone && thing->content.empty()) {
    content = language_.content(thing->phrase);
    std::erase_if(clause.phrases, [](const NounPhrase& p) { return p.role == Role::kDirect; });
    for (NounPhrase& phrase : clause.phrases)
      if (phrase.role == Role::kDestination) phrase.role = Role::kDirect;
  }
  // "fill a glass of water", "fill the mug with coffee": the content is wanted, not there
  bool hot = false;
  for (NounPhrase& phrase : clause.phrases) {
    if (phrase.role == Role::kDirect && !phrase.content.empty() && content == kNone) {
      content = language_.content(phrase.content);
      phrase.content.clear();
    }
    hot = hot || (phrase.role == Role::kWith && phrase.has("hot"));
  }
  Objects sources;
  Problem problem;
  for (const NounPhrase& phrase : clause.phrases)
    if (phrase.role == Role::kSource && !phrase.pronoun)
      sources = resolver_.options(phrase, Sort::kVessel, now_);
  std::erase_if(clause.phrases, [](const NounPhrase& p) { return p.role == Role::kSource; });
  const auto vessels = direct(clause, Sort::kVessel, problem);
  if (!problem.empty()) return problem;
  const NounPhrase* with = clause.first(Role::kWith);
  if (with != nullptr && content == kNone) {
    if (with->has("everything") || with->pronoun) return "it is not clear what to fill it with";
    bool done = false;
    for (const Symbol vessel : vessels)
      if (problem = add_content(*with, vessel, done); !problem.empty()) return problem;
    return done ? Problem{} : "it is not known how to fill something with " + with->word;
  }
  if (content == kNone && !sources.empty())
    for (Symbol c = kWater; c <= kEgg && content == kNone; ++c)
      if (now_.is(sources.front(), c)) content = c;
  if (content == kNone) content = kWater;
  for (const Symbol vessel : vessels) {
    const bool from = !sources.empty() && now_.is(sources.front(), content) && sources.front() != vessel;
    problem = from ? act({Verb::kPourInto, sources.front(), vessel}) : fill_one(vessel, content);
    if (!problem.empty()) return problem;
  }
  return hot && content == kWater ? heat_objects(vessels, true, nullptr) : Problem{};
}

std::string FrameActions::pour(const Clause& clause) {
  Problem problem;
  const NounPhrase* thing = clause.first(Role::kDirect);
  const NounPhrase* destination = clause.first(Role::kDestination);
  const NounPhrase* source_phrase = clause.first(Role::kSource);
  if (thing != nullptr && !thing->pronoun && destination == nullptr && !thing->content.empty())
    return fill(clause);  // "pour me a cup of coffee"
  const Symbol content = mentioned_content(clause, Role::kDirect);
  if (content == kIceCream && destination != nullptr) return scoop(clause);
  if (thing != nullptr && !thing->pronoun && destination != nullptr) {
    const auto shaken = resolver_.options(*thing, Sort::kMovable, now_);
    if (!shaken.empty() && (shaken.front() == kSalt_1 || now_.has(Relation::kIsSqueezeable, shaken.front()) ||
                            shaken.front() == kRamen_1 || shaken.front() == kBoiledEgg_1))
      return add_to(clause);
    // "pour the chips into the bowl": what is no liquid is put there
    if (!shaken.empty() && content == kNone && resolver_.class_of(shaken.front())->food &&
        !resolver_.is_vessel(shaken.front()))
      return put(clause);
  }
  Objects targets;
  if (destination != nullptr) {
    if (destination->pronoun) {
      targets = pronoun(*destination, Sort::kVessel, {});
    } else if (!destination->bare()) {
      NounPhrase into = *destination;
      targets = resolver_.options(into, Sort::kVessel, now_);
      if (destination->all || destination->count > 1)
        targets = resolver_.chosen(into, targets);
      else if (destination->ordinal > 0)
        targets = resolver_.chosen(into, targets);
    }
    if (targets.empty() && (destination->pronoun || destination->bare() ||
                            resolver_.options(*destination, Sort::kPlace, now_).empty()))
      return unknown_thing(*destination, Sort::kVessel);
    if (targets.empty() && !resolver_.options(*destination, Sort::kPlace, now_).empty() &&
        resolver_.options(*destination, Sort::kPlace, now_).front() != kSink)
      return "nothing can be poured there";
    if (!destination->all && destination->count < 2 && targets.size() > 1)
      targets.erase(targets.begin() + 1, targets.end());
  }
  Symbol source = kNone;
  if (source_phrase != nullptr && !source_phrase->pronoun) {
    const auto options = resolver_.options(*source_phrase, Sort::kVessel, now_);
    if (options.empty() && content == kWater && !targets.empty())
      source = kNone;  // from the tap
    else if (options.empty())
      return unknown_thing(*source_phrase, Sort::kVessel);
    else
      source = options.front();
  } else if (content != kNone) {
    source = vessel_with(content);
    if (source == kNone && content != kWater) {
      const auto cans = resolver_.options(*thing, Sort::kVessel, now_);
      return cans.empty() ? "nothing here holds " + thing->word
                          : resolver_.name(cans.front()) + " holds nothing that could be poured";
    }
  } else {
    const auto objects = direct(clause, Sort::kVessel, problem);
    if (!problem.empty()) return problem;
    source = objects.front();
  }
  if (source == kNone && content == kWater && !targets.empty()) {
    for (const Symbol target : targets)
      if (problem = fill_with_water(target); !problem.empty()) return problem;
    remember(targets);
    return {};
  }
  if (source == kNone) return "nothing here holds that to pour it";
  bool holds_something = false;
  for (Symbol c = kWater; c <= kEgg; ++c) holds_something = holds_something || now_.is(source, c);
  if (targets.empty()) {
    remember({source});
    return holds_something ? act({Verb::kPour, source}) : Problem{};
  }
  if (!holds_something) return resolver_.name(source) + " is empty";
  std::erase(targets, source);
  if (targets.empty()) return "a thing cannot be poured into itself";
  if (targets.size() > 1)
    return "what " + resolver_.name(source) + " holds can be poured into one vessel only";
  problem = act({Verb::kPourInto, source, targets.front()});
  remember(targets);
  return problem;
}

std::string FrameActions::empty(const Clause& clause) {
  if (mentioned_content(clause, Role::kDirect) != kNone) return pour(clause);
  const NounPhrase* destination = clause.first(Role::kDestination);
  if (destination != nullptr && !destination->pronoun && !destination->bare() &&
      !resolver_.options(*destination, Sort::kVessel, now_).empty())
    return pour(clause);
  // "dump the trash bag into the bin": what is no vessel goes there as it is
  if (const NounPhrase* thing = clause.first(Role::kDirect);
      destination != nullptr && thing != nullptr && !thing->pronoun && !thing->bare() && !thing->everything &&
      resolver_.options(*thing, Sort::kVessel, now_).empty() &&
      !resolver_.options(*thing, Sort::kMovable, now_).empty())
    return put(clause);
  // "empty the shelf"
  if (const NounPhrase* thing = clause.first(Role::kDirect);
      thing != nullptr && !thing->pronoun && !thing->bare() &&
      resolver_.options(*thing, Sort::kVessel, now_).empty()) {
    const auto places = resolver_.options(*thing, Sort::kPlace, now_);
    if (!places.empty() && resolver_.class_of(places.front())->place &&
        !now_.has(Relation::kIsGraspable, places.front()))
      return clear(clause);
  }
  Problem problem;
  const auto vessels = direct(clause, Sort::kVessel, problem);
  if (!problem.empty()) return problem;
  for (const Symbol vessel : vessels) {
    bool anything = false;
    for (Symbol c = kWater; c <= kEgg; ++c) anything = anything || now_.is(vessel, c);
    if (anything)
      if (problem = act({Verb::kPour, vessel}); !problem.empty()) return problem;
  }
  return {};
}

std::string FrameActions::wash(const Clause& clause) {
  Problem problem;
  if (!resolver_.exists(kSink)) return not_here("there is no sink here");
  const auto objects = direct(clause, Sort::kMovable, problem);
  if (!problem.empty()) return problem;
  for (const Symbol object : objects) {
    const ObjectClass* c = resolver_.class_of(object);
    if (!resolver_.is_vessel(object) && !c->dish && !c->utensil)
      return resolver_.name(object) + " should not be washed";
  }
  for (const Symbol object : objects)
    if (problem = keep(object, kSink, Where::kOn); !problem.empty()) return problem;
  const bool wet =
      std::all_of(objects.begin(), objects.end(), [&](Symbol object) { return now_.is(object, kWater); });
  return wet && now_.is(kSinkKnob, kTapIsOn) ? Problem{} : turn_on(kSinkKnob, true, 0);
}

std::string FrameActions::heat(const Clause& clause, bool boil) {
  Problem problem;
  const NounPhrase* where = nullptr;
  bool microwave = clause.verb == "microwave" || clause.verb == "nuke", stove = boil;
  for (const NounPhrase& phrase : clause.phrases) {
    if (phrase.role != Role::kDestination && phrase.role != Role::kWith) continue;
    if (phrase.pronoun || phrase.bare()) continue;
    const auto options = resolver_.options(phrase, Sort::kPlace, now_);
    if (options.empty()) continue;
    if (options.front() == kMicrowave) microwave = true, stove = false;
    if (resolver_.is_of_class(options.front(), "burner")) stove = true, microwave = false, where = &phrase;
  }
  const Symbol content = mentioned_content(clause, Role::kDirect);
  const NounPhrase* thing = clause.first(Role::kDirect);
  Objects objects;
  const bool named_vessel = thing != nullptr && !thing->content.empty();
  if (content == kWater || (named_vessel && language_.content(thing->content) == kWater)) {
    // In what? What the sentence says, else what holds water, else the kettle.
    Symbol vessel = kNone;
    for (const NounPhrase& phrase : clause.phrases) {
      NounPhrase plain = phrase;
      plain.content.clear();
      if ((phrase.role == Role::kDirect && !named_vessel) || phrase.pronoun || phrase.bare()) continue;
      const auto options = resolver_.options(plain, Sort::kVessel, now_);
      if (!options.empty()) vessel = options.front();
    }
    if (vessel == kNone) vessel = vessel_with(kWater);
    if (vessel == kNone)
      for (const Symbol option : resolver_.all(Sort::kVessel, now_))
        if (resolver_.is_of_class(option, "kettle")) vessel = option;
    if (vessel == kNone) return not_here("there is no pot here to heat it in");
    if (problem = fill_with_water(vessel); !problem.empty()) return problem;
    objects = {vessel};
    remember(objects);
  } else {
    objects = direct(clause, Sort::kMovable, problem);
    if (!problem.empty()) return problem;
  }
  for (const Symbol object : objects) {
    const ObjectClass* c = resolver_.class_of(object);
    if (!resolver_.is_vessel(object) && !c->dish && !c->food)
      return resolver_.name(object) + " should not be heated";
  }
  const Symbol front = objects.front();
  const bool raw = front == kRamen_1 || front == kBoiledEgg_1;
  if (raw && (boil || (clause.verb == "cook" && front == kRamen_1)) && !microwave) {  // in boiling water
    Symbol pot = kNone;
    for (const Symbol option : resolver_.all(Sort::kVessel, now_))
      if (resolver_.is_of_class(option, "kettle")) pot = option;
    for (const NounPhrase& phrase : clause.phrases)
      if (phrase.role == Role::kDestination && !phrase.pronoun && !phrase.bare())
        if (const auto options = resolver_.options(phrase, Sort::kVessel, now_); !options.empty())
          pot = options.front();
    if (pot == kNone) return not_here("there is no pot here to heat it in");
    if (problem = fill_with_water(pot); !problem.empty()) return problem;
    for (const Symbol object : objects)
      if (problem = keep(object, pot, Where::kIn); !problem.empty()) return problem;
    for (const NounPhrase& phrase : clause.phrases) {  // "with salt"
      bool done = false;
      if (phrase.role == Role::kWith && !phrase.pronoun)
        if (problem = add_content(phrase, pot, done); !problem.empty()) return problem;
    }
    return heat_objects({pot}, false, where);
  }
  if (boil && resolver_.is_of_class(front, "kettle"))
    if (problem = fill_with_water(front); !problem.empty()) return problem;
  if (!microwave && !stove && !resolver_.is_of_class(front, "kettle"))
    microwave = resolver_.exists(kMicrowave);
  // What stands on a burner already is heated there.
  for (Symbol burner = kStoveFire_1; burner <= kStoveFire_4; ++burner)
    if (clause.verb != "microwave" && objects.size() == 1 && now_.has(Relation::kOn, front, burner) &&
        !stove && clause.first(Role::kDestination) == nullptr && clause.first(Role::kWith) == nullptr)
      microwave = false;
  return heat_objects(objects, microwave, where);
}

std::string FrameActions::heat_objects(const Objects& objects, bool microwave, const NounPhrase* where) {
  Problem problem;
  if (microwave && !resolver_.exists(kMicrowave)) return not_here("there is no microwave here");
  if (microwave) {
    for (const Symbol object : objects)
      if (problem = keep(object, kMicrowave, Where::kIn); !problem.empty()) return problem;
    last_destination_ = {Symbol{kMicrowave}};
    return turn_on(kMicrowave, true, 0);
  }
  const bool which = where != nullptr && (where->ordinal > 0 || where->number > 0);
  for (const Symbol object : objects) {
    Symbol burner = burner_for(object);
    if (which) {
      const auto said = places(*where, objects, 1, problem);
      if (!problem.empty()) return problem;
      burner = said.front();
    }
    if (burner == kNone) return not_here("there is no stove here");
    if (!now_.has(Relation::kOn, object, burner))
      if (problem = act({Verb::kKeepOn, object, burner}); !problem.empty()) return problem;
    if (problem = turn_on(burner, true, 0); !problem.empty()) return problem;
    last_destination_ = {burner};
  }
  return {};
}

// Adds something to a vessel or a dish: water, salt, syrup, ice cream, ... `done` says whether that is known
// how.
std::string FrameActions::add_content(const NounPhrase& what, Symbol target, bool& done) {
  const Symbol content = language_.content(what.phrase);
  done = true;
  if (content == kIceCream) return scoop_into(target, std::max(what.count, 1));
  if (what.everything || what.bare()) {
    done = false;
    return {};
  }
  const auto objects = resolver_.options(what, Sort::kMovable, now_);
  if (content == kWater ||
      (content != kNone && vessel_with(content) != kNone && vessel_with(content) != target &&
       (objects.empty() || resolver_.is_vessel(objects.front()))))
    return fill_one(target, content);
  if (objects.empty()) {
    done = false;
    return {};
  }
  const Symbol object = objects.front();
  if (now_.has(Relation::kIsSqueezeable, object)) return act({Verb::kSqueeze, object, target});
  if (object == kSalt_1 || object == kRamen_1 || object == kBoiledEgg_1)
    return act({Verb::kAdd, object, target});
  if (object == kSpoon_1 || object == kFork_1) return keep(object, target, Where::kIn);
  done = false;
  return {};
}

std::string FrameActions::add_to(const Clause& clause) {
  const NounPhrase* destination = clause.first(Role::kDestination);
  std::vector<NounPhrase> whats;
  for (const NounPhrase& phrase : clause.phrases)
    if (phrase.role == Role::kDirect) whats.push_back(phrase);
  if (const NounPhrase* with = clause.first(Role::kWith);
      destination == nullptr && with != nullptr && !whats.empty()) {
    // "season the bowl with salt", "mix the ramen with water"
    const auto dishes = whats.front().pronoun || whats.front().bare()
                            ? Objects{}
                            : resolver_.options(whats.front(), Sort::kVessel, now_);
    const bool season = !dishes.empty() || clause.verb == "season" || clause.verb == "sprinkle" ||
                        clause.verb == "drizzle" || clause.verb == "top";
    if (season) {
      destination = &whats.front();
      const NounPhrase target = *destination;
      Clause turned = clause;
      turned.phrases = {*with, target};
      turned.phrases[0].role = Role::kDirect, turned.phrases[1].role = Role::kDestination;
      return add_to(turned);
    }
    destination = with;
  }
  if (whats.empty()) return "it is not clear what to " + clause.verb;
  Objects targets;
  const auto can_take = [&](Symbol object) {
    return resolver_.is_vessel(object) || resolver_.class_of(object)->dish || object == resolver_.ice_cream();
  };
  if (destination == nullptr || destination->pronoun) {
    NounPhrase it;
    it.pronoun = true;
    Objects these;
    for (const NounPhrase& what : whats)
      if (!what.pronoun && !what.bare()) these = resolver_.options(what, Sort::kMovable, now_);
    targets = pronoun(destination == nullptr ? it : *destination, Sort::kPlace, these);
    std::erase_if(targets, [&](Symbol object) { return !can_take(object); });
    if (targets.empty()) return "it is not clear where to " + clause.verb + " that";
  } else {
    targets = destination->bare() ? Objects{} : resolver_.options(*destination, Sort::kMovable, now_);
    std::erase_if(targets, [&](Symbol object) { return !can_take(object); });
    if (language_.content(destination->phrase) == kIceCream) {  // what was scooped, not the tub
      Objects scooped;
      for (const Symbol dish : resolver_.all(Sort::kPlace, now_))
        if (now_.is(dish, kIceCream)) scooped.push_back(dish);
      if (!scooped.empty()) targets = scooped;
    }
    if (targets.empty()) return unknown_thing(*destination, Sort::kVessel);
    targets = resolver_.chosen(*destination, targets);
    if (targets.empty()) return unknown_thing(*destination, Sort::kVessel);
  }
  for (const Symbol target : targets)
    for (const NounPhrase& what : whats) {
      if (what.unknown) return unknown_thing(what, Sort::kMovable);
      Problem problem;
      bool done = false;
      if (clause.frame == Frame::kSqueeze && !what.pronoun && !what.bare()) {
        const auto bottles = what.everything ? Objects{} : resolver_.options(what, Sort::kMovable, now_);
        if (bottles.empty() || !now_.has(Relation::kIsSqueezeable, bottles.front()))
          return (bottles.empty() ? "that" : resolver_.name(bottles.front())) +
                 std::string(" cannot be squeezed");
      }
      if (what.pronoun) {
        const auto objects = pronoun(what, Sort::kMovable, targets);
        if (objects.empty()) return unknown_thing(what, Sort::kMovable);
        const Symbol object = objects.front();
        problem = now_.has(Relation::kIsSqueezeable, object) ? act({Verb::kSqueeze, object, target})
                                                             : keep(object, target, Where::kIn);
        done = true;
      } else {
        problem = add_content(what, target, done);
      }
      if (!done && problem.empty()) {
        const auto objects = what.everything ? Objects{} : resolver_.options(what, Sort::kMovable, now_);
        if (objects.empty()) return unknown_thing(what, Sort::kMovable);
        if (clause.frame == Frame::kSqueeze) return resolver_.name(objects.front()) + " cannot be squeezed";
        problem = resolver_.is_vessel(objects.front())
                      ? "it is not clear how to add " + resolver_.name(objects.front())
                      : keep(objects.front(), target, Where::kIn);
      }
      if (!problem.empty()) return problem;
    }
  remember(targets);
  return {};
}

std::string FrameActions::scoop_into(Symbol target, int times) {
  Symbol source = resolver_.ice_cream();
  if (source == kNone || !resolver_.exists(kSpoon_1)) return not_here("there is nothing here to scoop");
  for (int i = 0; i < std::min(times, kMostScoops); ++i) {
    if (!now_.is(kSpoon_1, kScoopsLeft)) {
      if (!now_.is(source, kScoopsLeft)) return "no ice cream is left";
      if (const Problem problem = act({Verb::kScoop, kSpoon_1, source}); !problem.empty()) return problem;
    }
    if (target == kNone) return {};
    if (const Problem problem = act({Verb::kAdd, kIceCreamScoop, target}); !problem.empty()) return problem;
  }
  return {};
}

std::string FrameActions::scoop(const Clause& clause) {
  const NounPhrase* destination = clause.first(Role::kDestination);
  const NounPhrase* thing = clause.first(Role::kDirect);
  int times = 1;
  if (thing != nullptr) {
    const bool ice_cream = thing->scoop
                               ? thing->phrase.empty() || language_.content(thing->phrase) == kIceCream
                               : language_.content(thing->phrase) == kIceCream ||
                                     (thing->pronoun && !pronoun(*thing, Sort::kMovable, {}).empty() &&
                                      pronoun(*thing, Sort::kMovable, {}).front() == resolver_.ice_cream());
    if (!ice_cream) return "only ice cream can be scooped";
    if (thing->count > 1) times = thing->count;
  }
  if (const NounPhrase* with = clause.first(Role::kWith);
      with != nullptr && !with->pronoun &&
      (with->bare() || resolver_.options(*with, Sort::kMovable, now_).empty()))
    return unknown_thing(*with, Sort::kMovable);
  if (destination == nullptr) {
    remember({resolver_.exists(kSpoon_1) ? Symbol{kSpoon_1} : Symbol{kNone}});
    return scoop_into(kNone, 1);
  }
  Objects targets = destination->pronoun  ? pronoun(*destination, Sort::kPlace, {})
                    : destination->bare() ? Objects{}
                                          : resolver_.options(*destination, Sort::kMovable, now_);
  std::erase_if(targets, [&](Symbol object) {
    return !resolver_.is_vessel(object) && !resolver_.class_of(object)->dish;
  });
  if (targets.empty()) return unknown_thing(*destination, Sort::kVessel);
  if (!destination->pronoun) targets = resolver_.chosen(*destination, targets);
  for (const Symbol target : targets)
    if (const Problem problem = scoop_into(target, times); !problem.empty()) return problem;
  remember(targets);
  return {};
}

// "a cup of hot water", "a bowl of ice cream with chocolate syrup", "some noodles".
std::string FrameActions::make(const Clause& clause) {
  const NounPhrase* thing = clause.first(Role::kDirect);
  if (thing == nullptr || thing->bare()) return "it is not clear what to " + clause.verb;
  Symbol content = language_.content(thing->content.empty() ? thing->phrase : thing->content);
  if (content == kNone) {
    const auto objects =
        thing->pronoun || thing->everything ? Objects{} : resolver_.options(*thing, Sort::kMovable, now_);
    if (!objects.empty() && resolver_.is_of_class(objects.front(), "instant_ramen")) {
      if (const Problem problem = fill_with_water(objects.front()); !problem.empty()) return problem;
      remember({objects.front()});
      return heat_objects({objects.front()}, resolver_.exists(kMicrowave), nullptr);
    }
    return "it is not known how to make that; water, coffee, noodles and ice cream can be had";
  }
  const bool hot = thing->has("hot") || thing->has("warm") || thing->has("boiling");
  Symbol vessel = kNone;
  if (!thing->content.empty()) {
    NounPhrase plain = *thing;
    plain.content.clear(), plain.adjectives.clear();
    const auto options = resolver_.options(plain, Sort::kPlace, now_);
    if (options.empty()) return unknown_thing(*thing, Sort::kVessel);
    vessel = options.front();
    // the one that has it already
    for (const Symbol option : resolver_.all(Sort::kVessel, now_))
      if (now_.is(option, content) && content != kWater &&
          resolver_.class_of(option) == resolver_.class_of(vessel))
        vessel = option;
    if (content == kCoffee && vessel_with(kCoffee) != kNone) vessel = vessel_with(kCoffee);
  } else if (const NounPhrase* destination = clause.first(Role::kDestination);
             destination != nullptr && !destination->pronoun && !destination->bare()) {
    const auto options = resolver_.options(*destination, Sort::kPlace, now_);
    if (!options.empty() &&
        (resolver_.is_vessel(options.front()) || resolver_.class_of(options.front())->dish))
      vessel = options.front();
  }
  const auto of_class = [&](const char* name) {
    for (const SeenObject& object : resolver_.objects())
      if (resolver_.is_of_class(object.symbol, name)) return object.symbol;
    return Symbol{kNone};
  };
  Problem problem;
  switch (content) {
    case kWater:
      if (vessel == kNone) vessel = clause.frame == Frame::kMake ? of_class("kettle") : of_class("glass");
      if (vessel == kNone) vessel = of_class("long_cup");
      if (vessel == kNone) return "there is nothing here to fill";
      remember({vessel});
      if (problem = fill_with_water(vessel); !problem.empty()) return problem;
      if (!hot)
        return clause.frame == Frame::kTake && !now_.holds(vessel) ? act({Verb::kGrasp, vessel}) : Problem{};
      return heat_objects({vessel}, !resolver_.is_of_class(vessel, "kettle") && resolver_.exists(kMicrowave),
                          nullptr);
    case kCoffee:
      if (vessel == kNone) vessel = vessel_with(kCoffee);
      if (vessel == kNone) return not_here("there is no coffee here");
      remember({vessel});
      if (problem = fill_one(vessel, kCoffee); !problem.empty()) return problem;
      if (hot) return heat_objects({vessel}, resolver_.exists(kMicrowave), nullptr);
      return now_.holds(vessel) ? Problem{} : act({Verb::kGrasp, vessel});
    case kIceCream:
      if (vessel == kNone) vessel = of_class("bowl");
      if (vessel == kNone) return not_here("there is no bowl here");
      remember({vessel});
      problem = scoop_into(vessel, std::max(thing->count, 1));
      break;
    case kRamen:
    case kEgg: {
      if (vessel == kNone) vessel = of_class("kettle");
      if (vessel == kNone) return not_here("there is no pot here to heat it in");
      remember({vessel});
      const Symbol food = content == kRamen ? Symbol{kRamen_1} : Symbol{kBoiledEgg_1};
      if (!resolver_.exists(food)) return not_here("there is no " + thing->word + " here");
      if (problem = fill_with_water(vessel); !problem.empty()) return problem;
      if (problem = keep(food, vessel, Where::kIn); !problem.empty()) return problem;
      problem = heat_objects(
          {vessel}, !resolver_.is_of_class(vessel, "kettle") && resolver_.exists(kMicrowave), nullptr);
      break;
    }
    default:
      return "it is not known how to make that; water, coffee, noodles and ice cream can be had";
  }
  if (!problem.empty()) return problem;
  for (const NounPhrase& phrase : clause.phrases) {
    if (phrase.role != Role::kWith) continue;
    bool done = false;
    if (problem = add_content(phrase, vessel, done); !problem.empty()) return problem;
  }
  return {};
}

}  // namespace goalnet::inference
