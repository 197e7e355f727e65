// What tells more of the clause before it: "the one on the shelf".
#include <algorithm>

#include "components/goalnet/language/clause_parser.h"
#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {

using namespace word_group;

bool ClauseParser::ends_here(std::size_t at, std::size_t end) const {
  for (; at < end && words_[at] != ","; ++at)
    if (!harmless(at) && words_[at] != "correction" && words_[at] != "too") return false;
  return true;
}

// "it's the one on the coffee table", "they are on the shelf": tells of the things just asked for where they
// are.
std::size_t ClauseParser::narrows(std::size_t at, std::size_t end) {
  const bool told =
      at + 2 < end && is_pronoun(words_[at]) && (words_[at + 1] == "is" || words_[at + 1] == "are");
  const bool the_one =
      at + 2 < end && words_[at] == "the" && words_[at + 1] == "one";  // "the one on the shelf"
  if ((!told && !the_one) || result_.clauses.empty() || result_.clauses.back().mood != Mood::kCommand)
    return at;
  NounPhrase same, place;
  const std::size_t from = told ? at + 2 : at;
  std::size_t done = reader_.read(from, end, same);
  if (done != from && same.word != "one" && !the_one) return at;
  if (the_one && done == from) return at;
  if (same.at.empty()) {
    const std::size_t after = reader_.read_place(done, end, place);
    if (after == done || place.pronoun || place.person) return at;
    done = after;
  } else {
    place = same.at.front();
  }
  // "the one on the shelf is the softest"
  const bool praised = language_.hears_people() && the_one && done + 2 < end && words_[done] == "is" &&
                       words_[done + 1] == "the" && words_[done + 2].ends_with("est");
  if (praised) done += 3;
  if (!ends_here(done, end) && !(praised && words_[done] == "so")) return at;
  std::vector<NounPhrase>& phrases = result_.clauses.back().phrases;
  const auto meant = [&](const NounPhrase& phrase) {
    return !phrase.pronoun && phrase.at.empty() &&
           (phrase.role == Role::kDirect || (the_one && phrase.joined));
  };
  if (the_one) {  // the newest
    const auto named = std::find_if(phrases.rbegin(), phrases.rend(), meant);
    if (named == phrases.rend()) return at;
    if (language_.hears_people() && language_.holds_things(place.phrase) &&
        language_.content(named->phrase) != symbol::kNone && named->content.empty()) {
      named->content = named->phrase;  // "a coffee, the one in the mug"
      named->phrase = named->word = place.phrase;
      return done;
    }
    named->at.push_back(place);
    return done;
  }
  const auto named = std::find_if(phrases.begin(), phrases.end(), meant);
  if (named == phrases.end()) return at;
  named->at.push_back(place);
  return done;
}

// "(the beer is empty) and should be binned": of the same thing; `at` where it is none.
std::size_t ClauseParser::of_the_same(std::size_t at, std::size_t end) {
  // "(the kettle should be full) and hot"
  if (language_.hears_people() && at + 1 < end && words_[at] == "and" && !result_.clauses.empty() &&
      result_.clauses.back().mood == Mood::kCommand && !result_.clauses.back().state.empty() &&
      result_.clauses.back().phrases.size() == 1 && ends_here(at + 2, end) &&
      language_.wanted_by_state(words_[at + 1]) != Frame::kNone && reader_.name_length(at + 1) == 0) {
    Clause also = result_.clauses.back();
    also.frame = language_.wanted_by_state(words_[at + 1]), also.verb = also.state = words_[at + 1];
    add(std::move(also));
    return at + 2;
  }
  if (!language_.hears_people() || at + 2 >= end || words_[at] != "and" ||
      (words_[at + 1] != "should" && words_[at + 1] != "must") || result_.clauses.empty() ||
      result_.clauses.back().mood != Mood::kStatement ||
      result_.clauses.back().first(Role::kDirect) == nullptr)
    return at;
  Clause same;
  same.mood = Mood::kStatement;
  same.phrases = {*result_.clauses.back().first(Role::kDirect)};
  add(std::move(same));
  std::size_t k = at + 2;
  while (k < end && language_.copula(words_[k])) ++k;
  return predicate(k, end, result_.clauses.back(), true, false);
}

}  // namespace goalnet::inference
