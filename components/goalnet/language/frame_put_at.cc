// Where exactly things are put: beside something, one on each of several places, into what takes them in its
// own way.
#include <algorithm>

#include "components/goalnet/language/frame_actions.h"
#include "components/goalnet/language/symbol_list.h"

namespace goalnet::inference {

using namespace symbol;

// "put a pillow on armchair 4 and the couch": another one on each; nothing where it is not that.
std::optional<std::string> FrameActions::put_on_each(const Clause& clause) {
  std::vector<NounPhrase> places;
  std::size_t joined = 0;
  for (const NounPhrase& phrase : clause.phrases)
    if (phrase.role == Role::kDestination) places.push_back(phrase), joined += phrase.joined;
  const NounPhrase* thing = clause.first(Role::kDirect);
  if (!at_home_ || places.size() < 2 || joined + 1 != places.size() || thing == nullptr || thing->pronoun ||
      thing->bare() || thing->plural || thing->all || thing->everything || thing->count > 1 ||
      resolver_.options(*thing, Sort::kMovable, now_).size() < places.size())
    return std::nullopt;
  for (const NounPhrase& place : places)
    if (place.pronoun || place.bare() || !lexicon_place(place)) return std::nullopt;
  for (std::size_t i = 0; i < places.size(); ++i) {
    Clause one = clause;
    std::erase_if(one.phrases, [](const NounPhrase& phrase) { return phrase.role == Role::kDestination; });
    for (NounPhrase& phrase : one.phrases)
      if (i > 0 && phrase.role == Role::kDirect) phrase.adjectives.emplace_back("other");
    one.phrases.push_back(places[i]);
    one.phrases.back().joined = false;
    if (Problem problem = put(one); !problem.empty()) return problem;
  }
  return Problem{};
}

// "take the pot and put on the stove", "drop near tv", "place on shelf with the cd": what is put is what was
// spoken of, else what is held.
void FrameActions::put_what_is_unsaid(Clause& clause) {
  if (!at_home_ || clause.frame != Frame::kPlace || clause.verb == "move" || clause.verb == "leave" ||
      clause.verb == "keep" || clause.weak)
    return;
  const NounPhrase what = unsaid();
  const bool known = !pronoun(what, Sort::kMovable, {}).empty();
  // read as "put on the couch", like "put on the tv"
  // or "put burner 1"
  const bool bare = known && clause.particles.empty() && clause.phrases.size() == 1;
  if (clause.phrases.size() <= 2 && (clause.has_particle("on") || bare) &&
      clause.first(Role::kDirect) != nullptr && clause.first(Role::kDestination) == nullptr) {
    NounPhrase& place = clause.phrases.front();
    const Objects named =
        place.bare() || place.pronoun || place.everything ? Objects{} : resolver_.named(place);
    if (place.role != Role::kDirect || named.empty()) return;
    const bool device = contains(resolver_.all(Sort::kDevice, now_), named.front());
    const bool cooks =
        is_switched(named.front()) && named.front() != kTv_1 && !pronoun(what, Sort::kVessel, {}).empty();
    const bool dish = known && resolver_.class_of(named.front())->dish;
    if ((!lexicon_place(place) && !dish) || (device && !cooks)) return;
    place.role = Role::kDestination, place.where = Where::kOn;
    std::erase(clause.particles, "on");
    // "on the shelf with the cd": where that is
    const bool with = clause.phrases.size() == 2 && clause.phrases.back().role == Role::kWith;
    const Objects beside = with ? resolver_.options(clause.phrases.back(), Sort::kMovable, now_) : Objects{};
    if (!beside.empty() && contains(named, resolver_.place_of(beside.front(), now_))) {
      clause.phrases.erase(clause.phrases.begin());
      clause.phrases.back().role = Role::kDestination, clause.phrases.back().where = Where::kNear;
    }
  }
  if (known && clause.first(Role::kDirect) == nullptr && clause.first(Role::kDestination) != nullptr)
    clause.phrases.insert(clause.phrases.begin(), what);
}

// "put the plate on the table, with the beer beside it"
std::string FrameActions::put_with(const NounPhrase& with, Symbol object, Where where) {
  const NounPhrase& it = with.at.front();
  const bool on_it = it.where == Where::kOn || it.where == Where::kIn;
  NounPhrase plain = with;
  plain.at.clear();
  const Objects more = resolver_.chosen(with, resolver_.options(plain, Sort::kMovable, now_));
  const Symbol target = on_it ? object : resolver_.place_of(object, now_);
  if (more.empty()) return unknown_thing(with, Sort::kMovable);
  if (target == kNone) return "it is not clear where to put " + with.word;
  for (const Symbol other : more)
    if (const Problem problem = keep(other, target, on_it ? it.where : where); !problem.empty())
      return problem;
  return {};
}

// Contents are poured, shaken or scooped; only vessels are carried. Nothing where no content is meant.
std::optional<std::string> FrameActions::put_content(const Clause& clause, const NounPhrase& thing,
                                                     const NounPhrase& destination, const Objects& vessels) {
  const Symbol content = thing.pronoun ? Symbol{kNone} : language_.content(thing.phrase);
  const bool into_dish = !vessels.empty() && is_vessel_or_dish(vessels.front());
  const bool inside = destination.where != Where::kOn && destination.where != Where::kNear;
  if (at_home_ && destination.where == Where::kNear) return std::nullopt;  // "salt goes next to the kettle"
  if (content != kNone && into_dish && thing.content.empty()) {
    // "I want boiling water in the kettle": where none is hot yet it is heated there
    if (content == kWater && (thing.has("boiling") || thing.has("hot")) &&
        resolver_.is_vessel(vessels.front())) {
      const Symbol has = vessel_with(kWater);
      if (has == kNone || !now_.is(has, ktemperatureHigh)) return heat(clause, false);
    }
    if (content == kWater || content == kCoffee) return pour(clause);
    if (content == kIceCream) return scoop(clause);
    // "serve coke in a glass": a can does not go into a glass, what it holds does
    if (is_canned_drink(content) && inside) return pour(clause);
    if (at_home_ && is_canned_drink(content) && clause.first(Role::kSource) != nullptr) return pour(clause);
    if (content == kSalt || content == kChocolate || content == kVanilla || content == kRamen ||
        content == kEgg || thing.some) {
      Clause only = clause;
      std::erase_if(only.phrases, [](const NounPhrase& phrase) { return phrase.role == Role::kWith; });
      return add_to(only);
    }
  }
  if (content == kWater && !into_dish && vessel_with(kWater) == kNone) {
    if (!vessels.empty() && vessels.front() == kSink)
      return turn_on(kSinkKnob, true, 0);  // "let water into the sink"
    if (vessels.empty() || resolver_.is_of_class(vessels.front(), "burner")) return heat(clause, true);
  }
  // "serve the ginger ale in the glass": what a can holds, not the can
  if (into_dish && content == kNone && !thing.pronoun && !thing.bare() && !thing.everything && inside) {
    const auto cans = resolver_.options(thing, Sort::kVessel, now_);
    if (!cans.empty() && resolver_.class_of(cans.front())->drink &&
        std::any_of(now_.facts().begin(), now_.facts().end(), [&](SymFact fact) {
          return relation_of(fact) == Relation::kState && subject_of(fact) == cans.front() &&
                 object_of(fact) >= kWater && object_of(fact) <= kSalt;
        }))
      return pour(clause);
  }
  return std::nullopt;
}

std::string FrameActions::put_at(const Clause& clause, const Objects& objects,
                                 const NounPhrase& destination) {
  Problem problem;
  Where where = destination.where;
  const Objects targets = where == Where::kNear ? beside(destination, objects, where, problem)
                                                : places(destination, objects, objects.size(), problem);
  if (!problem.empty()) return problem;
  if (where == Where::kUnder && targets.front() != kSink)
    return "things cannot be put under " + resolver_.name(targets.front());
  if (destination.pronoun && destination.word != "there" && where == Where::kTo) where = Where::kOn;
  // Where the place is not said exactly, what is there already may stay.
  Objects all = destination.pronoun ? targets : resolver_.options(destination, Sort::kPlace, now_);
  if (destination.ordinal > 0 || destination.number > 0 || where == Where::kNear ||
      (at_home_ && (destination.has("other") || destination.has("different") || destination.has("same") ||
                    destination.count == 1)))
    all = targets;
  const bool one_each = destination.all && objects.size() <= targets.size();
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const Symbol object = objects[i];
    Symbol target = targets[i % targets.size()];
    if (!one_each && objects.size() > 1 && !clause.has("one") &&
        contains(all, resolver_.place_of(object, now_)))
      continue;
    if (!destination.all && destination.count < 2) {
      target = targets.front();
      // several things, one burner each
      if (objects.size() > 1 && resolver_.is_of_class(target, "burner")) target = burner_for(object);
    }
    if (problem = put_one(object, target, where); !problem.empty()) return problem;
  }
  last_destination_ = {targets.front()};
  resolver_.remember(targets.size() > 1 && !destination.all ? Objects{targets.front()}
                                                            : targets);  // "the other couch"
  history_.insert(history_.end() - static_cast<long>(history_.empty() ? 0 : 1), last_destination_);
  return {};
}

