// Putting where no place is said: on and off, under the tap, in what was spoken of, down, nowhere.
#include <algorithm>

#include "components/goalnet/language/frame_actions.h"
#include "components/goalnet/language/symbol_list.h"

namespace goalnet::inference {

using namespace symbol;

std::string FrameActions::put_without_place(const Clause& clause) {
  static constexpr Reading kReadings[] = {
      &FrameActions::put_out,          // "put out all the burners"
      &FrameActions::put_device_on,    // "put the tv on"
      &FrameActions::put_kettle_on,    // "put the kettle on"
      &FrameActions::put_under_tap,    // "put the glass under the tap"
      &FrameActions::put_disc_in,      // "disc in"
      &FrameActions::put_into_last,    // "water in"
      &FrameActions::keep_as_it_is,    // "keep the beer"
      &FrameActions::fling,            // "bung the can"
      &FrameActions::shelve,           // "shelve the books"
      &FrameActions::tidy_place,       // "tidy the counter"
      &FrameActions::leave_as_it_is,   // "leave the books"
      &FrameActions::put_down,         // "put the mug down"
      &FrameActions::bring_to_person,  // "bring me the mug"
      &FrameActions::put_some_on_last  // "take the coffee, put a bit of ice cream and syrup"
  };
  if (const auto read = first_that_fits(kReadings, clause)) return *read;
  if (const NounPhrase* thing = clause.first(Role::kDirect);
      !says_away(clause) && thing != nullptr && thing->on_floor)
    return "nothing is put on the floor here; say which table, shelf or counter";
  return put_away(clause);
}

// "put it out", "put out all the burners"
std::optional<std::string> FrameActions::put_out(const Clause& clause) {
  const NounPhrase* thing = clause.first(Role::kDirect);
  if (!at_home_ || thing == nullptr || (!clause.has_particle("off") && !clause.has_particle("out")))
    return std::nullopt;
  const Objects devices = thing->pronoun ? pronoun(*thing, Sort::kDevice, {}) : Objects{};
  if (devices.empty() && !names_burner(*thing)) return std::nullopt;
  return turn(clause, 0);
}

bool FrameActions::names_burner(const NounPhrase& phrase) const {
  return !phrase.pronoun && !phrase.bare() &&
         std::ranges::any_of(resolver_.named(phrase),
                             [&](Symbol object) { return resolver_.is_of_class(object, "burner"); });
}

// "put the tv on", "put the burner off"
std::optional<std::string> FrameActions::put_device_on(const Clause& clause) {
  const NounPhrase* thing = clause.first(Role::kDirect);
  const bool on = clause.has_particle("on");
  if ((!on && !clause.has_particle("off")) || thing == nullptr || thing->pronoun) return std::nullopt;
  const bool burner = at_home_ && names_burner(*thing);
  if (!burner && resolver_.options(*thing, Sort::kDevice, now_).empty()) return std::nullopt;
  return turn(clause, on ? 1 : 0);
}

// "put the kettle on", "fill the kettle and put it on"
std::optional<std::string> FrameActions::put_kettle_on(const Clause& clause) {
  const NounPhrase* thing = clause.first(Role::kDirect);
  if (!clause.has_particle("on") || thing == nullptr) return std::nullopt;
  const auto kettle = [&](const Objects& objects) {
    return !objects.empty() && resolver_.is_of_class(objects.front(), "kettle");
  };
  if (kettle(resolver_.named(*thing))) return heat(clause, true);
  if (at_home_ && thing->pronoun && kettle(pronoun(*thing, Sort::kMovable, {}))) return heat(clause, true);
  return std::nullopt;
}

// "put the glass under the tap"
std::optional<std::string> FrameActions::put_under_tap(const Clause& clause) {
  if (!clause.has_particle("under_tap")) return std::nullopt;
  Problem problem;
  const auto objects = direct(clause, Sort::kMovable, problem);
  if (!problem.empty()) return problem;
  if (!resolver_.exists(kSink)) return not_here("there is no tap here");
  for (const Symbol object : objects)
    if (problem = keep(object, kSink, Where::kOn); !problem.empty()) return problem;
  return Problem{};
}

// "disc in"
std::optional<std::string> FrameActions::put_disc_in(const Clause& clause) {
  const NounPhrase* thing = clause.first(Role::kDirect);
  if (!clause.has_particle("in") || thing == nullptr || thing->pronoun || thing->bare()) return std::nullopt;
  const auto discs = resolver_.options(*thing, Sort::kMovable, now_);
  if (discs.empty() || !resolver_.is_of_class(discs.front(), "cd")) return std::nullopt;
  return insert(clause);
}

// "water in": into what was spoken of last
std::optional<std::string> FrameActions::put_into_last(const Clause& clause) {
  if ((!clause.has_particle("in") && !clause.has_particle("into")) ||
      clause.first(Role::kDirect) == nullptr || clause.verb != "put" || history_.empty())
    return std::nullopt;
  Clause inside = clause;
  inside.phrases.push_back(it());
  inside.phrases.back().role = Role::kDestination, inside.phrases.back().where = Where::kIn;
  return put(inside);
}

// "keep the beer"
std::optional<std::string> FrameActions::keep_as_it_is(const Clause& clause) {
  if (clause.verb != "keep" || !at_home_ || clause.to_person || clause.first(Role::kDirect) == nullptr ||
      !clause.particles.empty())
    return std::nullopt;
  notice(clause);
  return Problem{};
}

// "sling the can": away
std::optional<std::string> FrameActions::fling(const Clause& clause) {
  if (!at_home_ || clause.to_person || !clause.particles.empty() ||
      (clause.verb != "sling" && clause.verb != "fling" && clause.verb != "lob" && clause.verb != "bung"))
    return std::nullopt;
  return discard(clause);
}

std::optional<std::string> FrameActions::shelve(const Clause& clause) {
  if (clause.verb != "shelve" || clause.first(Role::kDirect) == nullptr) return std::nullopt;
  Clause shelved = clause;
  shelved.phrases.emplace_back();
  NounPhrase& shelf = shelved.phrases.back();
  shelf.role = Role::kDestination, shelf.where = Where::kOn, shelf.phrase = shelf.word = "shelf";
  return put(shelved);
}

std::optional<std::string> FrameActions::tidy_place(const Clause& clause) {
  const NounPhrase* thing = clause.first(Role::kDirect);
  if (clause.verb != "tidy" || thing == nullptr || !lexicon_place(*thing)) return std::nullopt;
  return this->clear(clause);
}

// "leave the books": nothing is to be done with them
std::optional<std::string> FrameActions::leave_as_it_is(const Clause& clause) {
  if (clause.verb != "leave" || clause.to_person || clause.first(Role::kDirect) == nullptr ||
      clause.has_particle("at_home"))
    return std::nullopt;
  notice(clause);
  return Problem{};
}

std::optional<std::string> FrameActions::put_down(const Clause& clause) {
  if (clause.verb != "drop" && (!clause.has_particle("down") || clause.has_particle("at_home")))
    return std::nullopt;
  return release(clause);
}

std::optional<std::string> FrameActions::bring_to_person(const Clause& clause) {
  if ((clause.frame != Frame::kBring && !clause.to_person) || says_away(clause)) return std::nullopt;
  return take(clause);
}

// "take the coffee, put a bit of ice cream and syrup": into that
std::optional<std::string> FrameActions::put_some_on_last(const Clause& clause) {
  const NounPhrase* thing = clause.first(Role::kDirect);
  if (!at_home_ || says_away(clause) || thing == nullptr || thing->pronoun || thing->bare() ||
      (!thing->some && language_.content(thing->phrase) != kIceCream) || clause.verb == "load" ||
      pronoun(it(), Sort::kVessel, {}).empty())
    return std::nullopt;
  Clause added = clause;
  added.frame = Frame::kAdd, added.verb = "add";
  return add_to(added);
}

}  // namespace goalnet::inference
