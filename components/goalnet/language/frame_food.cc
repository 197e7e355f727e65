// Adding one thing to another, scooping.
#include <algorithm>

#include "components/goalnet/language/frame_actions.h"

namespace goalnet::inference {

using namespace symbol;

namespace {

constexpr int kMostScoops = 5;

}  // namespace

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

std::string FrameActions::add_to(const Clause& said) {
  Clause clause = said;
  // "add water to the bowl, and a pinch of salt as well": what nothing can be added to is added too
  if (at_home_ && clause.first(Role::kDestination) != nullptr)
    for (NounPhrase& phrase : clause.phrases) {
      if (phrase.role != Role::kDestination || !phrase.joined || phrase.pronoun || phrase.bare()) continue;
      const Objects takes = resolver_.options(phrase, Sort::kPlace, now_);
      const bool holder = std::any_of(takes.begin(), takes.end(), [&](Symbol object) {
        return resolver_.is_vessel(object) || resolver_.class_of(object)->dish;
      });
      if (!holder || phrase.some) phrase.role = Role::kDirect;
    }
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
  if (const NounPhrase* with = clause.first(Role::kWith); at_home_ && whats.empty() && with != nullptr) {
    Clause onto_it = clause;  // "drizzle with syrup": onto what was spoken of
    for (NounPhrase& phrase : onto_it.phrases)
      if (phrase.role == Role::kWith) phrase.role = Role::kDirect;
    return add_to(onto_it);
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
  Objects sources;  // "add the hot water from the kettle to the ramen"
  if (const NounPhrase* from = clause.first(Role::kSource);
      at_home_ && from != nullptr && !from->pronoun && !from->bare() && !from->unknown)
    sources = resolver_.options(*from, Sort::kVessel, now_);
  for (const Symbol target : targets)
    for (const NounPhrase& what : whats) {
      if (what.unknown) return unknown_thing(what, Sort::kMovable);
      if (!sources.empty() && sources.front() != target && language_.content(what.phrase) != kNone &&
          now_.is(sources.front(), language_.content(what.phrase))) {
        if (const Problem poured = pour_into(sources.front(), target, true); !poured.empty()) return poured;
        continue;
      }
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
      if (at_home_ && !done && problem.empty() && !what.pronoun && !what.bare() &&
          language_.content(what.phrase) != kNone && now_.is(target, language_.content(what.phrase)))
        continue;  // "add coffee to the mug" that has some
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
  if (at_home_ && destination == nullptr && thing != nullptr && thing->scoop && thing->at.size() == 1)
    destination = &thing->at.front();  // "I want a scoop of ice cream in the bowl"
  int times = 1;
  if (thing != nullptr) {
    const bool ice_cream = thing->scoop
                               ? thing->phrase.empty() || language_.content(thing->phrase) == kIceCream
                               : language_.content(thing->phrase) == kIceCream ||
                                     (thing->pronoun && !pronoun(*thing, Sort::kMovable, {}).empty() &&
                                      pronoun(*thing, Sort::kMovable, {}).front() == resolver_.ice_cream());
    const bool some = thing->bare() && thing->some;  // "scoop some into the mug"
    if (!ice_cream && !some) return "only ice cream can be scooped";
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
  // "a scoop of ice cream in the bowl with chocolate syrup"
  if (const NounPhrase* with = clause.first(Role::kWith);
      at_home_ && with != nullptr && !with->pronoun && !with->bare()) {
    const Objects toppings = resolver_.options(*with, Sort::kMovable, now_);
    const bool squeezed = !toppings.empty() && now_.has(Relation::kIsSqueezeable, toppings.front());
    for (const Symbol target : squeezed ? targets : Objects{})
      if (const Problem problem = act({Verb::kSqueeze, toppings.front(), target}); !problem.empty())
        return problem;
  }
  remember(targets);
  return {};
}

}  // namespace goalnet::inference
