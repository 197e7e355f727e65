// Putting things somewhere.
#include <algorithm>

#include "components/goalnet/language/frame_actions.h"
#include "components/goalnet/language/symbol_list.h"

namespace goalnet::inference {

using namespace symbol;

std::string FrameActions::put(const Clause& said) {
  if (at_home_ && said.has_particle("at_tray") && said.first(Role::kDestination) == nullptr)
    return put_on_tray(said);
  if (said.frame == Frame::kBring)  // "bring me some water in a long cup"
    if (const auto filled = give_content(said)) return *filled;
  Clause clause = said;
  // "bring the book on the shelf": where one is on the shelf, that says which
  if (const NounPhrase* thing = clause.first(Role::kDirect), *place = clause.first(Role::kDestination);
      at_home_ && clause.frame == Frame::kBring && (clause.verb == "bring" || clause.verb == "fetch") &&
      clause.phrases.size() == 2 && thing != nullptr && place != nullptr && clause.particles.empty() &&
      !thing->pronoun && !thing->bare() && !thing->everything && !thing->has("other") && !thing->rest &&
      !place->pronoun && !place->bare() && !place->has("other") &&
      (place->where == Where::kOn || place->where == Where::kIn) && !clause.has("onto") &&
      !clause.has("into") && !clause.has("a") && !clause.has("another")) {
    NounPhrase located = *thing;
    located.at.push_back(*place);
    const int loose = resolver_.doubts().loose;
    const auto there = resolver_.options(located, Sort::kMovable, now_);
    const bool which = !there.empty() && resolver_.doubts().loose == loose;
    resolver_.doubts().loose = loose;
    if (which) {
      clause.phrases = {located};
      clause.frame = Frame::kTake, clause.to_person = true;
      return take(clause);
    }
  }
  // "put the mug in the sink and the glass too": what is joined to a place, but is none, is moved as well
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
  // "put mug sink"
  if (clause.phrases.size() == 1 && clause.first(Role::kDirect) != nullptr &&
      !clause.phrases.front().modifier.empty() && clause.particles.empty() &&
      resolver_.options(clause.phrases.front(), Sort::kMovable, now_).empty()) {
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
  if (const NounPhrase* with = clause.first(Role::kWith), *place = clause.first(Role::kDirect);
      with != nullptr && place != nullptr && clause.verb == "load" &&
      (lexicon_place(*place) ||
       (at_home_ && !place->pronoun && !place->bare() && !resolver_.named(*place).empty() &&
        resolver_.named(*place).front() == resolver_.xbox()))) {
    for (NounPhrase& phrase : clause.phrases)
      phrase.role = phrase.role == Role::kWith     ? Role::kDirect
                    : phrase.role == Role::kDirect ? Role::kDestination
                                                   : phrase.role;
    for (NounPhrase& phrase : clause.phrases)
      if (phrase.role == Role::kDestination) phrase.where = Where::kTo;
  }
  if (clause.has_particle("to_boil")) return heat(clause, true);  // "bring the water to the boil"
  // "put in a disc"
  if (clause.phrases.size() == 1 && clause.first(Role::kDirect) == nullptr) {
    NounPhrase& only = clause.phrases.front();
    const auto moved = only.pronoun || only.bare() || only.where != Where::kIn
                           ? Objects{}
                           : resolver_.options(only, Sort::kMovable, now_);
    const bool console = at_home_ && !moved.empty() &&
                         (resolver_.is_of_class(moved.front(), "xbox") ||
                          resolver_.is_of_class(moved.front(), "garbage_bin") ||
                          resolver_.is_of_class(moved.front(), "garbage_bag"));
    if (!moved.empty() && !console && !resolver_.class_of(moved.front())->place &&
        !resolver_.is_vessel(moved.front())) {
      only.role = Role::kDirect;
      if (resolver_.is_of_class(moved.front(), "cd")) return insert(clause);
      clause.particles.push_back("in");
    }
  }
  put_what_is_unsaid(clause);
  const NounPhrase* thing = clause.first(Role::kDirect);
  const NounPhrase* destination = nullptr;
  int places_said = 0;
  for (const NounPhrase& phrase : clause.phrases)
    if (phrase.role == Role::kDestination) destination = &phrase, ++places_said;
  // "with the other drinks": where those are
  if (destination == nullptr && thing != nullptr)
    for (NounPhrase& phrase : clause.phrases)
      if (phrase.role == Role::kWith && !phrase.bare() && !phrase.pronoun &&
          !(at_home_ && !thing->content.empty()) &&  // "a bowl of ice cream with syrup"
          !resolver_.options(phrase, Sort::kMovable, now_).empty()) {
        const Symbol beside = resolver_.options(phrase, Sort::kMovable, now_).front();
        const bool rubbish =
            beside == kGarbageBin_1 || beside == kGarbageBag_1;  // "put the beer with the rubbish"
        phrase.role = Role::kDestination, phrase.where = rubbish ? Where::kIn : Where::kNear;
        destination = &phrase;
        break;
      }
  // Of two places the first says where it is: "put the cup on the counter in the sink".
  if (places_said > 1 && !(at_home_ && destination->joined))
    for (NounPhrase& phrase : clause.phrases)
      if (phrase.role == Role::kDestination && &phrase != destination) phrase.role = Role::kSource;

  if (destination == nullptr) return put_without_place(clause);
  if (clause.verb == "spread" || clause.verb == "distribute" || clause.verb == "scatter" ||
      clause.verb == "divide")
    for (NounPhrase& phrase : clause.phrases)
      if (phrase.role == Role::kDestination) phrase.all = true;
  if (thing == nullptr)
    return clause.frame == Frame::kBring || clause.frame == Frame::kTake || clause.verb == "move"
               ? go(clause)
               : "it is not clear what to put there";
  if (thing->scoop) return scoop(clause);
  if (at_home_ && !destination->pronoun && !destination->bare()) {
    const Objects into = resolver_.options(*destination, Sort::kMovable, now_);
    // "transfer what is in the mug to the glass"
    if (thing->everything && !thing->at.empty() && !thing->at.front().pronoun && !thing->at.front().bare() &&
        !into.empty() && resolver_.is_vessel(into.front()) &&
        !resolver_.options(thing->at.front(), Sort::kVessel, now_).empty()) {
      Clause poured = clause;
      poured.frame = Frame::kPour, poured.verb = "pour";
      return pour(poured);
    }
    // "chocolate sauce on the ice cream"
    const Objects bottle = thing->pronoun      ? pronoun(*thing, Sort::kMovable, into)
                           : thing->everything ? Objects{}
                                               : resolver_.options(*thing, Sort::kMovable, now_);
    if (!into.empty() && into.front() == resolver_.ice_cream() && !bottle.empty() &&
        now_.has(Relation::kIsSqueezeable, bottle.front()))
      return add_to(clause);
    if (thing->phrase == "bag" && !into.empty() && into.front() == kGarbageBin_1 &&
        resolver_.exists(kGarbageBag_1))
      for (NounPhrase& phrase : clause.phrases)  // "the bag goes in the bin"
        if (phrase.role == Role::kDirect) phrase.phrase = "garbage bag";
  }
  if (language_.tv_word(destination->phrase)) {
    const bool stays =
        at_home_ && (clause.verb == "leave" || clause.verb == "keep") && destination->number == 0;
    return stays ? Problem{} : television(clause);  // "leave it on this channel", "put the tv on channel 2"
  }
  if (language_.content(destination->phrase) == kIceCream && !thing->pronoun &&
      !resolver_.named(*thing).empty() && resolver_.named(*thing).front() == kSpoon_1)
    return scoop_into(kNone, 1);
  // "put a pot of water on the stove": it has none yet
  for (NounPhrase& phrase : clause.phrases) {
    if (phrase.role != Role::kDirect || phrase.content.empty()) continue;
    NounPhrase plain = phrase;
    plain.content.clear();
    const auto vessels = resolver_.options(plain, Sort::kVessel, now_);
    if (resolver_.options(phrase, Sort::kMovable, now_).empty() && !vessels.empty()) {
      if (const Problem problem = fill_one(vessels.front(), language_.content(phrase.content));
          !problem.empty())
        return problem;
    }
  }

  const auto vessels = destination->pronoun  ? pronoun(*destination, Sort::kPlace, {})
                       : destination->bare() ? Objects{}
                                             : resolver_.options(*destination, Sort::kPlace, now_);
  const bool into_dish =
      !vessels.empty() && (resolver_.is_vessel(vessels.front()) || resolver_.class_of(vessels.front())->dish);
  if (const auto content = put_content(clause, *thing, *destination, vessels)) {
    // "put the noodles into the kettle with some water"
    const NounPhrase* with = clause.first(Role::kWith);
    if (!content->empty() || with == nullptr || !into_dish) return *content;
    bool done = false;
    return add_content(*with, history_.empty() ? vessels.front() : history_.back().front(), done);
  }
  if (const auto on_each = put_on_each(clause)) return *on_each;
  // "a pillow on each couch": as many as there are couches; "two pillows on each couch": twice as many
  if (destination->all && !thing->pronoun && !thing->plural && thing->count < 2 && !thing->all &&
      vessels.size() > 1) {
    for (NounPhrase& phrase : clause.phrases)
      if (phrase.role == Role::kDirect) phrase.count = static_cast<int>(vessels.size());
  } else if (destination->all && !thing->pronoun && !thing->all && thing->count > 1 && vessels.size() > 1) {
    for (NounPhrase& phrase : clause.phrases)
      if (phrase.role == Role::kDirect) phrase.count *= static_cast<int>(vessels.size());
  }
  avoid_ = destination->pronoun || destination->bare() ? Objects{} : vessels;
  if (at_home_ && !avoid_.empty() && !thing->definite)  // nor one that another armchair would miss
    for (const Symbol place : resolver_.all(Sort::kPlace, now_))
      if (resolver_.class_of(place)->place && resolver_.class_of(place) == resolver_.class_of(avoid_.front()))
        avoid_.push_back(place);
  Problem problem;
  const auto objects = direct(clause, Sort::kMovable, problem);
  avoid_.clear();
  if (!problem.empty()) return problem;
  moves_ = clause.frame == Frame::kBring && objects.size() == 1;
  problem = put_at(clause, objects, *destination);
  moves_ = false;
  if (!problem.empty()) return problem;
  if (const NounPhrase* with = clause.first(Role::kWith);
      at_home_ && with != nullptr && !with->at.empty() && with->at.front().pronoun && !objects.empty())
    return put_with(*with, objects.front(), destination->where);
  if (const NounPhrase* with = clause.first(Role::kWith);
      with != nullptr && !last_destination_.empty() && into_dish) {
    bool done = false;
    return add_content(*with, last_destination_.front(), done);
  }
  return {};
}

}  // namespace goalnet::inference
