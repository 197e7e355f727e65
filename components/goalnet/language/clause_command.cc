// A command: a verb, then its things and places to the end of the clause.
#include "components/goalnet/language/clause_command.h"

#include <algorithm>
#include <array>

namespace goalnet::inference {

using namespace word_group;

std::size_t ClauseParser::command(std::size_t at, std::size_t end, Mood mood) {
  return Command(*this, at, end, mood).read();
}

ClauseParser::Command::Command(ClauseParser& parser, std::size_t at, std::size_t end, Mood mood)
    : Rules(parser, at, end), mood_(mood), i_(at + 1) {
  clause_.mood = mood;
  clause_.wish = words_[at] == "wish" || words_[at] == "have";
  clause_.verb = clause_.wish ? "bring" : language_.verb_base(words_[at]);
  clause_.frame = clause_.wish ? Frame::kTake : language_.verb(words_[at]);
  clause_.words = {clause_.verb};
  clause_.phrases = parser_.fronted_;
  parser_.fronted_.clear();
}

std::size_t ClauseParser::Command::read() {
  if (const Read verb = verb_that_counts()) return parser_.command(*verb, end_, mood_);
  other_channel();
  while (i_ < end_ && !ended_) {
    const Read done = next();
    if (!done || *done == i_) break;
    i_ = *done;
  }
  same_as_before();
  return parser_.end_command(std::move(clause_), i_, end_);
}

// Reads what stands at the next word.
auto ClauseParser::Command::next() -> Read {
  static constexpr std::array<Rule, 14> kRules = {
      &Command::list,           &Command::instead,  &Command::denied_thing, &Command::wished_state,
      &Command::wished_to_have, &Command::no_thing, &Command::wished_place, &Command::where_that_is,
      &Command::later,          &Command::turn,     &Command::except,       &Command::caused,
      &Command::purpose,        &Command::argument};
  for (const Rule rule : kRules)
    if (const Read done = (this->*rule)()) return done;
  return {};
}

// "start boiling water", "go get the mug", "try to open it", "I need put the egg on a plate": the second verb
auto ClauseParser::Command::verb_that_counts() -> Read {
  static constexpr std::array kBetween = {"and"sv, "to"sv, "me"sv, "over"sv, "ahead"sv, "there"sv, "by"sv};
  if (clause_.wish && people() && parser_.opens_command(i_, end_) && reader_.name_length(i_) == 0 &&
      !language_.participle(words_[i_]))
    return i_;
  const bool goes = clause_.frame == Frame::kGo || clause_.frame == Frame::kTry;
  if (!goes && clause_.frame != Frame::kStart) return {};
  std::size_t k = i_;
  while (k < end_ && one_of(words_[k], kBetween)) ++k;
  const bool and_only_go = goes || k == i_ || words_[i_] != "and";
  if (k >= end_ || !and_only_go || !parser_.opens_command(k, end_) ||
      (reader_.name_length(k) > 0 && words_[k - 1] == "to"))
    return {};
  return k;
}

// "nothing good on channel three, try four"
void ClauseParser::Command::other_channel() {
  if (clause_.frame != Frame::kTry || i_ >= end_ || number_word(words_[i_]) == 0 ||
      std::find(words_.begin(), words_.end(), "channel") == words_.end())
    return;
  NounPhrase channel;
  channel.phrase = channel.word = "channel", channel.number = number_word(words_[i_]);
  clause_.frame = Frame::kChange, clause_.verb = "change";
  clause_.phrases.push_back(std::move(channel));
  ++i_;
}

auto ClauseParser::Command::list() -> Read {
  if (!language_.joins(words_[i_])) return {};
  return parser_.listed(i_, end_, clause_, role_, where_);
}

auto ClauseParser::Command::instead() -> Read {
  if (const std::size_t done = parser_.instead_of(i_, end_, clause_); done != i_) return done;
  return {};
}

// "the mug, not the glass, in the sink"
auto ClauseParser::Command::denied_thing() -> Read {
  if (words_[i_] != "not" || parser_.opens_command(i_ + 1, end_)) return {};
  NounPhrase phrase;
  const std::size_t done = parser_.denied(i_, end_, phrase);
  if (done == i_) return {};
  clause_.phrases.push_back(std::move(phrase));
  return done;
}

// "I want the mug to be washed", "... to be in the sink"
auto ClauseParser::Command::wished_state() -> Read {
  if (!people() || !clause_.wish || words_[i_] != "to" || !is(i_ + 1, "be") || i_ + 2 >= end_ ||
      clause_.first(Role::kDirect) == nullptr)
    return {};
  return place_preposition(words_[i_ + 2]) ? i_ + 1 : i_ + 2;
}

// "I want every armchair to have a pillow"
auto ClauseParser::Command::wished_to_have() -> Read {
  if (!people() || !clause_.wish || words_[i_] != "to" || !is(i_ + 1, "have") || i_ + 2 >= end_) return {};
  if (const std::size_t done = parser_.has_thing(i_ + 2, end_, clause_); done != i_ + 2) return done;
  return {};
}

// "put no salt in it"
auto ClauseParser::Command::no_thing() -> Read {
  if (!people() || words_[i_] != "no" || i_ <= at_ || i_ + 1 >= end_ || mood_ != Mood::kCommand ||
      words_[i_ - 1] == "," || language_.joins(words_[i_ - 1]) || reader_.name_length(i_ + 1) == 0 ||
      clause_.first(Role::kDirect) != nullptr)
    return {};
  clause_.mood = Mood::kForbidden;
  return i_ + 1;
}

// "I want that pillow comes on the couch", "I want the mug to be in the sink"
auto ClauseParser::Command::wished_place() -> Read {
  static constexpr std::array kIsToBe = {"come"sv, "comes"sv, "go"sv, "goes"sv, "goe"sv, "be"sv};
  if (!people() || !clause_.wish || !one_of(words_[i_], kIsToBe) || i_ + 1 >= end_ ||
      !place_preposition(words_[i_ + 1]) || clause_.first(Role::kDirect) == nullptr)
    return {};
  clause_.frame = Frame::kPlace, clause_.verb = "put", clause_.wish = false;
  return i_ + 1;
}

auto ClauseParser::Command::where_that_is() -> Read {
  if (clause_.frame != Frame::kPlace && clause_.frame != Frame::kBring) return {};
  if (const std::size_t done = parser_.where_that_is(i_, end_, clause_); done != i_) return done;
  return {};
}

// "turn the tv off at eight"
auto ClauseParser::Command::later() -> Read {
  if (words_[i_] != "at_later") return {};
  parser_.for_later();
  return i_ + 1;
}

// "(put it away) if ...", "(take it) and do not ...": something else begins
auto ClauseParser::Command::turn() -> Read {
  const std::string& word = words_[i_];
  if (one_of(word, kSubordinate) || one_of(word, kTurns) || word == "not" || word == "never" ||
      word == "wish")
    return i_;
  return {};
}

// "except the one on the shelf"; of "all but book 3 on the table" the table is where things go
auto ClauseParser::Command::except() -> Read {
  if (words_[i_] != "except" && !(words_[i_] == "other" && is(i_ + 1, "than"))) return {};
  NounPhrase phrase, place, next_place;
  std::size_t k = i_ + 1;
  while (is(k, "for") || is(k, "than")) ++k;
  const bool places = people() && role_ == Role::kSource;  // "from all armchairs except ..."
  const std::size_t done = reader_.read(k, end_, phrase, places);
  phrase.role = Role::kExcept;
  const std::size_t after = reader_.read_place(done, end_, place);
  const bool its_place =
      after != done && (phrase.word == "one" || clause_.first(Role::kDestination) != nullptr ||
                        reader_.read_place(after, end_, next_place) != after);
  if (its_place) phrase.at.push_back(place);
  clause_.phrases.push_back(std::move(phrase));
  return its_place ? after : std::max(done, i_ + 1);
}

auto ClauseParser::Command::caused() -> Read {
  if (const std::size_t done = parser_.caused(i_, end_, clause_); done != i_) return done;
  return {};
}

// "take the mug to fill it", "use the spoon to scoop ice cream": the next command begins behind "to"
auto ClauseParser::Command::purpose() -> Read {
  if (words_[i_] != "to" || i_ + 1 >= end_ || !parser_.opens_command(i_ + 1, end_) ||
      reader_.name_length(i_ + 1) > 0)
    return {};
  ended_ = true;
  return i_ + 1;
}

auto ClauseParser::Command::argument() -> Read {
  clause_.words.push_back(words_[i_]);
  const std::size_t done = parser_.argument(i_, end_, clause_, role_, where_);
  if (done == i_) clause_.words.pop_back();
  return done;
}

// "the kettle needs filling and then putting on the stove"
void ClauseParser::Command::same_as_before() {
  if (!people() || !words_[at_].ends_with("ing") || at_ == 0 || !language_.joins(words_[at_ - 1]) ||
      clause_.first(Role::kDirect) != nullptr || !after_command())
    return;
  if (const NounPhrase* thing = result_.clauses.back().first(Role::kDirect))
    clause_.phrases.insert(clause_.phrases.begin(), *thing);
}

}  // namespace goalnet::inference
