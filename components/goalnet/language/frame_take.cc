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
  if (at_home_ && clause.has_particle("at_tray"))
    return clause.first(Role::kDestination) == nullptr ? put_on_tray(clause) : put(clause);
  for (const NounPhrase& phrase : clause.phrases) {
    if (phrase.scoop) return scoop(clause);
    if (language_.tv_word(phrase.phrase) && phrase.role == Role::kDirect)
      return television(clause);  // "give me channel 5"
  }
  // "the second disc in the xbox and the first one on the table": each to its place
  if (const auto placed =
          std::count_if(clause.phrases.begin(), clause.phrases.end(),
                        [](const NounPhrase& p) { return p.role == Role::kDirect && !p.at.empty(); });
      at_home_ && clause.wish && placed > 1 && clause.first(Role::kDestination) == nullptr) {
    for (const NounPhrase& phrase : clause.phrases) {
      Clause one = clause;
      one.phrases = {phrase};
      if (const Problem problem = take(one); !problem.empty()) return problem;
    }
    return {};
  }
  // "everything off it"
  if (const NounPhrase* all = clause.first(Role::kDirect), *from = clause.first(Role::kSource);
      at_home_ && all != nullptr && from != nullptr && all->everything && all->at.empty() && from->pronoun)
    return this->clear(clause);
  // "I want the book on the shelf", "gather the pillows on the couch": put it there, unless that says which
  const bool there_or_which = clause.wish || clause.verb == "gather" || clause.verb == "collect" ||
                              (at_home_ && clause.verb == "get" && !clause.to_person);
  const NounPhrase* located_thing = clause.first(Role::kDirect);
  if (at_home_ && clause.wish && located_thing != nullptr && located_thing->at.empty())
    for (const NounPhrase& phrase : clause.phrases)  // "I want the fork and the spoon in the sink"
      if (phrase.role == Role::kDirect && !phrase.at.empty()) located_thing = &phrase;
  if (const NounPhrase* thing = located_thing;
      there_or_which && thing != nullptr && !thing->at.empty() && !thing->everything) {
    const int loose = resolver_.doubts().loose;
    const auto there = resolver_.options(*thing, Sort::kMovable, now_);
    const bool content = language_.content(thing->phrase) != kNone && there.empty();
    const bool each = clause.wish && thing->at.front().all;  // "I want a pillow on each armchair"
    if ((resolver_.doubts().loose > loose && !there.empty()) || content || each) {
      resolver_.doubts().loose = loose;
      Clause wanted = clause;
      for (NounPhrase& phrase : wanted.phrases)
        if (phrase.role == Role::kDirect && !phrase.at.empty()) {
          NounPhrase place = phrase.at.front();
          place.role = Role::kDestination;
          phrase.at.clear();
          wanted.phrases.push_back(place);
          break;
        }
      wanted.frame = Frame::kPlace, wanted.to_person = false;
      return put(wanted);
    }
  }
  // "I want an empty stove"
  if (const NounPhrase* place = clause.first(Role::kDirect);
      at_home_ && clause.wish && place != nullptr && clause.phrases.size() == 1 && !place->pronoun &&
      !place->bare() && (place->has("empty") || place->has("free") || place->has("clean")) &&
      resolver_.options(*place, Sort::kMovable, now_).empty() &&
      !resolver_.options(*place, Sort::kPlace, now_).empty()) {
    Clause cleared = clause;
    cleared.phrases.front().adjectives.clear();
    return this->clear(cleared);
  }
  // "gather them on the study table"
  if (there_or_which && !clause.wish && at_home_ && clause.first(Role::kDestination) != nullptr) {
    Clause gathered = clause;
    gathered.frame = Frame::kPlace, gathered.to_person = false;
    return put(gathered);
  }
  if (const auto filled = give_content(clause)) return *filled;
  if (clause.verb == "give")
    if (const auto given = give(clause)) return *given;
  // "hold the glass under the water dispenser"
  if (const NounPhrase* thing = clause.first(Role::kDirect);
      at_home_ && thing != nullptr && resolver_.exists(kFridgeButton) &&
      ((!thing->at.empty() && thing->at.front().where == Where::kUnder) ||
       (clause.first(Role::kDestination) != nullptr &&
        clause.first(Role::kDestination)->where == Where::kUnder))) {
    const NounPhrase under = thing->at.empty() ? *clause.first(Role::kDestination) : thing->at.front();
    const Objects tap = under.pronoun  ? pronoun(under, Sort::kDevice, {})
                        : under.bare() ? Objects{}
                                       : resolver_.options(under, Sort::kDevice, now_);
    if (!tap.empty() && (tap.front() == kFridgeButton || tap.front() == kSinkKnob)) {
      Clause filled = clause;
      filled.frame = Frame::kFill, filled.verb = "fill", filled.to_person = false;
      for (NounPhrase& phrase : filled.phrases) phrase.at.clear();
      std::erase_if(filled.phrases,
                    [](const NounPhrase& phrase) { return phrase.role == Role::kDestination; });
      return fill(filled);
    }
  }
  // "the book, I would like it on the table"
  if (const NounPhrase* thing = clause.first(Role::kDirect);
      clause.wish && thing != nullptr && thing->pronoun && clause.first(Role::kDestination) != nullptr) {
    Clause wanted = clause;
    wanted.frame = Frame::kPlace, wanted.to_person = false;
    return put(wanted);
  }
  // "I would like my coffee with vanilla syrup"
  if (const NounPhrase* with = clause.first(Role::kWith); with != nullptr && !with->pronoun && !with->bare())
    if (const NounPhrase* thing = clause.first(Role::kDirect);
        thing != nullptr && !thing->pronoun && !thing->bare()) {
      const auto vessels = resolver_.options(*thing, Sort::kVessel, now_);
      bool done = false;
      const auto added = resolver_.options(*with, Sort::kMovable, now_);
      const bool topping =
          !added.empty() && (now_.has(Relation::kIsSqueezeable, added.front()) || added.front() == kSalt_1);
      if (!vessels.empty() && (topping || language_.content(with->phrase) != kNone))
        if (const Problem problem = add_content(*with, vessels.front(), done); !problem.empty())
          return problem;
    }
  // "bring me a glass of water": nothing has it yet
  if (const NounPhrase* thing = clause.first(Role::kDirect);
      thing != nullptr && !thing->pronoun && !thing->everything &&
      (clause.first(Role::kDestination) == nullptr || (at_home_ && clause.first(Role::kWith) != nullptr))) {
    const Symbol content = language_.content(thing->content.empty() ? thing->phrase : thing->content);
    const bool canned = content == kCoke || content == kEnergyDrink || content == kCanadaDry;
    const bool drink = content == kWater || content == kCoffee ||
                       (at_home_ && content == kIceCream &&
                        (!thing->content.empty() || clause.first(Role::kWith) != nullptr)) ||
                       (canned && !thing->content.empty());  // "a glass of coke", not "a can of coke"
    const bool hot =
        content == kCoffee && (thing->has("hot") || thing->has("warm"));  // "let me have a hot coffee"
    if (at_home_ && content == kIceCream && clause.first(Role::kDestination) != nullptr) return make(clause);
    if (at_home_ && drink && thing->count > 1 && !thing->content.empty()) {
      // "two long cups of water": each of them
      NounPhrase vessel = *thing;
      vessel.content.clear();
      const Objects vessels = resolver_.chosen(vessel, resolver_.options(vessel, Sort::kVessel, now_));
      if (vessels.size() == static_cast<std::size_t>(thing->count)) {
        for (const Symbol object : vessels) {
          Clause one = clause;
          one.phrases.front().count = 0, one.phrases.front().plural = one.phrases.front().all = false;
          one.phrases.front().number = number_of(resolver_.name(object));
          if (const Problem problem = make(one); !problem.empty()) return problem;
        }
        return {};
      }
    }
    if (drink && (hot || resolver_.options(*thing, Sort::kMovable, now_).empty())) return make(clause);
  }
  // "take the mug to the sink" says where to put it; "take the mug on the shelf" where it is.
  Clause located = clause;
  for (NounPhrase& phrase : located.phrases) {
    if (phrase.role != Role::kDestination) continue;
    if (phrase.where == Where::kTo || clause.has("into") || clause.has("onto")) return put(clause);
    phrase.role = Role::kSource;
  }
  // "tv please", "I want the tap": on
  if (const NounPhrase* thing = located.first(Role::kDirect);
      clause.wish && located.phrases.size() == 1 && thing != nullptr && !thing->pronoun && !thing->bare() &&
      !thing->everything && resolver_.options(*thing, Sort::kMovable, now_).empty()) {
    const auto devices = resolver_.options(*thing, Sort::kDevice, now_);
    if (!devices.empty() && (devices.front() == kTv_1 || devices.front() == kSinkKnob ||
                             (at_home_ && (devices.front() == kStove || devices.front() == kFridgeButton))))
      return turn(clause, 1);
  }
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
