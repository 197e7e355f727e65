// Putting things somewhere: the order in which what a clause says is tried. What it says of its things is
// mended before, in frame_put_roles.cc.
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
  if (const auto fetched = fetch_the_one_there(said)) return *fetched;
  Clause clause = said;
  move_what_is_joined(clause);
  part_thing_from_place(clause);
  load_place_with_thing(clause);
  if (clause.has_particle("to_boil")) return heat(clause, true);  // "bring the water to the boil"
  if (const auto inserted = put_in_what_is_named(clause)) return *inserted;
  put_what_is_unsaid(clause);
  const NounPhrase* destination = destination_of(clause);
  if (destination == nullptr) return put_without_place(clause);
  if (clause.verb == "spread" || clause.verb == "distribute" || clause.verb == "scatter" ||
      clause.verb == "divide")
    for (NounPhrase& phrase : clause.phrases)
      if (phrase.role == Role::kDestination) phrase.all = true;
  return put_there(clause, *destination);
}

// "bring the book on the shelf": where one is on the shelf, that says which
std::optional<std::string> FrameActions::fetch_the_one_there(const Clause& clause) {
  const NounPhrase *thing = clause.first(Role::kDirect), *place = clause.first(Role::kDestination);
  if (!at_home_ || clause.frame != Frame::kBring || (clause.verb != "bring" && clause.verb != "fetch") ||
      clause.phrases.size() != 2 || thing == nullptr || place == nullptr || !clause.particles.empty())
    return std::nullopt;
  if (thing->pronoun || thing->bare() || thing->everything || thing->has("other") || thing->rest)
    return std::nullopt;
  if (place->pronoun || place->bare() || place->has("other") ||
      (place->where != Where::kOn && place->where != Where::kIn) || clause.has("onto") ||
      clause.has("into") || clause.has("a") || clause.has("another"))
    return std::nullopt;
  NounPhrase located = *thing;
  located.at.push_back(*place);
  const int loose = resolver_.doubts().loose;
  const auto there = resolver_.options(located, Sort::kMovable, now_);
  const bool which = !there.empty() && resolver_.doubts().loose == loose;
  resolver_.doubts().loose = loose;
  if (!which) return std::nullopt;
  Clause fetched = clause;
  fetched.phrases = {located};
  fetched.frame = Frame::kTake, fetched.to_person = true;
  return take(fetched);
}

// What is put, and how, where the place is said.
std::string FrameActions::put_there(Clause& clause, const NounPhrase& destination) {
  const NounPhrase* thing = clause.first(Role::kDirect);
  if (thing == nullptr)
    return clause.frame == Frame::kBring || clause.frame == Frame::kTake || clause.verb == "move"
               ? go(clause)
               : "it is not clear what to put there";
  if (thing->scoop) return scoop(clause);
  if (at_home_ && !destination.pronoun && !destination.bare()) {
    const Objects into = resolver_.options(destination, Sort::kMovable, now_);
    if (const auto poured = pour_what_is_in(clause, *thing, into)) return *poured;
    if (const auto squeezed = squeeze_on_ice_cream(clause, *thing, into)) return *squeezed;
    bag_for_the_bin(clause, *thing, into);
  }
  if (language_.tv_word(destination.phrase)) {
    const bool stays =
        at_home_ && (clause.verb == "leave" || clause.verb == "keep") && destination.number == 0;
    return stays ? Problem{} : television(clause);  // "leave it on this channel", "put the tv on channel 2"
  }
  // "spoon in the ice cream"
  if (language_.content(destination.phrase) == kIceCream && !thing->pronoun &&
      !resolver_.named(*thing).empty() && resolver_.named(*thing).front() == kSpoon_1)
    return scoop_into(kNone, 1);
  if (const Problem problem = fill_what_is_put(clause); !problem.empty()) return problem;

  const auto vessels = meant_by(destination, Sort::kPlace);
  const bool into_dish = !vessels.empty() && is_vessel_or_dish(vessels.front());
  if (const auto content = put_content(clause, *thing, destination, vessels)) {
    // "put the noodles into the kettle with some water"
    const NounPhrase* with = clause.first(Role::kWith);
    if (!content->empty() || with == nullptr || !into_dish) return *content;
    bool done = false;
    return add_content(*with, history_.empty() ? vessels.front() : history_.back().front(), done);
  }
  if (const auto on_each = put_on_each(clause)) return *on_each;
  count_for_each_place(clause, *thing, destination, vessels.size());
  return put_things(clause, *thing, destination, vessels);
}

