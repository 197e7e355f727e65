// What somebody wants a thing to do or to have: "make the tap stop", "get the microwave humming", "could the
// plate come down from the shelf and onto the table?", "every armchair has a pillow".
#include <algorithm>
#include <array>

#include "components/goalnet/language/clause_parser.h"
#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {

using namespace word_group;

std::size_t ClauseParser::caused(std::size_t at, std::size_t end, Clause& clause) const {
  const NounPhrase* thing = clause.first(Role::kDirect);
  if (!language_.hears_people() || thing == nullptr || thing->person || !clause.state.empty() ||
      clause.first(Role::kDestination) != nullptr || reader_.name_length(at) > 0)
    return at;
  // "get the dispenser to stop"
  if (words_[at] == "to" && at + 1 < end && (clause.verb == "get" || clause.verb == "make") &&
      (language_.verb(words_[at + 1]) == Frame::kStop || language_.verb(words_[at + 1]) == Frame::kStart) &&
      !reader_.starts(at + 2, end)) {
    clause.frame = language_.verb(words_[at + 1]), clause.verb = words_[at + 1], clause.to_person = false;
    return at + 2;
  }
  const std::string& word = words_[at];
  const Frame frame = language_.verb(word);
  if (clause.frame == Frame::kMake && clause.verb == "make" && !language_.participle(word) &&
      (frame == Frame::kStop || frame == Frame::kStart || frame == Frame::kGo)) {
    clause.frame = frame == Frame::kStop ? Frame::kStop : Frame::kStart, clause.verb = word;
    const bool doing = at + 1 < end && words_[at + 1].ends_with("ing");  // "stop running"
    return doing ? at + 2 : at + 1;
  }
  static constexpr std::array kCauses = {"get"sv, "set"sv, "make"sv, "have"sv, "keep"sv};
  if (!one_of(clause.verb, kCauses) || !word.ends_with("ing") || language_.complaint(word) != Frame::kStop ||
      language_.wanted_by_state(word) != Frame::kNone)
    return at;
  clause.frame = Frame::kStart, clause.verb = "start";
  return at + 1;
}

// "the coke and the remote swap places"; `at` where it is none.
std::size_t ClauseParser::trade_places(std::size_t at, std::size_t end) {
  static constexpr std::array kTrade = {"swap"sv, "trade"sv, "exchange"sv, "switch"sv, "change"sv};
  if (!language_.hears_people()) return at;
  std::vector<NounPhrase> things;
  std::size_t i = at;
  for (NounPhrase thing;; thing = {}) {
    const std::size_t done = reader_.read(i, end, thing);
    if (done == i || thing.person || thing.unknown || thing.bare()) return at;
    things.push_back(std::move(thing));
    i = done;
    if (i + 1 >= end || words_[i] != "and") break;
    ++i;
  }
  while (i < end && (one_of(words_[i], kDesire) || words_[i] == "can" || words_[i] == "to")) ++i;
  if (i + 1 >= end || !one_of(words_[i], kTrade) || words_[i + 1] != "place" || !ends_here(i + 2, end))
    return at;
  Clause clause;
  clause.frame = Frame::kSwap, clause.verb = "swap", clause.phrases = std::move(things);
  add(std::move(clause));
  return part_end(i + 2, end);
}

std::size_t ClauseParser::comes(std::size_t at, std::size_t end, Clause& clause) const {
  static constexpr std::array kMoves = {"come"sv, "go"sv, "get"sv, "move"sv};
  static constexpr std::array kFrom = {"off"sv, "from"sv, "of"sv};
  if (!language_.hears_people() || clause.phrases.empty()) return at;
  std::size_t i = at;
  while (i < end && (one_of(words_[i], kMoves) || one_of(words_[i], kParticles)) && words_[i] != "off" &&
         !(place_preposition(words_[i]) && reader_.starts(i + 1, end)))
    ++i;
  if (i >= end || !one_of(words_[i], kFrom)) return at;
  NounPhrase source, place;
  const std::size_t named = reader_.read(i + 1, end, source, true);
  if (named == i + 1 || source.person || source.unknown || source.bare()) return at;
  const std::size_t next = named < end && words_[named] == "and" ? named + 1 : named;
  const std::size_t done = reader_.read_place(next, end, place);
  source.role = Role::kSource;
  clause.mood = Mood::kCommand;
  clause.phrases.push_back(std::move(source));
  if (done == next || place.person) {
    clause.frame = Frame::kTake, clause.verb = "take";
    return named;
  }
  clause.frame = Frame::kPlace, clause.verb = "put";
  place.role = Role::kDestination;
  clause.phrases.push_back(std::move(place));
  return done;
}

