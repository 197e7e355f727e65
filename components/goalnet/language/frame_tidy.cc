// Clearing places, swapping, cooling, playing a game.
#include <algorithm>
#include <utility>

#include "components/goalnet/language/frame_actions.h"
#include "components/goalnet/language/symbol_list.h"

namespace goalnet::inference {

using namespace symbol;

std::string FrameActions::swap(const Clause& clause) {
  if (at_home_ && clause.has("channel")) return television(clause);  // "swap the channel to four"
  Problem problem;
  const Objects two = things_to_swap(clause, problem);
  if (!problem.empty()) return problem;
  if (two.size() != 2) return "two things are needed to " + clause.verb;
  const Symbol a = two[0], b = two[1], at_a = resolver_.place_of(a, now_), at_b = resolver_.place_of(b, now_);
  if (at_a == kNone || at_b == kNone) return "it is not known where both of them stand";
  const Where to_a = now_.has(Relation::kIn, a, at_a) ? Where::kIn : Where::kOn;
  const Where to_b = now_.has(Relation::kIn, b, at_b) ? Where::kIn : Where::kOn;
  // Where on a place things stand is not known: nothing would tell that they were swapped.
  if (at_a == at_b)
    return resolver_.name(a) + " and " + resolver_.name(b) + " are both at " + resolver_.name(at_a) +
           "; only things at two places can be swapped";
  remember(two);
  if (problem = act({Verb::kGrasp, a}); !problem.empty()) return problem;
  if (problem = keep(b, at_a, to_a); !problem.empty()) return problem;
  return keep(a, at_b, to_b);
}

FrameActions::Objects FrameActions::things_to_swap(const Clause& clause, Problem& problem) {
  Objects two;
  const NounPhrase* thing = clause.first(Role::kDirect);
  for (const NounPhrase& phrase : clause.phrases) {
    if (phrase.role != Role::kDestination) continue;
    if (at_home_ && phrase.joined && !lexicon_place(phrase))
      thing = &phrase;          // "the pillow on armchair 1 and the one on armchair 3"
    else if (thing != nullptr)  // "the pillows on armchair 1 and armchair 3"
      add_one_at(*thing, phrase, two);
  }
  // "switch the pillows on armchair 1 and armchair 2"
  if (const auto second = clause.phrases.size() > 1 ? clause.phrases[1] : NounPhrase{};
      two.empty() && thing != nullptr && !thing->at.empty() && second.role == Role::kDirect &&
      lexicon_place(second))
    for (const NounPhrase& place : {thing->at.front(), second}) add_one_at(*thing, place, two);
  if (at_home_ && two.size() == 1)  // "swap the bowl in the microwave for the mug"
    for (const Symbol other : role_objects(clause, Role::kWith, Sort::kMovable, problem))
      two.push_back(other);
  if (two.empty()) {
    two = direct(clause, Sort::kMovable, problem);
    const auto with = role_objects(clause, Role::kWith, Sort::kMovable, problem);
    two.insert(two.end(), with.begin(), with.end());
  }
  return two;
}

// The one of those things that is at that place.
void FrameActions::add_one_at(const NounPhrase& things, const NounPhrase& place, Objects& found) {
  NounPhrase one = things;
  one.plural = false, one.count = 0, one.all = false;
  one.at = {place};
  const auto there = resolver_.options(one, Sort::kMovable, now_);
  if (!there.empty()) found.push_back(there.front());
}

std::string FrameActions::clear(const Clause& clause) {
  const NounPhrase* place = clause.first(Role::kSource);
  const NounPhrase* thing = clause.first(Role::kDirect);
  const NounPhrase* to = clause.first(Role::kDestination);
  if (place == nullptr && thing != nullptr && thing->everything && to != nullptr && !clause.has("onto") &&
      !clause.has("into") && !clause.has("to"))
    place = std::exchange(to, nullptr);  // "clear the stuff on the sofa"
  // but for "the sofa with all that stuff on it"
  if (place == nullptr && thing != nullptr && !thing->at.empty() && !thing->at.front().everything)
    place = &thing->at.front();
  // "clear the coke and the salt away"
  if (place == nullptr && at_home_ && thing != nullptr && clause.has_particle("away") && !thing->pronoun &&
      !thing->bare() && !thing->everything && !lexicon_place(*thing)) {
    Clause put_away = clause;
    put_away.frame = Frame::kPlace, put_away.verb = "put";
    return put(put_away);
  }
  if (place == nullptr) place = thing;
  if (place == nullptr) return "it is not clear what to clear";
  auto options = place->pronoun ? pronoun(*place, Sort::kPlace, {})
                                : resolver_.chosen(*place, resolver_.options(*place, Sort::kPlace, now_));
  if (options.empty()) return unknown_thing(*place, Sort::kPlace);
  if (place->pronoun && place != thing && now_.has(Relation::kIsGraspable, options.front()))
    return "it is not clear where \"" + place->word + "\" is";  // "the mug is dirty, get it all off"
  const bool stove =
      resolver_.is_of_class(options.front(), "burner") && place->ordinal == 0 && place->number == 0;
  if (stove && !place->pronoun) options = resolver_.options(*place, Sort::kPlace, now_);
  if (std::ranges::any_of(options, [&](Symbol at) { return resolver_.is_vessel(at); })) {
    Clause emptied = clause;  // alone: the rest of the clause would lead back to here
    emptied.phrases = {*place};
    emptied.phrases.front().role = Role::kDirect;
    return empty(emptied);
  }
  const Objects there = things_to_clear(clause, options, place != thing);
  if (to != nullptr) return put(clause);
  const Symbol target = place_for_cleared(options);
  if (target == kNone)
    return "it is not clear where to put what is there; say for example \"put everything in the sink\"";
  for (const Symbol object : there)
    if (const Problem problem = keep(object, target, Where::kOn); !problem.empty()) return problem;
  remember(there);
  return {};
}

// What stands at the places; where things are named ("the books from the couch"), those.
FrameActions::Objects FrameActions::things_to_clear(const Clause& clause, const Objects& places,
                                                    bool things_named) {
  Objects there;
  for (const Symbol at : places)
    for (const Symbol object : resolver_.things_at(at, now_))
      if (now_.has(Relation::kIsGraspable, object)) there.push_back(object);
  const NounPhrase* thing = clause.first(Role::kDirect);
  if (things_named && thing != nullptr && !thing->everything && !thing->pronoun) {
    Objects meant;
    for (const NounPhrase& named : clause.phrases)
      if (named.role == Role::kDirect && !named.pronoun && !named.bare())
        for (const Symbol object : resolver_.options(named, Sort::kMovable, now_)) meant.push_back(object);
    std::erase_if(there, [&](Symbol object) { return !contains(meant, object); });
  }
  for (const NounPhrase& stays : clause.phrases)  // "clear the couch, only the snacks may stay"
    if (stays.role == Role::kExcept && !stays.pronoun && !stays.bare())
      for (const Symbol object : resolver_.options(stays, Sort::kMovable, now_)) std::erase(there, object);
  return there;
}

// The counter or the coffee table, else any other furniture; kNone: there is none but those places.
Symbol FrameActions::place_for_cleared(const Objects& places) const {
  if (const Symbol target = surface(); target != kNone && !contains(places, target)) return target;
  for (const SeenObject& other : resolver_.objects())
    if (resolver_.class_of(other.symbol)->place && !contains(places, other.symbol) &&
        other.symbol != kFridge && other.symbol != kMicrowave && other.symbol != kSink &&
        !now_.has(Relation::kIsGraspable, other.symbol) && !resolver_.is_of_class(other.symbol, "burner"))
      return other.symbol;
  return kNone;
}

std::string FrameActions::cool(const Clause& clause) {
  if (clause.has_particle("under_tap") && resolver_.exists(kSink)) return wash(clause);
  if (!resolver_.exists(kFridge)) return not_here("there is no fridge here");
  Problem problem;
  const auto objects = direct(clause, Sort::kMovable, problem);
  if (!problem.empty()) return problem;
  for (const Symbol object : objects) {
    const ObjectClass* c = resolver_.class_of(object);
    if (!c->food && !c->drink && !resolver_.is_vessel(object))
      return resolver_.name(object) + " is nothing to " + clause.verb;
    if (problem = keep(object, kFridge, Where::kIn); !problem.empty()) return problem;
  }
  last_destination_ = {Symbol{kFridge}};
  return {};
}

std::string FrameActions::play(const Clause& clause) {
  if (!resolver_.exists(resolver_.xbox())) return not_here("there is no console here to play on");
  Symbol disc = kNone;
  for (const NounPhrase& phrase : clause.phrases)
    if (!phrase.pronoun && !phrase.bare() && !phrase.everything)
      for (const Symbol option : resolver_.options(phrase, Sort::kMovable, now_))
        if (disc == kNone && resolver_.is_of_class(option, "cd")) disc = option;
  for (const SeenObject& object : resolver_.objects())
    if (disc == kNone && resolver_.is_of_class(object.symbol, "cd")) disc = object.symbol;
  if (disc == kNone) return not_here("there is no disc here to play");
  if (const Problem problem = turn_on(kTv_1, true, 0); !problem.empty()) return problem;
  return keep(disc, resolver_.xbox(), Where::kIn);
}

}  // namespace goalnet::inference
