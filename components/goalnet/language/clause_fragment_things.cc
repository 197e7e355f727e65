// The things that a request without a verb begins with: "plates and cups", "all the cups except the mug", "a
// bowl of ice cream with syrup", "pillow from armchair 2".
#include <algorithm>

#include "components/goalnet/language/clause_fragment.h"

namespace goalnet::inference {

using namespace word_group;

// Reads them; `i_` is behind them.
void ClauseParser::Fragment::things() {
  i_ = reader_.read(at_, end_, subject_);
  clause_.phrases = {subject_};
  for (std::size_t k = at_; k < i_; ++k) clause_.words.push_back(words_[k]);
  more_things();
  left_out();
  served_with();
  sources();
  out_of();
}

// "plates and cups in the sink", "coke or beer please"
void ClauseParser::Fragment::more_things() {
  while (i_ < end_ && language_.joins(words_[i_])) {
    NounPhrase more;
    const std::size_t next = parser_.skip_joins(i_, end_), done = reader_.read(next, end_, more);
    if (done == next || parser_.starts_clause(next, end_)) return;
    if (subject_.phrase == "channel" && (is(done, "up") || is(done, "down"))) return;
    if (const std::size_t again = parser_.short_again(i_ + 1, end_, clause_); again != i_ + 1) {
      i_ = again;
      continue;
    }
    more.alternative = words_[i_] == "or";
    clause_.phrases.push_back(more);
    i_ = done;
  }
}

// "all the cups except the mug to the sink", "every book but the one on the table to the counter"
void ClauseParser::Fragment::left_out() {
  if (!people() || !(is(i_, "except") || is(i_, "but"))) return;
  NounPhrase left_out, there, goes_to;
  const std::size_t from = is(i_ + 1, "for") ? i_ + 2 : i_ + 1;
  std::size_t done = reader_.read(from, end_, left_out);
  if (const std::size_t after = reader_.read_place(done, end_, there);
      left_out.word == "one" && after != done && reader_.read_place(after, end_, goes_to) != after) {
    left_out.at.push_back(std::move(there));
    done = after;
  }
  if (done == from || left_out.person || left_out.unknown || done >= end_ ||
      !(place_preposition(words_[done]) || words_[done] == "off" || words_[done] == "from"))
    return;
  left_out.role = Role::kExcept;
  clause_.phrases.push_back(std::move(left_out));
  i_ = done;
}

// "a bowl of ice cream with syrup please"
void ClauseParser::Fragment::served_with() {
  const std::string& served = subject_.content.empty() ? subject_.phrase : subject_.content;
  if (!people() || !is(i_, "with") || language_.content(served) == symbol::kNone) return;
  NounPhrase with;
  const std::size_t done = reader_.read(i_ + 1, end_, with);
  if (done == i_ + 1 || with.person || with.unknown || with.pronoun) return;
  with.role = Role::kWith;
  clause_.phrases.push_back(std::move(with));
  i_ = done;
}

// "pillow from armchair 2 to the couch"
void ClauseParser::Fragment::sources() {
  while (is(i_, "from")) {
    NounPhrase source;
    const std::size_t done = reader_.read(i_ + 1, end_, source, true);
    if (done == i_ + 1 || source.person || source.unknown) return;
    for (NounPhrase& phrase : clause_.phrases) phrase.at.push_back(source);
    i_ = done;
  }
}

// "energy drink out of it and onto the counter"
void ClauseParser::Fragment::out_of() {
  if (i_ + 1 >= end_ || !(is(i_, "from") || is(i_, "out"))) return;
  NounPhrase source, to;
  std::size_t k = words_[i_ + 1] == "of" ? i_ + 2 : i_ + 1;
  k = std::max(reader_.read(k, end_, source, true), k);
  if (is(k, "there")) ++k;
  while (k < end_ && language_.joins(words_[k])) ++k;
  if (reader_.read_place(k, end_, to) == k || to.person || source.unknown || source.person) return;
  if (!source.pronoun && !source.bare()) clause_.phrases.front().at.push_back(source);
  i_ = k;
}

// "... And a pillow.", "the other plate too": what was asked before is asked of this as well.
bool ClauseParser::again(const Clause& fragment) {
  if (result_.clauses.empty()) return false;
  Clause same = result_.clauses.back();
  const bool instead = language_.hears_people() && same.mood == Mood::kForbidden &&
                       same.first(Role::kDirect) != nullptr;  // "don't wash the bowl, just the plates"
  if (same.mood != Mood::kCommand && !instead) return false;
  same.mood = Mood::kCommand;
  std::erase_if(same.phrases, [](const NounPhrase& phrase) {
    return phrase.role == Role::kDirect || phrase.role == Role::kSource;
  });
  same.phrases.insert(same.phrases.begin(), fragment.phrases.begin(), fragment.phrases.end());
  add(std::move(same));
  return true;
}

// Whether the part, which nobody could read, begins as no request does: with a thing that goes on with words
// that mean nothing here ("the right one sticks"). A thing alone, or with a place, may be a request.
bool ClauseParser::says_nothing_here(std::size_t at, std::size_t end) const {
  if (!language_.hears_people() || language_.english_verb(words_[at]) || !language_.known(words_[at]))
    return false;
  const std::size_t stop = part_end(at, end);
  NounPhrase subject;
  const std::size_t done = reader_.read(at, stop, subject);
  if (done == at || subject.unknown) return false;
  bool other_words = false;
  for (std::size_t i = done; i < stop; ++i) {
    if (reader_.name_length(i) > 0 || opens_command(i, stop)) return false;
    other_words = other_words || (!harmless(i) && !place_preposition(words_[i]));
  }
  return other_words;
}

}  // namespace goalnet::inference