// "(the pillows) from the first and the third armchair (go on the fourth)": where the subject stands; `at`
// where it is not that.
std::size_t ClauseParser::from_several(std::size_t at, std::size_t end, NounPhrase& subject) const {
  static constexpr std::array kFrom = {"from"sv, "on"sv, "off"sv, "in"sv};
  if (!language_.hears_people() || at >= end || !one_of(words_[at], kFrom)) return at;
  std::vector<NounPhrase> places;
  std::size_t i = at + 1;
  for (NounPhrase place;; place = {}) {
    const std::size_t done = reader_.read(i, end, place, true);
    if (done == i || place.person || place.unknown || !lexicon_->is_place_name(place.phrase)) return at;
    place.where = Where::kOn;
    places.push_back(std::move(place));
    i = done;
    if (i + 1 >= end || (words_[i] != "and" && words_[i] != ",")) break;
    ++i;
  }
  if (places.size() < 2 || i >= end || !(language_.copula(words_[i]) || one_of(words_[i], kDesire)))
    return at;
  subject.at.insert(subject.at.end(), places.begin(), places.end());
  return i;
}

std::size_t ClauseParser::has_thing(std::size_t at, std::size_t end, Clause& clause) const {
  if (clause.phrases.empty() || clause.phrases.front().person) return at;
  NounPhrase thing;
  const std::size_t done = reader_.read(at, end, thing);
  if (done == at || thing.pronoun || thing.person || thing.unknown || (thing.bare() && !thing.scoop) ||
      !ends_here(done, end))
    return at;
  NounPhrase holder = clause.phrases.front();
  holder.role = Role::kDestination, holder.where = Where::kTo;
  const bool dish =
      language_.holds_things(holder.phrase) || language_.content(holder.phrase) != symbol::kNone;
  clause.mood = Mood::kCommand, clause.wish = false;
  clause.frame = thing.scoop ? Frame::kScoop : dish ? Frame::kAdd : Frame::kPlace;
  clause.verb = thing.scoop ? "scoop" : dish ? "add" : "put";
  clause.phrases = {std::move(thing), std::move(holder)};
  return done;
}

// "(put it) where the mug is", "(the fork belongs) where the mug is": beside that; `at` where it is none.
std::size_t ClauseParser::where_that_is(std::size_t at, std::size_t end, Clause& clause) const {
  NounPhrase beside;
  if (language_.hears_people() && clause.frame == Frame::kNone && at + 1 < end && words_[at] == "with") {
    const std::size_t done = reader_.read(at + 1, end, beside);  // "the controller belongs with the console"
    if (done == at + 1 || beside.person || beside.unknown || beside.bare() || !ends_here(done, end))
      return at;
    beside.role = Role::kDestination, beside.where = Where::kNear;
    clause.phrases.push_back(std::move(beside));
    clause.mood = Mood::kCommand, clause.frame = Frame::kPlace, clause.verb = "put", clause.belongs = true;
    return done;
  }
  if (at + 1 >= end || words_[at] != "where") return at;
  std::size_t done = reader_.read(at + 1, end, beside);
  if (NounPhrase there; language_.hears_people() && done != at + 1) {  // "where the book from the table is"
    const std::size_t from = done < end && words_[done] == "from" ? done + 1 : done;
    const std::size_t after =
        from > done ? reader_.read(from, end, there, true) : reader_.read_place(done, end, there);
    if (after != from && !there.person && !there.unknown) beside.at.push_back(std::move(there)), done = after;
  }
  const bool stands = done < end && (language_.copula(words_[done]) ||
                                     (language_.hears_people() && one_of(words_[done], kLying)));
  if (done == at + 1 || !stands) return at;
  beside.role = Role::kDestination, beside.where = Where::kNear;
  clause.phrases.push_back(std::move(beside));
  if (clause.frame == Frame::kNone)
    clause.mood = Mood::kCommand, clause.frame = Frame::kPlace, clause.verb = "put", clause.belongs = true;
  return done + 1;
}

// "(the fork can go) in", "in there": into what was spoken of; `at` where it is none.
std::size_t ClauseParser::goes_in(std::size_t at, std::size_t end, Clause& clause) const {
  if (!language_.hears_people() || clause.phrases.empty()) return at;
  if (words_[at] == "at_tray") {  // "the beer goes on your tray"
    clause.mood = Mood::kCommand, clause.frame = Frame::kPlace, clause.verb = "put";
    clause.particles.push_back(words_[at]);
    return at + 1;
  }
  const bool in = words_[at] == "in" || words_[at] == "inside" || words_[at] == "into";
  const bool there = at + 1 < end && words_[at + 1] == "there";
  if (!(in && (there || at + 1 >= end || words_[at + 1] == ",")) && !(words_[at] == "on" && there)) return at;
  NounPhrase place;
  place.role = Role::kDestination, place.pronoun = true, place.word = "there";
  place.where = in ? Where::kIn : Where::kOn;
  clause.mood = Mood::kCommand, clause.frame = Frame::kPlace, clause.verb = "put", clause.belongs = true;
  clause.phrases.push_back(std::move(place));
  return there ? at + 2 : at + 1;
}

}  // namespace goalnet::inference
