// What says more of the things of the command before it: which of them may stay, that it is all of them,
// which they are.
#include <algorithm>
#include <array>

#include "components/goalnet/language/clause_parser.h"
#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {

using namespace word_group;

namespace {

// What takes things from where they are.
bool removes(Frame frame) {
  static constexpr std::array kRemove = {Frame::kClear,   Frame::kTake,  Frame::kEmpty,
                                         Frame::kDiscard, Frame::kPlace, Frame::kBring};
  return std::find(kRemove.begin(), kRemove.end(), frame) != kRemove.end();
}

}  // namespace

std::size_t ClauseParser::says_which(std::size_t at, std::size_t end) {
  if (const std::size_t done = only_stays(at, end); done != at) return done;
  if (const std::size_t done = namely(at, end); done != at) return done;
  if (const std::size_t done = only_on(at, end); done != at) return done;
  return trade_places(at, end);
}

std::size_t ClauseParser::only_stays(std::size_t at, std::size_t end) {
  static constexpr std::array kMay = {"can"sv, "may"sv, "should"sv, "must"sv, "shall"sv};
  if (!language_.hears_people() || result_.clauses.empty() || !removes(result_.clauses.back().frame) ||
      result_.clauses.back().mood != Mood::kCommand)
    return at;
  std::size_t i = at;
  while (i < end && (words_[i] == "only" || words_[i] == "just" || language_.joins(words_[i]))) ++i;
  std::vector<NounPhrase> staying;
  for (NounPhrase thing, place;; thing = place = {}) {
    const std::size_t done = reader_.read(i, end, thing);
    if (done == i || thing.person || thing.unknown || thing.pronoun || thing.bare()) return at;
    const std::size_t after = reader_.read_place(done, end, place);
    if (after != done) thing.at.push_back(place);
    thing.role = Role::kExcept;
    staying.push_back(std::move(thing));
    i = after;
    if (i + 1 >= end || words_[i] != "and") break;
    ++i;
  }
  if (i + 1 >= end || !one_of(words_[i], kMay) || words_[i + 1] != "stay") return at;
  NounPhrase there;
  std::size_t stop = reader_.read_place(i + 2, end, there);
  if (stop < end && words_[stop] == "there") ++stop;
  if (!ends_here(stop, end)) return at;
  Clause& last = result_.clauses.back();
  last.phrases.insert(last.phrases.end(), staying.begin(), staying.end());
  return part_end(stop, end);
}

std::size_t ClauseParser::all_of_them(std::size_t at, std::size_t end, const NounPhrase& said,
                                      std::size_t done) {
  const bool all = said.pronoun && said.plural && (said.all || said.count > 1);
  if (!language_.hears_people() || !all || at == 0 || words_[at - 1] != "," || result_.clauses.empty() ||
      result_.clauses.back().mood != Mood::kCommand || !ends_here(done, end))
    return at;
  for (NounPhrase& asked : result_.clauses.back().phrases) {
    if (asked.role != Role::kDirect || asked.pronoun || !asked.plural) continue;
    asked.all = true;
    return part_end(done, end);
  }
  return at;
}

std::size_t ClauseParser::namely(std::size_t at, std::size_t end) {
  if (!language_.hears_people() || (words_[at] != "so" && words_[at] != "namely") ||
      result_.clauses.empty() || result_.clauses.back().mood != Mood::kCommand)
    return at;
  std::vector<NounPhrase>& asked = result_.clauses.back().phrases;
  const auto many = [](const NounPhrase& phrase) {
    return phrase.role == Role::kDirect && !phrase.pronoun && (phrase.plural || phrase.all);
  };
  const auto kind = std::find_if(asked.begin(), asked.end(), many);
  if (kind == asked.end()) return at;
  std::vector<NounPhrase> listed;
  std::size_t i = at + 1;
  for (NounPhrase thing;; thing = {}) {
    const std::size_t done = reader_.read(i, end, thing);
    if (done == i || thing.person || thing.unknown || thing.pronoun || thing.bare()) return at;
    listed.push_back(std::move(thing));
    i = done;
    if (i + 1 >= end || (words_[i] != "and" && words_[i] != ",") || !reader_.starts(i + 1, end)) break;
    ++i;
  }
  if (!ends_here(i, end)) return at;
  asked.insert(asked.erase(kind), listed.begin(), listed.end());
  return part_end(i, end);
}

std::size_t ClauseParser::before_that(std::size_t at, std::size_t end) {
  static constexpr std::array kThat = {"that"sv, "this"sv, "it"sv, "so"sv};
  std::size_t i = at + 1;
  if (!language_.hears_people() || words_[at] != "before" || result_.clauses.size() < 2) return at;
  if (i < end && words_[i] == "you") ++i;
  // "before you do that" is left as "before"
  if (i < end && words_[i] != "do" && words_[i] != "doing" && !one_of(words_[i], kThat)) return at;
  while (i < end && (words_[i] == "do" || words_[i] == "doing" || one_of(words_[i], kThat))) ++i;
  if (!ends_here(i, end) || result_.clauses.back().mood != Mood::kCommand) return at;
  std::rotate(result_.clauses.rbegin(), result_.clauses.rbegin() + 1, result_.clauses.rbegin() + 2);
  return part_end(i, end);
}

}  // namespace goalnet::inference
