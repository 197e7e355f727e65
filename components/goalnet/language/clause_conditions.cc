// "if the tap is on, ...", "..., otherwise fill the glass".
#include <algorithm>

#include "components/goalnet/language/clause_parser.h"
#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {

using namespace word_group;

// What a condition says that was read as something else: how it is now.
void ClauseParser::as_state(Clause& clause) const {
  if (clause.wish && clause.frame == Frame::kFill && clause.phrases.size() == 2) {
    clause.phrases.front().content = clause.phrases.back().phrase;  // "there is no water in the kettle"
    clause.phrases.pop_back();
    clause.frame = Frame::kNone, clause.wish = false, clause.negative = true;
  }
  // "somebody put the remote on an armchair": it is there
  if (clause.frame == Frame::kPlace && clause.phrases.size() == 2 &&
      clause.phrases.back().role == Role::kDestination && !clause.phrases.front().pronoun) {
    clause.phrases.front().at = {clause.phrases.back()};
    clause.phrases.pop_back();
    clause.frame = Frame::kNone;
  }
  // "the tv is on channel three"
  if (clause.frame == Frame::kChange && clause.phrases.size() == 1 && clause.phrases.front().number > 0) {
    clause.state = "on";
    clause.frame = Frame::kNone, clause.wish = false;
  }
}

// "if the tap is on, turn it off"; `at` where nothing that could be judged follows.
std::size_t ClauseParser::condition(std::size_t at, std::size_t end) {
  ClauseParser inner(*all_words_, language_, *lexicon_);
  std::size_t stop = at + 1;
  while (stop < end && words_[stop] != "," && words_[stop] != "then" &&
         !(language_.hears_people() && words_[stop] == "otherwise") &&
         !(stop > at + 2 && opens_command(stop, end) &&
           language_.wanted_by_state(words_[stop]) == Frame::kNone &&
           !(language_.hears_people() && (words_[stop] == "free" || one_of(words_[stop], kLying)))))
    ++stop;
  // "fill the kettle if it is empty and boil it"
  const bool goes_on = language_.hears_people() && stop < end && stop > at + 2 && words_[stop - 1] == "and";
  if (goes_on) --stop;
  inner.judging_ = true;
  const std::size_t done = inner.statement(at + 1, stop);
  if (done < stop || !inner.result_.stray.empty() || inner.result_.clauses.size() != 1) return at;
  Clause clause = inner.result_.clauses.front();
  if (language_.hears_people()) as_state(clause);
  const bool says =
      !clause.state.empty() ||
      (!clause.phrases.empty() && (!clause.phrases.front().at.empty() ||
                                   (language_.hears_people() && !clause.phrases.front().content.empty())));
  if (clause.mood != Mood::kStatement || clause.frame != Frame::kNone || !says) return at;
  clause.negative = clause.negative != (words_[at] == "unless");
  const bool otherwise_follows =
      language_.hears_people() && skip_joins(stop, end) < end && words_[skip_joins(stop, end)] == "otherwise";
  const bool behind = goes_on && at > 0 && words_[at - 1] != "," && words_[at - 1] != ".";
  const bool trails =
      stop >= end || otherwise_follows || behind;  // "close it if it is open(, otherwise ...)"
  Clause& under = !result_.clauses.empty() && trails ? result_.clauses.back() : conditional_;
  under.condition = {clause};
  under.condition_number = ++conditions_, under.otherwise = false;
  return stop;
}

// "..., otherwise fill the glass": what is to be done where the last condition does not hold.
std::size_t ClauseParser::otherwise(std::size_t at, std::size_t end) {
  const auto last = std::find_if(result_.clauses.rbegin(), result_.clauses.rend(),
                                 [](const Clause& clause) { return clause.condition_number > 0; });
  if (!language_.hears_people()) return at;
  if (last == result_.clauses.rend())  // "is the stove off? if not, turn it off"
    return !result_.clauses.empty() && result_.clauses.back().mood == Mood::kQuestion
               ? skip_joins(at + 1, end)
               : at;
  conditional_.condition = last->condition, conditional_.condition_number = last->condition_number;
  conditional_.otherwise = !last->otherwise;
  const std::size_t next = skip_joins(at + 1, end);
  // "put the plate on the table, otherwise on the counter"
  if (NounPhrase place; last->frame == Frame::kPlace || last->frame == Frame::kBring) {
    const std::size_t done = reader_.read_place(next, end, place);
    if (done == next || place.person || place.hand || !ends_here(done, end)) return next;
    Clause other = *last;
    std::erase_if(other.phrases, [](const NounPhrase& old) { return old.role == Role::kDestination; });
    place.role = Role::kDestination;
    other.phrases.push_back(std::move(place));
    other.otherwise = conditional_.otherwise;
    add(std::move(other));
    return done;
  }
  return next;
}

}  // namespace goalnet::inference
