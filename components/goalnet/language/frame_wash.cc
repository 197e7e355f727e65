// Emptying and washing.
#include <algorithm>

#include "components/goalnet/language/frame_actions.h"

namespace goalnet::inference {

using namespace symbol;

std::string FrameActions::empty(const Clause& clause) {
  if (mentioned_content(clause, Role::kDirect) != kNone) return pour(clause);
  const NounPhrase* destination = clause.first(Role::kDestination);
  if (destination != nullptr && !destination->pronoun && !destination->bare() &&
      !resolver_.options(*destination, Sort::kVessel, now_).empty())
    return pour(clause);
  if (const NounPhrase* thing =
          clause.first(Role::kDirect);  // "unload everything you carry onto the counter"
      at_home_ && destination != nullptr && thing != nullptr && thing->everything && thing->has("held"))
    return put(clause);
  // "dump the trash bag into the bin": what is no vessel goes there as it is
  if (const NounPhrase* thing = clause.first(Role::kDirect);
      destination != nullptr && thing != nullptr && !thing->pronoun && !thing->bare() && !thing->everything &&
      resolver_.options(*thing, Sort::kVessel, now_).empty() &&
      !resolver_.options(*thing, Sort::kMovable, now_).empty())
    return put(clause);
  // "dump the bowl on the counter": nothing is in it
  if (const NounPhrase* thing = clause.first(Role::kDirect);
      at_home_ && clause.verb == "dump" && destination != nullptr && thing != nullptr && !thing->pronoun &&
      !thing->bare() && !thing->everything) {
    const Objects vessels = resolver_.options(*thing, Sort::kVessel, now_);
    if (!vessels.empty() && resolver_.is_empty(vessels.front(), now_)) return put(clause);
  }
  // "empty the shelf"
  if (const NounPhrase* thing = clause.first(Role::kDirect);
      thing != nullptr && !thing->pronoun && !thing->bare() &&
      resolver_.options(*thing, Sort::kVessel, now_).empty()) {
    const auto places = resolver_.options(*thing, Sort::kPlace, now_);
    if (!places.empty() && resolver_.class_of(places.front())->place &&
        !now_.has(Relation::kIsGraspable, places.front()) && !resolver_.is_vessel(places.front()))
      return clear(clause);
  }
  if (const NounPhrase* thing = clause.first(Role::kDirect);
      clause.verb == "dump" && thing != nullptr && !thing->pronoun && !thing->bare() &&
      resolver_.options(*thing, Sort::kVessel, now_).empty()) {  // "dump the bag of chips"
    Clause thrown = clause;
    thrown.frame = Frame::kDiscard, thrown.verb = "discard";
    return discard(thrown);
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
  if (const NounPhrase* thing = clause.first(Role::kDirect);
      clause.verb == "clean" && thing != nullptr && lexicon_place(*thing))
    return clear(clause);  // "clean up the stove"
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

}  // namespace goalnet::inference
