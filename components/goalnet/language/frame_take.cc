// Going to things, taking them.
#include <algorithm>

#include "components/goalnet/language/frame_actions.h"
#include "components/goalnet/language/symbol_list.h"

namespace goalnet::inference {

using namespace symbol;

std::string FrameActions::go(const Clause& clause) {
  if (clause.has("channel")) return television(clause);
  if (const NounPhrase* with = clause.first(Role::kWith); with != nullptr && clause.to_person &&
                                                          !with->bare() &&
                                                          !with->unknown) {  // "come here with the remote"
    Clause bring = clause;
    bring.phrases = {*with};
    bring.phrases.front().role = Role::kDirect;
    return take(bring);
  }
  // "stand the bowl on the plate"
  if (const NounPhrase* thing = clause.first(Role::kDirect);
      thing != nullptr && clause.first(Role::kDestination) != nullptr && clause.verb != "go" &&
      clause.verb != "walk" &&
      (thing->pronoun ||
       (!thing->bare() && !thing->everything && !resolver_.options(*thing, Sort::kMovable, now_).empty())))
    return put(clause);
  const NounPhrase* phrase = clause.first(Role::kDestination);
  if (phrase == nullptr) phrase = clause.first(Role::kDirect);
  if (phrase == nullptr && clause.to_person && !macros_.empty()) return {};  // "... and come back here"
  if (phrase == nullptr && clause.verb == "wait") return {};                 // "... and wait there"
  if (phrase == nullptr && at_home_ && clause.verb == "go" && clause.particles.empty() && !macros_.empty())
    return {};  // "..., go!"
  if (phrase == nullptr)
    return clause.to_person ? "it is not known where you are" : "it is not clear where to go";
  Objects options = phrase->pronoun ? pronoun(*phrase, Sort::kAny, {}) : Objects{};
  if (!phrase->pronoun && !phrase->bare() && !phrase->everything)
    options = resolver_.chosen(*phrase, resolver_.options(*phrase, Sort::kAny, now_));
  if (options.empty()) return unknown_thing(*phrase, Sort::kAny);
  remember({options.front()});
  last_destination_ = {options.front()};
  return now_.near(options.front()) ? Problem{} : act({Verb::kMoveTo, options.front()});
}

std::string FrameActions::take(const Clause& clause) {
  // The first that fits is what is meant; where none does the things are taken in hand.
  static constexpr Reading kReadings[] = {
      &FrameActions::take_on_tray,           // "take the mug on your tray"
      &FrameActions::take_scoop_or_channel,  // "give me channel 5"
      &FrameActions::place_each_wished,      // "the second disc in the xbox and the first one on the table"
      &FrameActions::clear_what_is_on_it,    // "everything off it"
      &FrameActions::place_where_located,    // "I want the book on the shelf"
      &FrameActions::clear_wished_place,     // "I want an empty stove"
      &FrameActions::gather_at_place,        // "gather them on the study table"
      &FrameActions::give_content,           // "get me coke in the glass"
      &FrameActions::give,                   // "give the coffee a minute in the microwave"
      &FrameActions::fill_what_is_held,      // "hold the glass under the water dispenser"
      &FrameActions::place_wished_it,        // "the book, I would like it on the table"
      &FrameActions::add_wished_topping,     // "I would like my coffee with vanilla syrup"
      &FrameActions::make_wished_drink,      // "bring me a glass of water"
      &FrameActions::take_to_place,          // "take the mug to the sink"
      &FrameActions::turn_on_wished_device   // "tv please"
  };
  if (const auto read = first_that_fits(kReadings, clause)) return *read;
  return take_in_hand(clause);
}

std::optional<std::string> FrameActions::take_on_tray(const Clause& clause) {
  if (!at_home_ || !clause.has_particle("at_tray")) return std::nullopt;
  return clause.first(Role::kDestination) == nullptr ? put_on_tray(clause) : put(clause);
}

std::optional<std::string> FrameActions::take_scoop_or_channel(const Clause& clause) {
  for (const NounPhrase& phrase : clause.phrases) {
    if (phrase.scoop) return scoop(clause);
    if (language_.tv_word(phrase.phrase) && phrase.role == Role::kDirect) return television(clause);
  }
  return std::nullopt;
}

// "take the mug to the sink" says where to put it; "take the mug on the shelf" where it is.
std::optional<std::string> FrameActions::take_to_place(const Clause& clause) {
  const bool into = clause.has("into") || clause.has("onto");
  const auto to = [&](const NounPhrase& phrase) {
    return phrase.role == Role::kDestination && (phrase.where == Where::kTo || into);
  };
  if (std::ranges::none_of(clause.phrases, to)) return std::nullopt;
  return put(clause);
}

std::string FrameActions::take_in_hand(const Clause& clause) {
  Clause located = clause;
  for (NounPhrase& phrase : located.phrases)
    if (phrase.role == Role::kDestination) phrase.role = Role::kSource;
  Problem problem;
  const auto objects = direct(located, Sort::kMovable, problem);
  if (!problem.empty()) return problem;
  constexpr std::size_t kMostCarried = 6;  // two hands and the tray
  if (at_home_ && objects.size() > kMostCarried && located.first(Role::kSource) != nullptr)
    return this->clear(located);
  if (at_home_ && objects.size() > kMostCarried)
    return "that are " + std::to_string(objects.size()) + " things; " + std::to_string(kMostCarried) +
           " can be carried";
  // "the spoon in the glass has to come out, the fork can go in there"
  if (at_home_ && objects.size() == 1 && last_destination_.empty())
    if (const Symbol place = resolver_.place_of(objects.front(), now_); place != kNone)
      last_destination_ = {place};
  for (const Symbol object : objects)
    if (problem = take_up(object); !problem.empty()) return problem;
  return {};
}

// Holds it because somebody wants that.
std::string FrameActions::take_up(Symbol object) {
  if (now_.holds(object) && (start_.holds(object) || contains(taken_, object))) return {};
  taken_.push_back(object);
  if (!now_.holds(object)) return act({Verb::kGrasp, object});
  // so far only as a means: "pour it into the glass and hand me the glass"
  macros_.push_back({Verb::kGrasp, object});
  steps_.emplace_back();
  steps_.back().added = {sym_fact(Relation::kGrasping, kRobot, object)};
  return {};
}

}  // namespace goalnet::inference
