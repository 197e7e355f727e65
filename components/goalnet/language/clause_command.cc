// A command: a verb, then its things and places to the end of the clause.
#include <algorithm>

#include "components/goalnet/language/clause_parser.h"
#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {

using namespace word_group;

std::size_t ClauseParser::command(std::size_t at, std::size_t end, Mood mood) {
  Clause clause;
  clause.mood = mood;
  clause.wish = words_[at] == "wish" || words_[at] == "have";
  clause.verb = clause.wish ? "bring" : language_.verb_base(words_[at]);
  clause.frame = clause.wish ? Frame::kTake : language_.verb(words_[at]);
  clause.words = {clause.verb};
  clause.phrases = fronted_;
  fronted_.clear();
  Role role = Role::kDirect;
  Where where = Where::kTo;
  std::size_t i = at + 1;
  // "I need put the egg on a plate"
  if (clause.wish && language_.hears_people() && opens_command(i, end) && reader_.name_length(i) == 0 &&
      !language_.participle(words_[i]))
    return command(i, end, mood);
  // "start boiling water", "go get the mug", "try to open it": the second verb is the one that counts
  if (clause.frame == Frame::kGo || clause.frame == Frame::kStart || clause.frame == Frame::kTry ||
      clause.frame == Frame::kStop) {
    std::size_t k = i;
    while (k < end && (words_[k] == "and" || words_[k] == "to" || words_[k] == "me" || words_[k] == "over" ||
                       words_[k] == "ahead" || words_[k] == "there" || words_[k] == "by"))
      ++k;
    const bool and_only_go =
        k == i || words_[i] != "and" || clause.frame == Frame::kGo || clause.frame == Frame::kTry;
    if (k < end && and_only_go && opens_command(k, end) && clause.frame != Frame::kStop &&
        !(reader_.name_length(k) > 0 && words_[k - 1] == "to"))
      return command(k, end, mood);
  }
  // "nothing good on channel three, try four"
  if (clause.frame == Frame::kTry && i < end && number_word(words_[i]) > 0 &&
      std::find(words_.begin(), words_.end(), "channel") != words_.end()) {
    NounPhrase channel;
    channel.phrase = channel.word = "channel", channel.number = number_word(words_[i]);
    clause.frame = Frame::kChange, clause.verb = "change";
    clause.phrases.push_back(std::move(channel));
    ++i;
  }
  while (i < end) {
    const std::string& word = words_[i];
    if (language_.joins(word)) {
      const std::size_t next = listed(i, end, clause, role, where);
      if (next == i) break;
      i = next;
      continue;
    }
    if (const std::size_t done = instead_of(i, end, clause); done != i) {
      i = done;
      continue;
    }
    if (NounPhrase phrase;
        word == "not" && !opens_command(i + 1, end)) {  // "the mug, not the glass, in the sink"
      if (const std::size_t done = denied(i, end, phrase); done != i) {
        clause.phrases.push_back(std::move(phrase));
        i = done;
        continue;
      }
    }
    if (language_.hears_people() && clause.wish && word == "to" && i + 2 < end && words_[i + 1] == "be" &&
        clause.first(Role::kDirect) != nullptr) {
      i +=
          place_preposition(words_[i + 2]) ? 1 : 2;  // "I want the mug to be washed", "... to be in the sink"
      continue;
    }
    // "I want every armchair to have a pillow"
    if (language_.hears_people() && clause.wish && word == "to" && i + 2 < end && words_[i + 1] == "have")
      if (const std::size_t done = has_thing(i + 2, end, clause); done != i + 2) {
        i = done;
        continue;
      }
    // "put no salt in it"
    if (language_.hears_people() && word == "no" && i > at && i + 1 < end && mood == Mood::kCommand &&
        words_[i - 1] != "," && !language_.joins(words_[i - 1]) && reader_.name_length(i + 1) > 0 &&
        clause.first(Role::kDirect) == nullptr) {
      clause.mood = Mood::kForbidden;
      ++i;
      continue;
    }
    // "I want that pillow comes on the couch", "I want the mug to be in the sink"
    static constexpr std::array kIsToBe = {"come"sv, "comes"sv, "go"sv, "goes"sv, "goe"sv, "be"sv};
    if (language_.hears_people() && clause.wish && one_of(word, kIsToBe) && i + 1 < end &&
        place_preposition(words_[i + 1]) && clause.first(Role::kDirect) != nullptr) {
      clause.frame = Frame::kPlace, clause.verb = "put", clause.wish = false;
      ++i;
      continue;
    }
    if (clause.frame == Frame::kPlace || clause.frame == Frame::kBring)
      if (const std::size_t done = where_that_is(i, end, clause); done != i) {
        i = done;
        continue;
      }
    if (word == "at_later") {  // "turn the tv off at eight"
      for_later();
      ++i;
      continue;
    }
    if (one_of(word, kSubordinate) || one_of(word, kTurns) || word == "not" || word == "never" ||
        word == "wish")
      break;
    if (word == "except" || (word == "other" && i + 1 < end && words_[i + 1] == "than")) {
      NounPhrase phrase;
      std::size_t k = i + 1;
      while (k < end && (words_[k] == "for" || words_[k] == "than")) ++k;
      const bool places =
          language_.hears_people() && role == Role::kSource;  // "from all armchairs except ..."
      const std::size_t done = reader_.read(k, end, phrase, places);
      phrase.role = Role::kExcept;
      NounPhrase place, next_place;
      const std::size_t after = reader_.read_place(done, end, place);
      // "except the one on the shelf"; of "all but book 3 on the table" the table is where things go
      const bool its_place =
          after != done && (phrase.word == "one" || clause.first(Role::kDestination) != nullptr ||
                            reader_.read_place(after, end, next_place) != after);
      if (its_place) phrase.at.push_back(place);
      i = its_place ? after : std::max(done, i + 1);
      clause.phrases.push_back(std::move(phrase));
      continue;
    }
    if (const std::size_t done = caused(i, end, clause); done != i) {
      i = done;
      continue;
    }
    // "take the mug to fill it", "use the spoon to scoop ice cream"
    if (word == "to" && i + 1 < end && opens_command(i + 1, end) && !reader_.name_length(i + 1)) {
      ++i;
      break;
    }
    clause.words.push_back(word);
    const std::size_t next = argument(i, end, clause, role, where);
    if (next == i) {
      clause.words.pop_back();
      break;
    }
    i = next;
  }
  // "the kettle needs filling and then putting on the stove"
  if (language_.hears_people() && words_[at].ends_with("ing") && at > 0 && language_.joins(words_[at - 1]) &&
      clause.first(Role::kDirect) == nullptr && !result_.clauses.empty() &&
      result_.clauses.back().mood == Mood::kCommand && result_.clauses.back().first(Role::kDirect) != nullptr)
    clause.phrases.insert(clause.phrases.begin(), *result_.clauses.back().first(Role::kDirect));
  return end_command(std::move(clause), i, end);
}

}  // namespace goalnet::inference
