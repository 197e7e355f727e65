// Sentences that are no plain commands: statements, wishes, questions.
#include <algorithm>
#include <array>

#include "components/goalnet/language/clause_statement.h"

namespace goalnet::inference {

using namespace word_group;

std::size_t ClauseParser::statement(std::size_t at, std::size_t end) {
  return Statement(*this, at, end).read();
}

std::size_t ClauseParser::Statement::read() {
  desired_ = parser_.ensured_;
  there_ = words_[at_] == "there" || words_[at_] == "here";
  if (const Read done = there_should_be()) return *done;
  if (there_)
    if (const std::size_t done = parser_.there_is_no(at_, end_); done != at_) return done;
  if (there_) skip_there();
  if (parser_.judging_)
    if (const std::size_t done = parser_.is_anything(at_, end_); done != at_) return done;
  if (const std::size_t done = parser_.nothing_should(at_, end_); done != at_) return done;
  if (const Read done = about_somebody()) return *done;
  if (const Read done = louder()) return *done;
  named_ = reader_.read(i_, end_, subject_);
  if (const Read done = names_nothing(subject_.person)) return *done;
  i_ = named_;
  return about_subjects();
}

// "there should be a beer on the shelf": mostly tells where it is
auto ClauseParser::Statement::there_should_be() -> Read {
  if (!there_ || !is(at_ + 2, "be") || parser_.ensured_ ||
      !(words_[at_ + 1] == "should" || (words_[at_ + 1] == "must" && people())))
    return {};
  const std::size_t count = result_.clauses.size();
  parser_.ensured_ = true;
  const std::size_t done = parser_.statement(at_ + 3 < end_ ? at_ + 3 : at_, end_);
  parser_.ensured_ = false;
  for (std::size_t k = count; k < result_.clauses.size(); ++k) {
    result_.clauses[k].supposed = true;
    if (result_.clauses[k].mood == Mood::kCommand)
      result_.clauses[k].mood = Mood::kStatement, result_.clauses[k].wish = true;
  }
  return done;
}

void ClauseParser::Statement::skip_there() {
  for (++i_; i_ < end_ && language_.copula(words_[i_]); ++i_)
    desired_ = desired_ || one_of(words_[i_], kDesire);
}

// "I am thirsty", "you left the tap on", "somebody spilled the coffee"
auto ClauseParser::Statement::about_somebody() -> Read {
  static constexpr std::array kSpeakers = {"i"sv,       "we"sv,      "you"sv,     "he"sv,
                                           "she"sv,     "whoever"sv, "im"sv,      "somebody"sv,
                                           "someone"sv, "nobody"sv,  "everyone"sv};
  const bool somebody = somebody_left();
  const std::string& word = words_[i_ < end_ ? i_ : at_];
  if (!somebody && !one_of(word, kSpeakers) && language_.wish(word) == nullptr) return {};
  const std::size_t stop = parser_.skip_part(i_, end_);
  if (const Read done = thirsty(stop)) return done;
  for (std::size_t k = i_ + 1; k < stop; ++k)
    if (const Read done = what_somebody_did(k, stop)) return done;
  Clause clause;
  clause.mood = Mood::kStatement;
  parser_.add(std::move(clause));
  return stop;
}

// "the children have left the television running": goes on with "left"
bool ClauseParser::Statement::somebody_left() {
  static constexpr std::array kHave = {"left"sv, "have"sv, "has"sv, "had"sv, "forgot"sv};
  if (!people() || i_ >= end_) return false;
  NounPhrase who;
  const std::size_t done = reader_.read(i_, end_, who);
  if (done == i_ || !who.person || done + 1 >= end_ || !one_of(words_[done], kHave) ||
      !any_word(done, parser_.part_end(i_, end_),
                [&](const std::string& word) { return language_.verb_base(word) == "leave"; }))
    return false;
  i_ = done - 1;
  return true;
}

// "I am thirsty": what somebody wants who is so
auto ClauseParser::Statement::thirsty(std::size_t stop) -> Read {
  for (std::size_t k = i_; k < stop; ++k) {
    const auto* wish = language_.wish(words_[k]);
    if (wish == nullptr) continue;
    Words words;
    words.text = *wish;
    words.plural.assign(words.text.size(), false);
    for (Clause& clause : ClauseParser(words, language_, lexicon_).parse().clauses) {
      clause.mood = Mood::kStatement, clause.wish = true;
      parser_.add(std::move(clause));
    }
    return stop;
  }
  return {};
}

// "you (left the tap on)", "I (forgot to close the fridge)", "somebody (spilled) the coffee"
auto ClauseParser::Statement::what_somebody_did(std::size_t k, std::size_t stop) -> Read {
  static constexpr std::array kSkipped = {"can"sv, "could"sv, "not"sv, "will"sv};
  static constexpr std::array kForgot = {"forgot"sv, "forget"sv, "forgotten"sv};
  if (one_of(words_[k], kSkipped)) return {};
  if (one_of(words_[k], kForgot) && k + 2 < end_ && words_[k + 1] == "to" &&
      parser_.opens_command(k + 2, end_)) {
    const std::size_t done = parser_.command(k + 2, end_, Mood::kStatement);
    result_.clauses.back().wish = true;
    return done;
  }
  if (words_[k] == "and" && parser_.starts_clause(parser_.skip_joins(k, end_), end_)) return k;
  if (parser_.opens_command(k, end_) &&
      (language_.verb_base(words_[k]) == "leave" || language_.participle(words_[k]) ||
       language_.verb(words_[k]) != Frame::kNone))
    return parser_.command(k, end_, Mood::kStatement);
  NounPhrase named;
  const std::size_t done = reader_.read(k, stop, named);
  if (done == k || named.phrase.empty()) return {};
  Clause clause;
  clause.mood = Mood::kStatement;
  clause.phrases = {named};
  parser_.add(std::move(clause));
  return parser_.predicate(done, end_, result_.clauses.back(), false, false);
}

// "louder please"
auto ClauseParser::Statement::louder() -> Read {
  const Frame sound = i_ < end_ ? language_.wanted_by_state(words_[i_]) : Frame::kNone;
  if (sound != Frame::kRaise && sound != Frame::kLower) return {};
  Clause clause;
  clause.frame = sound, clause.verb = words_[i_];
  clause.phrases.emplace_back();
  clause.phrases.back().phrase = clause.phrases.back().word = "volume";
  parser_.add(std::move(clause));
  return i_ + 1;
}

auto ClauseParser::Statement::names_nothing(bool person) -> Read {
  const bool named = named_ != i_;
  if (const std::size_t stop = parser_.part_end(at_, end_);
      people() && !parser_.ensured_ && !named && parser_.tells(at_, stop) && !language_.asks(words_[at_])) {
    result_.passed.push_back(words_[at_]);  // "three is broken"
    parser_.add_told(at_, stop);
    return stop;
  }
  if (named && !person) return {};
  // "hey rosie, ...": what somebody is called
  const bool name_of_somebody = is(i_ + 1, ",") && !language_.known(words_[i_]);
  if (i_ < end_ && !parser_.harmless(i_) && !name_of_somebody) result_.stray.push_back(words_[i_]);
  return i_ + 1;
}

std::size_t ClauseParser::Statement::about_subjects() {
  if (people() && i_ + 1 < end_ && is_pronoun(words_[i_]) &&
      (one_of(words_[i_ + 1], kDesire) || language_.copula(words_[i_ + 1])))
    ++i_;  // "the mug it must be put into the sink"
  places_of_subject();
  subjects();
  verbs();
  if (people() && desired_ && (is(i_, "come") || is(i_, "move")))
    verb_seen_ = true;  // "could the plate come down from the shelf?"
  if (!verb_seen_) return parser_.fragment(at_, end_);
  Clause clause;
  clause.mood = Mood::kStatement;
  static constexpr std::array kShows = {"has"sv, "have"sv, "show"sv, "play"sv};
  if (people() && subject_.phrase == "channel" && subject_.number > 0 && !negative_ && named_ < end_ &&
      one_of(words_[named_], kShows)) {  // "channel one has the news": like "the news is on ..."
    clause.frame = Frame::kChange, clause.verb = "change", clause.wish = true;
    clause.phrases = {subject_};
    parser_.add(std::move(clause));
    return parser_.part_end(i_, end_);
  }
  clause.phrases = subjects_;
  clause.phrases.front() = subject_;
  clause.negative = negative_, clause.supposed = supposed_;
  parser_.add(std::move(clause));
  Clause& last = result_.clauses.back();
  if (desired_ && !negative_ && i_ > 0 && (i_ >= end_ || language_.joins(words_[i_])) &&
      (words_[i_ - 1] == "go" || words_[i_ - 1] == "goe") && !subject_.at.empty()) {
    last.mood = Mood::kCommand, last.frame = Frame::kClear, last.verb = "clear";  // "... has to go"
    return i_;
  }
  return parser_.predicate(i_, end_, last, desired_, negative_);
}

}  // namespace goalnet::inference
