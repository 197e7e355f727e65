// What is asked for as if it were to be taken, and is to be placed, filled, made or turned on: "I want the
// book on the shelf", "bring me a glass of water".
#include <algorithm>

#include "components/goalnet/language/frame_actions.h"
#include "components/goalnet/language/symbol_list.h"

namespace goalnet::inference {

using namespace symbol;

namespace {

// "I want the book on the shelf", "gather the pillows on the couch": put it there, unless that says which.
bool says_place_or_which(const Clause& clause, bool at_home) {
  return clause.wish || clause.verb == "gather" || clause.verb == "collect" ||
         (at_home && clause.verb == "get" && !clause.to_person);
}

// "I want the fork and the spoon in the sink": the spoon.
const NounPhrase* located_thing(const Clause& clause, bool at_home) {
  const NounPhrase* thing = clause.first(Role::kDirect);
  if (at_home && clause.wish && thing != nullptr && thing->at.empty())
    for (const NounPhrase& phrase : clause.phrases)
      if (phrase.role == Role::kDirect && !phrase.at.empty()) thing = &phrase;
  return thing;
}

// Where it is said to be is where it is to be put.
void place_is_destination(Clause& clause) {
  for (NounPhrase& phrase : clause.phrases)
    if (phrase.role == Role::kDirect && !phrase.at.empty()) {
      NounPhrase place = phrase.at.front();
      place.role = Role::kDestination;
      phrase.at.clear();
      clause.phrases.push_back(place);
      return;
    }
}

}  // namespace

// The same clause as one of placing.
std::string FrameActions::put_wanted(Clause clause) {
  clause.frame = Frame::kPlace, clause.to_person = false;
  return put(clause);
}

// "the second disc in the xbox and the first one on the table": each to its place
std::optional<std::string> FrameActions::place_each_wished(const Clause& clause) {
  const auto placed = std::ranges::count_if(clause.phrases, [](const NounPhrase& phrase) {
    return phrase.role == Role::kDirect && !phrase.at.empty();
  });
  if (!at_home_ || !clause.wish || placed < 2 || clause.first(Role::kDestination) != nullptr)
    return std::nullopt;
  for (const NounPhrase& phrase : clause.phrases) {
    Clause one = clause;
    one.phrases = {phrase};
    if (const Problem problem = take(one); !problem.empty()) return problem;
  }
  return Problem{};
}

// "everything off it"
std::optional<std::string> FrameActions::clear_what_is_on_it(const Clause& clause) {
  const NounPhrase *all = clause.first(Role::kDirect), *from = clause.first(Role::kSource);
  if (!at_home_ || all == nullptr || from == nullptr || !all->everything || !all->at.empty() ||
      !from->pronoun)
    return std::nullopt;
  return this->clear(clause);
}

// "I want the book on the shelf", where it is not there
std::optional<std::string> FrameActions::place_where_located(const Clause& clause) {
  const NounPhrase* thing = located_thing(clause, at_home_);
  if (!says_place_or_which(clause, at_home_) || thing == nullptr || thing->at.empty() || thing->everything)
    return std::nullopt;
  const int loose = resolver_.doubts().loose;
  const auto there = resolver_.options(*thing, Sort::kMovable, now_);
  const bool content = language_.content(thing->phrase) != kNone && there.empty();
  const bool each = clause.wish && thing->at.front().all;  // "I want a pillow on each armchair"
  const bool elsewhere = resolver_.doubts().loose > loose && !there.empty();
  if (!elsewhere && !content && !each) return std::nullopt;
  resolver_.doubts().loose = loose;
  Clause wanted = clause;
  place_is_destination(wanted);
  return put_wanted(wanted);
}

// "I want an empty stove"
std::optional<std::string> FrameActions::clear_wished_place(const Clause& clause) {
  const NounPhrase* place = clause.first(Role::kDirect);
  if (!at_home_ || !clause.wish || place == nullptr || clause.phrases.size() != 1 || place->pronoun ||
      place->bare() || (!place->has("empty") && !place->has("free") && !place->has("clean")) ||
      !resolver_.options(*place, Sort::kMovable, now_).empty() ||
      resolver_.options(*place, Sort::kPlace, now_).empty())
    return std::nullopt;
  Clause cleared = clause;
  cleared.phrases.front().adjectives.clear();
  return this->clear(cleared);
}

// "gather them on the study table"
std::optional<std::string> FrameActions::gather_at_place(const Clause& clause) {
  if (!at_home_ || clause.wish || !says_place_or_which(clause, at_home_) ||
      clause.first(Role::kDestination) == nullptr)
    return std::nullopt;
  return put_wanted(clause);
}

// "hold the glass under the water dispenser"
std::optional<std::string> FrameActions::fill_what_is_held(const Clause& clause) {
  const NounPhrase *thing = clause.first(Role::kDirect), *to = clause.first(Role::kDestination);
  if (!at_home_ || thing == nullptr || !resolver_.exists(kFridgeButton)) return std::nullopt;
  if ((thing->at.empty() || thing->at.front().where != Where::kUnder) &&
      (to == nullptr || to->where != Where::kUnder))
    return std::nullopt;
  const Objects tap = meant_by(thing->at.empty() ? *to : thing->at.front(), Sort::kDevice);
  if (tap.empty() || (tap.front() != kFridgeButton && tap.front() != kSinkKnob)) return std::nullopt;
  Clause filled = clause;
  filled.frame = Frame::kFill, filled.verb = "fill", filled.to_person = false;
  for (NounPhrase& phrase : filled.phrases) phrase.at.clear();
  std::erase_if(filled.phrases, [](const NounPhrase& phrase) { return phrase.role == Role::kDestination; });
  return fill(filled);
}

// "the book, I would like it on the table"
std::optional<std::string> FrameActions::place_wished_it(const Clause& clause) {
  const NounPhrase* thing = clause.first(Role::kDirect);
  if (!clause.wish || thing == nullptr || !thing->pronoun || clause.first(Role::kDestination) == nullptr)
    return std::nullopt;
  return put_wanted(clause);
}

// "I would like my coffee with vanilla syrup": it is taken after that
std::optional<std::string> FrameActions::add_wished_topping(const Clause& clause) {
  const NounPhrase *with = clause.first(Role::kWith), *thing = clause.first(Role::kDirect);
  if (with == nullptr || with->pronoun || with->bare() || thing == nullptr || thing->pronoun || thing->bare())
    return std::nullopt;
  const auto vessels = resolver_.options(*thing, Sort::kVessel, now_);
  const auto added = resolver_.options(*with, Sort::kMovable, now_);
  const bool topping =
      !added.empty() && (now_.has(Relation::kIsSqueezeable, added.front()) || added.front() == kSalt_1);
  if (vessels.empty() || (!topping && language_.content(with->phrase) == kNone)) return std::nullopt;
  bool done = false;
  if (const Problem problem = add_content(*with, vessels.front(), done); !problem.empty()) return problem;
  return std::nullopt;
}

// "bring me a glass of water": nothing has it yet
std::optional<std::string> FrameActions::make_wished_drink(const Clause& clause) {
  const NounPhrase *thing = clause.first(Role::kDirect), *to = clause.first(Role::kDestination);
  const bool with = clause.first(Role::kWith) != nullptr;
  if (thing == nullptr || thing->pronoun || thing->everything || (to != nullptr && !(at_home_ && with)))
    return std::nullopt;
  const bool of_it = !thing->content.empty();  // "a glass of coke", not "a can of coke"
  const Symbol content = language_.content(of_it ? thing->content : thing->phrase);
  const bool drink = content == kWater || content == kCoffee ||
                     (at_home_ && content == kIceCream && (of_it || with)) ||
                     (is_canned_drink(content) && of_it);
  const bool hot =
      content == kCoffee && (thing->has("hot") || thing->has("warm"));  // "let me have a hot coffee"
  if (at_home_ && content == kIceCream && to != nullptr) return make(clause);
  if (at_home_ && drink && thing->count > 1 && of_it)
    if (const auto made = make_in_each(clause, *thing)) return *made;
  if (drink && (hot || resolver_.options(*thing, Sort::kMovable, now_).empty())) return make(clause);
  return std::nullopt;
}

// "two long cups of water": each of them
std::optional<std::string> FrameActions::make_in_each(const Clause& clause, const NounPhrase& thing) {
  NounPhrase vessel = thing;
  vessel.content.clear();
  const Objects vessels = resolver_.chosen(vessel, resolver_.options(vessel, Sort::kVessel, now_));
  if (vessels.size() != static_cast<std::size_t>(thing.count)) return std::nullopt;
  for (const Symbol object : vessels) {
    Clause one = clause;
    one.phrases.front().count = 0, one.phrases.front().plural = one.phrases.front().all = false;
    one.phrases.front().number = number_of(resolver_.name(object));
    if (const Problem problem = make(one); !problem.empty()) return problem;
  }
  return Problem{};
}

// "tv please", "I want the tap": on
std::optional<std::string> FrameActions::turn_on_wished_device(const Clause& clause) {
  const NounPhrase* thing = clause.first(Role::kDirect);
  if (!clause.wish || clause.phrases.size() != 1 || thing == nullptr || thing->pronoun || thing->bare() ||
      thing->everything || !resolver_.options(*thing, Sort::kMovable, now_).empty())
    return std::nullopt;
  const auto devices = resolver_.options(*thing, Sort::kDevice, now_);
  if (devices.empty()) return std::nullopt;
  const Symbol device = devices.front();
  if (device != kTv_1 && device != kSinkKnob && !(at_home_ && (device == kStove || device == kFridgeButton)))
    return std::nullopt;
  return turn(clause, 1);
}

}  // namespace goalnet::inference
