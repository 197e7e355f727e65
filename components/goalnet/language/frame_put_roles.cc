// Which phrases of a clause of putting are what is put, and which is the place.
#include <algorithm>

#include "components/goalnet/language/frame_actions.h"
#include "components/goalnet/language/symbol_list.h"

namespace goalnet::inference {

using namespace symbol;

// "put the mug in the sink and the glass too": what is joined to a place, but is none, is moved as well
void FrameActions::move_what_is_joined(Clause& clause) {
  bool first_place = true;
  for (NounPhrase& phrase : clause.phrases) {
    if (phrase.role != Role::kDestination) continue;
    const ObjectClass* c = nullptr;
    if (!first_place && !phrase.pronoun && !phrase.bare())
      if (const auto options = resolver_.options(phrase, Sort::kMovable, now_); !options.empty())
        c = resolver_.class_of(options.front());
    if (c != nullptr && !c->place && phrase.joined) phrase.role = Role::kDirect;
    // "the noodles go in the bowl, then water"
    if (at_home_ && !first_place && phrase.joined && c == nullptr &&
        language_.content(phrase.phrase) != kNone)
      phrase.role = Role::kDirect;
    first_place = false;
  }
}

// "put mug sink"
void FrameActions::part_thing_from_place(Clause& clause) {
  if (clause.phrases.size() != 1 || clause.first(Role::kDirect) == nullptr ||
      clause.phrases.front().modifier.empty() || !clause.particles.empty() ||
      !resolver_.options(clause.phrases.front(), Sort::kMovable, now_).empty())
    return;
  NounPhrase moved = clause.phrases.front();
  moved.phrase = moved.word = moved.modifier;
  moved.plural = moved.modifier_plural;
  moved.modifier.clear();
  NounPhrase& place = clause.phrases.front();
  place.role = Role::kDestination, place.where = at_home_ ? Where::kTo : Where::kOn;
  place.modifier.clear();
  clause.phrases.push_back(moved);
}

// "load the microwave with the bowl"
void FrameActions::load_place_with_thing(Clause& clause) {
  const NounPhrase *with = clause.first(Role::kWith), *place = clause.first(Role::kDirect);
  if (with == nullptr || place == nullptr || clause.verb != "load") return;
  const auto console = [&] {
    return at_home_ && !place->pronoun && !place->bare() && !resolver_.named(*place).empty() &&
           resolver_.named(*place).front() == resolver_.xbox();
  };
  if (!lexicon_place(*place) && !console()) return;
  for (NounPhrase& phrase : clause.phrases) {
    phrase.role = phrase.role == Role::kWith     ? Role::kDirect
                  : phrase.role == Role::kDirect ? Role::kDestination
                                                 : phrase.role;
    if (phrase.role == Role::kDestination) phrase.where = Where::kTo;
  }
}

// "put in a disc": what is put, where nothing can be put into it
std::optional<std::string> FrameActions::put_in_what_is_named(Clause& clause) {
  if (clause.phrases.size() != 1 || clause.first(Role::kDirect) != nullptr) return std::nullopt;
  NounPhrase& only = clause.phrases.front();
  if (only.pronoun || only.bare() || only.where != Where::kIn) return std::nullopt;
  const auto moved = resolver_.options(only, Sort::kMovable, now_);
  if (moved.empty()) return std::nullopt;
  const bool takes_things = resolver_.class_of(moved.front())->place || resolver_.is_vessel(moved.front()) ||
                            (at_home_ && (resolver_.is_of_class(moved.front(), "xbox") ||
                                          resolver_.is_of_class(moved.front(), "garbage_bin") ||
                                          resolver_.is_of_class(moved.front(), "garbage_bag")));
  if (takes_things) return std::nullopt;
  only.role = Role::kDirect;
  if (resolver_.is_of_class(moved.front(), "cd")) return insert(clause);
  clause.particles.push_back("in");
  return std::nullopt;
}

// Of several places the last; null where none is said.
const NounPhrase* FrameActions::destination_of(Clause& clause) {
  const NounPhrase* destination = nullptr;
  int places_said = 0;
  for (const NounPhrase& phrase : clause.phrases)
    if (phrase.role == Role::kDestination) destination = &phrase, ++places_said;
  if (destination == nullptr) return beside_what_is_with_it(clause);
  // Of two places the first says where it is: "put the cup on the counter in the sink".
  if (places_said > 1 && !(at_home_ && destination->joined))
    for (NounPhrase& phrase : clause.phrases)
      if (phrase.role == Role::kDestination && &phrase != destination) phrase.role = Role::kSource;
  return destination;
}

// "with the other drinks": where those are
const NounPhrase* FrameActions::beside_what_is_with_it(Clause& clause) {
  const NounPhrase* thing = clause.first(Role::kDirect);
  if (thing == nullptr || (at_home_ && !thing->content.empty()))  // "a bowl of ice cream with syrup"
    return nullptr;
  for (NounPhrase& phrase : clause.phrases) {
    if (phrase.role != Role::kWith || phrase.bare() || phrase.pronoun ||
        resolver_.options(phrase, Sort::kMovable, now_).empty())
      continue;
    const Symbol beside = resolver_.options(phrase, Sort::kMovable, now_).front();
    const bool rubbish =
        beside == kGarbageBin_1 || beside == kGarbageBag_1;  // "put the beer with the rubbish"
    phrase.role = Role::kDestination, phrase.where = rubbish ? Where::kIn : Where::kNear;
    return &phrase;
  }
  return nullptr;
}

}  // namespace goalnet::inference
