#include "components/goalnet/language/clause_parser.h"

#include <algorithm>
#include <array>

#include "components/goalnet/language/clause_start.h"
#include "components/goalnet/language/ellipsis.h"

namespace goalnet::inference {

void ClauseParser::add(Clause clause) {
  if (clause.mood == Mood::kCommand && clause.condition.empty()) {
    clause.condition = conditional_.condition;
    clause.condition_number = conditional_.condition_number, clause.otherwise = conditional_.otherwise;
  }
  if (insert_before_ < result_.clauses.size()) {
    // "before putting the mug away, wash it": "it" was named by the clause that is done later
    name_pronouns(clause, result_.clauses[insert_before_]);
    result_.clauses.insert(result_.clauses.begin() + static_cast<long>(insert_before_), std::move(clause));
    insert_before_ = SIZE_MAX;
  } else {
    result_.clauses.push_back(std::move(clause));
  }
}

void ClauseParser::name_pronouns(Clause& clause, const Clause& by) const {
  const NounPhrase* named = by.first(Role::kDirect);
  if (named == nullptr || named->pronoun) return;
  for (NounPhrase& phrase : clause.phrases) {
    if (!phrase.pronoun || phrase.word == "there") continue;
    const Role role = phrase.role;
    const Where where = phrase.where;
    phrase = *named;
    phrase.role = role, phrase.where = where;
  }
}

ParsedSentence ClauseParser::parse() {
  for (std::size_t begin = 0; begin < words_.size();) {
    std::size_t end = begin;
    while (end < words_.size() && words_[end] != ".") ++end;
    for (std::size_t at = begin; at < end;) {
      const std::size_t next = clause(at, end);
      at = std::max(next, at + 1);
    }
    fronted_.clear();
    conditional_ = {};
    begin = end + 1;
  }
  return std::move(result_);
}

std::size_t ClauseParser::clause(std::size_t at, std::size_t end) {
  return ClauseStart(*this, at, end).read();
}

std::size_t ClauseParser::ClauseStart::read() {
  static constexpr std::array<Rule, 16> kRules = {
      &ClauseStart::by_first_word,  &ClauseStart::let,
      &ClauseStart::with_tool,      &ClauseStart::later,
      &ClauseStart::excepted,       &ClauseStart::correction,
      &ClauseStart::wish,           &ClauseStart::addressed,
      &ClauseStart::asked_not,      &ClauseStart::cannot,
      &ClauseStart::could_it_be,    &ClauseStart::subordinate,
      &ClauseStart::command,        &ClauseStart::place_first,
      &ClauseStart::called_by_name, &ClauseStart::verb_nobody_knows};
  if (const Read done = set_aside()) return *done;
  if (const Read done = first_that_fits({&ClauseParser::third_person})) return *done;
  if (const Read done = whoever()) return *done;
  if (const Read done =
          first_that_fits({&ClauseParser::none_there, &ClauseParser::idle, &ClauseParser::of_the_same}))
    return *done;
  i_ = parser_.skip_joins(at_, end_);
  if (i_ >= end_) return i_;
  if (i_ > at_) parser_.first_of_all(at_, i_, end_);
  if (i_ > at_)
    if (const Read done = first_that_fits({&ClauseParser::no_thing})) return *done;
  if (const Read done = first_that_fits({&ClauseParser::third_person, &ClauseParser::idle,
                                         &ClauseParser::none_there, &ClauseParser::has_to_be}))
    return *done;
  for (const Rule rule : kRules)
    if (const Read done = (this->*rule)()) return *done;
  if (const Read done =
          first_that_fits({&ClauseParser::narrows, &ClauseParser::topic, &ClauseParser::verb_last}))
    return *done;
  if (const std::size_t stop = parser_.exclamation(i_, end_); stop != i_) return stop;
  if (const Read done = first_that_fits({&ClauseParser::told, &ClauseParser::aside})) return *done;
  return parser_.statement(i_, end_);
}

auto ClauseParser::ClauseStart::first_that_fits(std::initializer_list<Reader> readers) -> Read {
  for (const Reader reader : readers)
    if (const std::size_t done = (parser_.*reader)(i_, end_); done != i_) return done;
  return {};
}

// what a part named that was set aside
auto ClauseParser::ClauseStart::set_aside() -> Read {
  if (word() != "told_of") return {};
  const std::size_t stop = parser_.skip_part(i_, end_);
  parser_.add_told(i_ + 1, stop);
  return stop;
}

// "whoever left the tap on should be ashamed"
auto ClauseParser::ClauseStart::whoever() -> Read {
  if (!people() || word() != "whoever") return {};
  const std::size_t stop = parser_.part_end(i_, end_);
  parser_.add_told(i_, stop);
  return stop;
}

auto ClauseParser::ClauseStart::by_first_word() -> Read {
  if (word() == "not" || word() == "never" || word() == "without") return parser_.forbidden(i_, end_);
  if (word() == "ensure") return parser_.ensured(i_, end_);
  return {};
}

// "let the water run"
auto ClauseParser::ClauseStart::let() -> Read {
  if (word() != "let") return {};
  NounPhrase phrase;
  const std::size_t done = reader_.read(i_ + 1, end_, phrase);
  if (done == i_ + 1 || phrase.person || !opens_command(done)) return i_ + 1;
  parser_.fronted_ = {phrase};
  return parser_.command(done, end_, Mood::kCommand);
}

// "in an hour, turn the tv off": nobody here keeps time
auto ClauseParser::ClauseStart::later() -> Read {
  if (word() != "at_later") return {};
  const std::size_t next = parser_.skip_joins(i_ + 1, end_);
  const bool behind = i_ > 0 && words_[i_ - 1] != "." && words_[i_ - 1] != "," && after_command();
  if (behind || opens_command(next)) parser_.for_later();
  return i_ + 1;
}

// "all of the books should be on the table, except for the one on the shelf", "only the snacks may stay"
auto ClauseParser::ClauseStart::excepted() -> Read {
  if (!result_.clauses.empty())
    if (const std::size_t done = parser_.except(i_, end_, result_.clauses.back()); done != i_) return done;
  return first_that_fits({&ClauseParser::says_which});
}

// Where the sentence takes a turn; "bring the beer, no, I still have to drive, so the coke".
auto ClauseParser::ClauseStart::correction() -> Read {
  if (word() == "do_that") return parser_.done_that(i_, end_);
  if (word() == "hint") return parser_.hint(i_, end_);
  const bool taken_back =
      people() && word() == "no" && i_ > 0 && words_[i_ - 1] == "," && is(i_ + 1, ",") && after_command();
  if (word() == "correction" || taken_back) return parser_.correction(i_, end_);
  if (word() == "wish_to") return parser_.wish_to(i_, end_);
  return {};
}

ParsedSentence parse_clauses(const Words& words, const Language& language, const Lexicon& lexicon) {
  if (!language.hears_people()) return ClauseParser(words, language, lexicon).parse();
  const Words whole = fill_ellipses(words, language, lexicon);
  return ClauseParser(whole, language, lexicon).parse();
}

}  // namespace goalnet::inference
