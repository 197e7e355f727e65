// Putting things where nobody says: away, back, where they belong, on top of each other, a disc where discs
// go.
#include <algorithm>

#include "components/goalnet/language/frame_actions.h"
#include "components/goalnet/language/symbol_list.h"

namespace goalnet::inference {

using namespace symbol;

std::string FrameActions::put_without_place(const Clause& clause) {
  const NounPhrase* thing = clause.first(Role::kDirect);
  const bool on = clause.has_particle("on"), off = clause.has_particle("off");
  if (const bool out = clause.has_particle("out"); at_home_ && (off || out) && thing != nullptr) {
    // "put it out", "put out all the burners"
    const Objects devices = thing->pronoun ? pronoun(*thing, Sort::kDevice, {}) : Objects{};
    const auto burner = [&](Symbol object) { return resolver_.is_of_class(object, "burner"); };
    if (!devices.empty() ||
        (!thing->pronoun && !thing->bare() && std::ranges::any_of(resolver_.named(*thing), burner)))
      return turn(clause, 0);
  }
  if (on || off) {
    const bool burner = at_home_ && thing != nullptr && !thing->bare() &&
                        std::ranges::any_of(resolver_.named(*thing), [&](Symbol object) {
                          return resolver_.is_of_class(object, "burner");
                        });
    if (thing != nullptr && !thing->pronoun &&
        (burner || !resolver_.options(*thing, Sort::kDevice, now_).empty()))
      return turn(clause, on ? 1 : 0);
    if (on && thing != nullptr &&
        resolver_.is_of_class(
            resolver_.named(*thing).empty() ? Symbol{kNone} : resolver_.named(*thing).front(), "kettle"))
      return heat(clause, true);  // "put the kettle on"
    if (const Objects that = on && at_home_ && thing != nullptr && thing->pronoun
                                 ? pronoun(*thing, Sort::kMovable, {})
                                 : Objects{};
        !that.empty() && resolver_.is_of_class(that.front(), "kettle"))
      return heat(clause, true);  // "fill the kettle and put it on"
  }
  if (clause.has_particle("under_tap")) {  // "put the glass under the tap"
    Problem problem;
    const auto objects = direct(clause, Sort::kMovable, problem);
    if (!problem.empty()) return problem;
    if (!resolver_.exists(kSink)) return not_here("there is no tap here");
    for (const Symbol object : objects)
      if (problem = keep(object, kSink, Where::kOn); !problem.empty()) return problem;
    return {};
  }
  if (clause.has_particle("in") && thing != nullptr && !thing->pronoun && !thing->bare()) {  // "disc in"
    const auto discs = resolver_.options(*thing, Sort::kMovable, now_);
    if (!discs.empty() && resolver_.is_of_class(discs.front(), "cd")) return insert(clause);
  }
  // "water in": into what was spoken of last
  if ((clause.has_particle("in") || clause.has_particle("into")) && thing != nullptr &&
      clause.verb == "put" && !history_.empty()) {
    Clause inside = clause;
    inside.phrases.push_back(it());
    inside.phrases.back().role = Role::kDestination, inside.phrases.back().where = Where::kIn;
    return put(inside);
  }
  if (clause.verb == "keep" && at_home_ && !clause.to_person && thing != nullptr &&
      clause.particles.empty()) {
    notice(clause);  // "keep the beer"
    return {};
  }
  if (at_home_ && !clause.to_person && clause.particles.empty() &&
      (clause.verb == "sling" || clause.verb == "fling" || clause.verb == "lob" || clause.verb == "bung"))
    return discard(clause);
  if (clause.verb == "shelve" && thing != nullptr) {
    Clause shelved = clause;
    shelved.phrases.emplace_back();
    NounPhrase& shelf = shelved.phrases.back();
    shelf.role = Role::kDestination, shelf.where = Where::kOn, shelf.phrase = shelf.word = "shelf";
    return put(shelved);
  }
  if (clause.verb == "tidy" && thing != nullptr && lexicon_place(*thing)) return clear(clause);
  // "leave the books": nothing is to be done with them
  if (clause.verb == "leave" && !clause.to_person && thing != nullptr && !clause.has_particle("at_home")) {
    notice(clause);
    return {};
  }
  if (clause.verb == "drop" || (clause.has_particle("down") && !clause.has_particle("at_home")))
    return release(clause);
  const bool home = clause.has_particle("at_home"),
             back = clause.has_particle("back") || clause.verb == "return";
  const bool away = clause.has_particle("away") || clause.verb == "store" || clause.verb == "stow";
  if ((clause.frame == Frame::kBring || clause.to_person) && !home && !back && !away) return take(clause);
  // "take the coffee, put a bit of ice cream and syrup": into that
  if (at_home_ && !home && !back && !away && thing != nullptr && !thing->pronoun && !thing->bare() &&
      (thing->some || language_.content(thing->phrase) == kIceCream) && clause.verb != "load" &&
      !pronoun(it(), Sort::kVessel, {}).empty()) {
    Clause added = clause;
    added.frame = Frame::kAdd, added.verb = "add";
    return add_to(added);
  }
  if (!home && !back && !away && thing != nullptr && thing->on_floor)
    return "nothing is put on the floor here; say which table, shelf or counter";
  Problem problem;
  const auto objects = direct(clause, Sort::kMovable, problem);
  if (!problem.empty()) return problem;
  if (!home && !back && !away) {
    if (clause.verb == "load" && resolver_.is_of_class(objects.front(), "cd") &&
        resolver_.exists(resolver_.xbox()))
      return keep(objects.front(), resolver_.xbox(), Where::kIn);
    if (clause.verb == "stack" || clause.verb == "pile") return stack(objects);
    return "it is not clear where to put " + resolver_.name(objects.front());
  }
  for (const Symbol object : objects) {
    const Symbol was = back && !home ? resolver_.place_of(object, start_) : Symbol{kNone};
    const Symbol place = was != kNone ? was : home_of(object);
    if (place == kNone)
      return back ? "it is not known where " + resolver_.name(object) + " was"
                  : "it is not clear where to put " + resolver_.name(object) + " away";
    // several places are a home ("the shelves"): where it stands on one of them it may stay
    if (was == kNone && is_home(object, resolver_.place_of(object, now_))) continue;
    const bool inside =
        was != kNone ? start_.has(Relation::kIn, object, was) : place == kFridge || place == kGarbageBin_1;
    if (problem = keep(object, place, inside ? Where::kIn : Where::kOn); !problem.empty()) return problem;
  }
  return {};
}

bool FrameActions::lexicon_place(const NounPhrase& phrase) {
  if (phrase.pronoun || phrase.bare() || phrase.everything) return false;
  const auto places = resolver_.options(phrase, Sort::kPlace, now_);
  return !places.empty() && resolver_.class_of(places.front())->place &&
         !now_.has(Relation::kIsGraspable, places.front());
}

// "stack the plates": each on the one before.
std::string FrameActions::stack(const Objects& objects) {
  if (objects.size() < 2) return "it is not clear what to put " + resolver_.name(objects.front()) + " on";
  for (std::size_t i = 1; i < objects.size(); ++i)
    if (const Problem problem = keep(objects[i], objects[i - 1], Where::kOn); !problem.empty())
      return problem;
  return {};
}

bool FrameActions::is_home(Symbol object, Symbol place) const {
  const ObjectClass* c = resolver_.class_of(object);
  for (const std::string& home : language_.homes(c->name))
    if (place != kNone && resolver_.is_of_class(place, home)) return true;
  return false;
}

std::string FrameActions::insert(const Clause& clause) {
  Problem problem;
  const auto objects = direct(clause, Sort::kMovable, problem);
  const NounPhrase* destination = clause.first(Role::kDestination);
  if (!problem.empty()) return problem;
  if (destination == nullptr) {
    if (resolver_.is_of_class(objects.front(), "cd") && resolver_.exists(resolver_.xbox())) {
      for (const Symbol object : objects)
        if (problem = keep(object, resolver_.xbox(), Where::kIn); !problem.empty()) return problem;
      return {};
    }
    // "feed the xbox a disc"
    if (objects.size() == 2 && objects.front() == resolver_.xbox() && at_home_)
      return keep(objects[1], objects[0], Where::kIn);
    // "open the microwave, insert the mug"
    if (const Objects open = at_home_ ? pronoun(it(), Sort::kPlace, objects) : Objects{};
        !open.empty() && (open.front() == kMicrowave || open.front() == kFridge)) {
      for (const Symbol object : objects)
        if (problem = keep(object, open.front(), Where::kIn); !problem.empty()) return problem;
      return {};
    }
    return "it is not clear where to " + clause.verb + " it";
  }
  NounPhrase inside = *destination;
  inside.where = Where::kIn;
  return put_at(clause, objects, inside);
}

// Where things of its kind belong, by config/language/english.json; the first such place that is here.
Symbol FrameActions::home_of(Symbol object) const {
  const ObjectClass* c = resolver_.class_of(object);
  for (const std::string& home : language_.homes(c->name))
    for (const SeenObject& place : resolver_.objects())
      if (place.symbol != object && resolver_.is_of_class(place.symbol, home)) return place.symbol;
  return kNone;
}

// "It".
NounPhrase FrameActions::it() {
  NounPhrase phrase;
  phrase.pronoun = true, phrase.word = "it";
  return phrase;
}

}  // namespace goalnet::inference
