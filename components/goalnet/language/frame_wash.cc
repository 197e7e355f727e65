// Emptying and washing.
#include <algorithm>

#include "components/goalnet/language/frame_actions.h"

namespace goalnet::inference {

using namespace symbol;

std::string FrameActions::empty(const Clause& clause) {
  static constexpr Reading kReadings[] = {
      &FrameActions::empty_into_vessel,  // "empty the mug into the glass"
      &FrameActions::unload_there,       // "unload everything you carry onto the counter"
      &FrameActions::dump_there,         // "dump the trash bag into the bin"
      &FrameActions::dump_empty_there,   // "dump the bowl on the counter"
      &FrameActions::empty_place,        // "empty the shelf"
      &FrameActions::dump_away,          // "dump the bag of chips"
  };
  if (const auto read = first_that_fits(kReadings, clause)) return *read;
  Problem problem;
  const auto vessels = direct(clause, Sort::kVessel, problem);
  if (!problem.empty()) return problem;
  for (const Symbol vessel : vessels)
    if (content_of(vessel) != kNone)
      if (problem = act({Verb::kPour, vessel}); !problem.empty()) return problem;
  return {};
}

// "empty the mug into the glass", "empty out the coffee"
std::optional<std::string> FrameActions::empty_into_vessel(const Clause& clause) {
  if (mentioned_content(clause, Role::kDirect) != kNone) return pour(clause);
  const NounPhrase* destination = clause.first(Role::kDestination);
  if (destination == nullptr || destination->pronoun || destination->bare() ||
      resolver_.options(*destination, Sort::kVessel, now_).empty())
    return std::nullopt;
  return pour(clause);
}

// "unload everything you carry onto the counter"
std::optional<std::string> FrameActions::unload_there(const Clause& clause) {
  const NounPhrase* thing = clause.first(Role::kDirect);
  if (!at_home_ || clause.first(Role::kDestination) == nullptr || thing == nullptr || !thing->everything ||
      !thing->has("held"))
    return std::nullopt;
  return put(clause);
}

// "dump the trash bag into the bin": what is no vessel goes there as it is
std::optional<std::string> FrameActions::dump_there(const Clause& clause) {
  const NounPhrase* thing = clause.first(Role::kDirect);
  if (clause.first(Role::kDestination) == nullptr || thing == nullptr || thing->pronoun || thing->bare() ||
      thing->everything || !resolver_.options(*thing, Sort::kVessel, now_).empty() ||
      resolver_.options(*thing, Sort::kMovable, now_).empty())
    return std::nullopt;
  return put(clause);
}

// "dump the bowl on the counter": nothing is in it
std::optional<std::string> FrameActions::dump_empty_there(const Clause& clause) {
  const NounPhrase* thing = clause.first(Role::kDirect);
  if (!at_home_ || clause.verb != "dump" || clause.first(Role::kDestination) == nullptr || thing == nullptr ||
      thing->pronoun || thing->bare() || thing->everything)
    return std::nullopt;
  const Objects vessels = resolver_.options(*thing, Sort::kVessel, now_);
  if (vessels.empty() || !resolver_.is_empty(vessels.front(), now_)) return std::nullopt;
  return put(clause);
}

// "empty the shelf"
std::optional<std::string> FrameActions::empty_place(const Clause& clause) {
  const NounPhrase* thing = clause.first(Role::kDirect);
  if (thing == nullptr || thing->pronoun || thing->bare() ||
      !resolver_.options(*thing, Sort::kVessel, now_).empty())
    return std::nullopt;
  const auto places = resolver_.options(*thing, Sort::kPlace, now_);
  if (places.empty() || !resolver_.class_of(places.front())->place ||
      now_.has(Relation::kIsGraspable, places.front()) || resolver_.is_vessel(places.front()))
    return std::nullopt;
  return this->clear(clause);
}

// "dump the bag of chips"
std::optional<std::string> FrameActions::dump_away(const Clause& clause) {
  const NounPhrase* thing = clause.first(Role::kDirect);
  if (clause.verb != "dump" || thing == nullptr || thing->pronoun || thing->bare() ||
      !resolver_.options(*thing, Sort::kVessel, now_).empty())
    return std::nullopt;
  Clause thrown = clause;
  thrown.frame = Frame::kDiscard, thrown.verb = "discard";
  return discard(thrown);
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