// Salt is shaken and syrup squeezed into what takes it, of ice cream a scoop is put there.
std::string FrameActions::put_one(Symbol object, Symbol target, Where where) {
  const bool holder = is_vessel_or_dish(target);
  if (object == kSalt_1 && holder) return act({Verb::kAdd, object, target});
  if (now_.has(Relation::kIsSqueezeable, object) && holder) return act({Verb::kSqueeze, object, target});
  // "take the ice cream and put it on top of the coffee"
  if (at_home_ && object == resolver_.ice_cream() && holder) return scoop_into(target, 1);
  return keep(object, target, where);
}

// Beside a thing: on what it stands on (`where`: or in it); beside a fixture: on the counter.
FrameActions::Objects FrameActions::beside(const NounPhrase& destination, const Objects& objects,
                                           Where& where, Problem& problem) {
  Objects neighbours = destination.pronoun ? pronoun(destination, Sort::kAny, objects) : Objects{};
  if (!destination.pronoun && !destination.bare())
    neighbours = resolver_.options(destination, Sort::kAny, now_);
  std::erase_if(neighbours, [&](Symbol object) { return contains(objects, object); });
  if (neighbours.empty()) {
    problem = unknown_thing(destination, Sort::kAny);
    return {};
  }
  const Symbol neighbour = neighbours.front();
  Symbol support = resolver_.place_of(neighbour, now_);
  const bool fixture = neighbour == kSink || neighbour == kSinkKnob || neighbour == kStove ||
                       neighbour == kMicrowave || neighbour == kFridge;
  if (support == kNone && neighbour == kTv_1) support = first_of_class("shelf");  // it hangs between shelves
  if (support == kNone && (fixture || now_.has(Relation::kIsGraspable, neighbour))) support = surface();
  if (support == kNone)
    problem = "there is nothing beside " + resolver_.name(neighbour) + " to put things on";
  where = now_.has(Relation::kIn, neighbour, support) ? Where::kIn : Where::kOn;
  return {support};
}

}  // namespace goalnet::inference
