// What conditions say: "(if) anything is on the stove", "(if the armchair is) free", "(if the xbox has) a
// disc in it".
#include <algorithm>
#include <array>

#include "components/goalnet/language/clause_parser.h"
#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {

using namespace word_group;

// "(if) anything is on the stove", "nothing is on it", "no pillow is on the couch"; `at` where it is none.
std::size_t ClauseParser::is_anything(std::size_t at, std::size_t end) {
  NounPhrase thing, place;
  const bool nothing = words_[at] == "nothing", no = words_[at] == "no";
  std::size_t k = at + 1;
  if (nothing)
    thing.everything = thing.plural = thing.all = true, thing.word = "anything";
  else
    k = reader_.read(no ? at + 1 : at, end, thing);
  if (!nothing && !no && !thing.everything) return at;
  while (k < end && (language_.copula(words_[k]) || one_of(words_[k], kLying))) ++k;
  const std::size_t done = reader_.read_place(k, end, place);
  const bool told = thing.at.empty() && done != k && !place.person && !place.hand;
  if (told) thing.at.push_back(std::move(place));
  if (thing.at.empty() || thing.unknown || thing.person || thing.bare()) return at;
  Clause clause;
  clause.mood = Mood::kStatement, clause.negative = nothing || no;
  clause.phrases = {std::move(thing)};
  add(std::move(clause));
  return told ? done : k;
}

// "(if the armchair is) free", "(the couch is) full"; `at` where it is none.
std::size_t ClauseParser::state_of_place(std::size_t at, Clause& clause) const {
  static constexpr std::array kHow = {"free"sv, "full"sv, "empty"sv};
  if (!language_.hears_people() || !one_of(words_[at], kHow) || !clause.state.empty() ||
      clause.phrases.empty() || !lexicon_->is_place_name(clause.phrases.front().phrase) ||
      language_.holds_things(clause.phrases.front().phrase))
    return at;
  clause.state = words_[at];
  return at + 1;
}

// "(the xbox has) a disc in it", "(the armchair has) no pillow on it": the disc is in the xbox; `at` where it
// is none.
std::size_t ClauseParser::bears_thing(std::size_t at, std::size_t end, Clause& clause) const {
  // "(if the controller is) with the xbox"
  if (NounPhrase beside; language_.hears_people() && judging_ && words_[at] == "with" &&
                         clause.phrases.size() == 1 && clause.phrases.front().at.empty()) {
    const std::size_t done = reader_.read(at + 1, end, beside);
    if (done == at + 1 || beside.person || beside.unknown || beside.pronoun) return at;
    beside.where = Where::kNear;
    clause.phrases.front().at.push_back(std::move(beside));
    return done;
  }
  if (!language_.hears_people() || !judging_ || at == 0 || clause.phrases.size() != 1 ||
      (words_[at - 1] != "has" && words_[at - 1] != "have"))
    return at;
  const std::size_t from = words_[at] == "no" ? at + 1 : at;
  NounPhrase thing, there;
  const std::size_t named = reader_.read(from, end, thing);
  const std::size_t done = named == from ? named : reader_.read_place(named, end, there);
  if (named == from || done == named || !there.pronoun || thing.person || thing.unknown || thing.bare() ||
      language_.content(thing.phrase) != symbol::kNone)
    return at;
  NounPhrase holder = clause.phrases.front();
  holder.where = there.where;
  thing.at = {std::move(holder)};
  clause.phrases = {std::move(thing)};
  clause.negative = from > at;
  return done;
}

// "(the kettle has) no water (in it)"; `at` where it is none.
std::size_t ClauseParser::holds_no(std::size_t at, std::size_t end, Clause& clause) const {
  if (!language_.hears_people() || at + 1 >= end || words_[at] != "no" || clause.phrases.empty() ||
      !clause.phrases.front().content.empty() || !language_.holds_things(clause.phrases.front().phrase))
    return at;
  NounPhrase content;
  const std::size_t done = reader_.read(at + 1, end, content);
  if (done == at + 1 || language_.content(content.phrase) == symbol::kNone) return at;
  clause.phrases.front().content = content.phrase, clause.negative = true;
  const bool in_it = done + 1 < end && words_[done] == "in" && is_pronoun(words_[done + 1]);
  return in_it ? done + 2 : done;
}

}  // namespace goalnet::inference
