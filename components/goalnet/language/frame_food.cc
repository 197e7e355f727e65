// Adding one thing to another: salt, syrup, water, noodles.
#include <algorithm>

#include "components/goalnet/language/frame_actions.h"

namespace goalnet::inference {

using namespace symbol;

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
  add_what_is_joined(clause);
  const NounPhrase *destination = clause.first(Role::kDestination), *with = clause.first(Role::kWith);
  std::vector<NounPhrase> whats;
  for (const NounPhrase& phrase : clause.phrases)
    if (phrase.role == Role::kDirect) whats.push_back(phrase);
  if (destination == nullptr && with != nullptr && !whats.empty()) {
    if (seasons(clause, whats.front())) {
      Clause turned = clause;
      turned.phrases = {*with, whats.front()};
      turned.phrases[0].role = Role::kDirect, turned.phrases[1].role = Role::kDestination;
      return add_to(turned);
    }
    destination = with;  // "mix the ramen with water"
  }
  if (at_home_ && whats.empty() && with != nullptr) {
    Clause onto_it = clause;  // "drizzle with syrup": onto what was spoken of
    for (NounPhrase& phrase : onto_it.phrases)
      if (phrase.role == Role::kWith) phrase.role = Role::kDirect;
    return add_to(onto_it);
  }
  if (whats.empty()) return "it is not clear what to " + clause.verb;
  Problem problem;
  const Objects targets = add_targets(clause, destination, whats, problem);
  if (!problem.empty()) return problem;
  Objects sources;  // "add the hot water from the kettle to the ramen"
  if (const NounPhrase* from = clause.first(Role::kSource);
      at_home_ && from != nullptr && !from->pronoun && !from->bare() && !from->unknown)
    sources = resolver_.options(*from, Sort::kVessel, now_);
  for (const Symbol target : targets)
    for (const NounPhrase& what : whats)
      if (problem = add_one(clause, what, target, targets, sources); !problem.empty()) return problem;
  remember(targets);
  return {};
}

// "add water to the bowl, and a pinch of salt as well": what nothing can be added to is added too
void FrameActions::add_what_is_joined(Clause& clause) {
  if (!at_home_) return;
  for (NounPhrase& phrase : clause.phrases) {
    if (phrase.role != Role::kDestination || !phrase.joined || phrase.pronoun || phrase.bare()) continue;
    const Objects takes = resolver_.options(phrase, Sort::kPlace, now_);
    const bool holder = std::ranges::any_of(takes, [&](Symbol object) { return is_vessel_or_dish(object); });
    if (!holder || phrase.some) phrase.role = Role::kDirect;
  }
}

// "season the bowl with salt": the bowl is what something is added to
bool FrameActions::seasons(const Clause& clause, const NounPhrase& dish) {
  const auto dishes = dish.pronoun || dish.bare() ? Objects{} : resolver_.options(dish, Sort::kVessel, now_);
  return !dishes.empty() || clause.verb == "season" || clause.verb == "sprinkle" ||
         clause.verb == "drizzle" || clause.verb == "top";
}

// What things are added to: vessels, dishes and ice cream.
FrameActions::Objects FrameActions::add_targets(const Clause& clause, const NounPhrase* destination,
                                                const std::vector<NounPhrase>& whats, Problem& problem) {
  const auto takes_nothing = [&](Symbol object) {
    return !is_vessel_or_dish(object) && object != resolver_.ice_cream();
  };
  if (destination == nullptr || destination->pronoun) {
    Objects these;
    for (const NounPhrase& what : whats)
      if (!what.pronoun && !what.bare()) these = resolver_.options(what, Sort::kMovable, now_);
    NounPhrase nameless;
    nameless.pronoun = true;
    Objects targets = pronoun(destination == nullptr ? nameless : *destination, Sort::kPlace, these);
    std::erase_if(targets, takes_nothing);
    if (targets.empty()) problem = "it is not clear where to " + clause.verb + " that";
    return targets;
  }
  Objects targets = destination->bare() ? Objects{} : resolver_.options(*destination, Sort::kMovable, now_);
  std::erase_if(targets, takes_nothing);
  if (language_.content(destination->phrase) == kIceCream) {  // what was scooped, not the tub
    Objects scooped;
    for (const Symbol dish : resolver_.all(Sort::kPlace, now_))
      if (now_.is(dish, kIceCream)) scooped.push_back(dish);
    if (!scooped.empty()) targets = scooped;
  }
  if (!targets.empty()) targets = resolver_.chosen(*destination, targets);
  if (targets.empty()) problem = unknown_thing(*destination, Sort::kVessel);
  return targets;
}

std::string FrameActions::add_one(const Clause& clause, const NounPhrase& what, Symbol target,
                                  const Objects& targets, const Objects& sources) {
  if (what.unknown) return unknown_thing(what, Sort::kMovable);
  const Symbol content = language_.content(what.phrase);
  if (!sources.empty() && sources.front() != target && content != kNone && now_.is(sources.front(), content))
    return pour_into(sources.front(), target, true);
  if (what.pronoun) return add_it(what, target, targets);
  if (const Problem problem = cannot_be_squeezed(clause, what); !problem.empty()) return problem;
  bool done = false;
  if (const Problem problem = add_content(what, target, done); done || !problem.empty()) return problem;
  // "add coffee to the mug" that has some
  if (at_home_ && !what.bare() && content != kNone && now_.is(target, content)) return {};
  const auto objects = what.everything ? Objects{} : resolver_.options(what, Sort::kMovable, now_);
  if (objects.empty()) return unknown_thing(what, Sort::kMovable);
  if (clause.frame == Frame::kSqueeze) return resolver_.name(objects.front()) + " cannot be squeezed";
  return resolver_.is_vessel(objects.front())
             ? "it is not clear how to add " + resolver_.name(objects.front())
             : keep(objects.front(), target, Where::kIn);
}

// "take the syrup and add it to the coffee"
std::string FrameActions::add_it(const NounPhrase& what, Symbol target, const Objects& targets) {
  const auto objects = pronoun(what, Sort::kMovable, targets);
  if (objects.empty()) return unknown_thing(what, Sort::kMovable);
  const Symbol object = objects.front();
  return now_.has(Relation::kIsSqueezeable, object) ? act({Verb::kSqueeze, object, target})
                                                    : keep(object, target, Where::kIn);
}

// "squeeze the pillow"; empty: it can be, or the clause does not say so.
std::string FrameActions::cannot_be_squeezed(const Clause& clause, const NounPhrase& what) {
  if (clause.frame != Frame::kSqueeze || what.bare()) return {};
  const auto bottles = what.everything ? Objects{} : resolver_.options(what, Sort::kMovable, now_);
  if (!bottles.empty() && now_.has(Relation::kIsSqueezeable, bottles.front())) return {};
  return (bottles.empty() ? "that" : resolver_.name(bottles.front())) + std::string(" cannot be squeezed");
}

}  // namespace goalnet::inference
