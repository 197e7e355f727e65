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

}  // namespace goalnet::inference