// "transfer what is in the mug to the glass"
std::optional<std::string> FrameActions::pour_what_is_in(const Clause& clause, const NounPhrase& thing,
                                                         const Objects& into) {
  if (!thing.everything || thing.at.empty() || thing.at.front().pronoun || thing.at.front().bare() ||
      into.empty() || !resolver_.is_vessel(into.front()) ||
      resolver_.options(thing.at.front(), Sort::kVessel, now_).empty())
    return std::nullopt;
  Clause poured = clause;
  poured.frame = Frame::kPour, poured.verb = "pour";
  return pour(poured);
}

// "chocolate sauce on the ice cream"
std::optional<std::string> FrameActions::squeeze_on_ice_cream(const Clause& clause, const NounPhrase& thing,
                                                              const Objects& into) {
  const Objects bottle = thing.pronoun      ? pronoun(thing, Sort::kMovable, into)
                         : thing.everything ? Objects{}
                                            : resolver_.options(thing, Sort::kMovable, now_);
  if (into.empty() || into.front() != resolver_.ice_cream() || bottle.empty() ||
      !now_.has(Relation::kIsSqueezeable, bottle.front()))
    return std::nullopt;
  return add_to(clause);
}

// "the bag goes in the bin": the one for rubbish
void FrameActions::bag_for_the_bin(Clause& clause, const NounPhrase& thing, const Objects& into) const {
  if (thing.phrase != "bag" || into.empty() || into.front() != kGarbageBin_1 ||
      !resolver_.exists(kGarbageBag_1))
    return;
  for (NounPhrase& phrase : clause.phrases)
    if (phrase.role == Role::kDirect) phrase.phrase = "garbage bag";
}

// "put a pot of water on the stove": it has none yet
std::string FrameActions::fill_what_is_put(const Clause& clause) {
  for (const NounPhrase& phrase : clause.phrases) {
    if (phrase.role != Role::kDirect || phrase.content.empty()) continue;
    NounPhrase plain = phrase;
    plain.content.clear();
    const auto vessels = resolver_.options(plain, Sort::kVessel, now_);
    if (!resolver_.options(phrase, Sort::kMovable, now_).empty() || vessels.empty()) continue;
    if (const Problem problem = fill_one(vessels.front(), language_.content(phrase.content));
        !problem.empty())
      return problem;
  }
  return {};
}

// "a pillow on each couch": as many as there are couches; "two pillows on each couch": twice as many
void FrameActions::count_for_each_place(Clause& clause, const NounPhrase& thing,
                                        const NounPhrase& destination, std::size_t places) {
  if (!destination.all || thing.pronoun || thing.all || places < 2) return;
  const bool several = thing.count > 1;
  if (!several && thing.plural) return;
  for (NounPhrase& phrase : clause.phrases)
    if (phrase.role == Role::kDirect) phrase.count = static_cast<int>(places) * (several ? phrase.count : 1);
}

// Things are carried to the place, and with them what is to go along.
std::string FrameActions::put_things(const Clause& clause, const NounPhrase& thing,
                                     const NounPhrase& destination, const Objects& places) {
  avoid_ = destination.pronoun || destination.bare() ? Objects{} : places;
  if (at_home_ && !avoid_.empty() && !thing.definite)  // nor one that another armchair would miss
    for (const Symbol place : resolver_.all(Sort::kPlace, now_))
      if (resolver_.class_of(place)->place && resolver_.class_of(place) == resolver_.class_of(avoid_.front()))
        avoid_.push_back(place);
  Problem problem;
  const auto objects = direct(clause, Sort::kMovable, problem);
  avoid_.clear();
  if (!problem.empty()) return problem;
  moves_ = clause.frame == Frame::kBring && objects.size() == 1;
  problem = put_at(clause, objects, destination);
  moves_ = false;
  const NounPhrase* with = clause.first(Role::kWith);
  if (!problem.empty() || with == nullptr) return problem;
  if (at_home_ && !with->at.empty() && with->at.front().pronoun && !objects.empty())
    return put_with(*with, objects.front(), destination.where);
  const bool into_dish = !places.empty() && is_vessel_or_dish(places.front());
  if (last_destination_.empty() || !into_dish) return {};
  bool done = false;
  return add_content(*with, last_destination_.front(), done);
}

}  // namespace goalnet::inference
