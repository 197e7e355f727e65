// The things that a request without a verb begins with: "plates and cups", "all the cups except the mug", "a
// bowl of ice cream with syrup", "pillow from armchair 2".
#include <algorithm>

#include "components/goalnet/language/clause_parser.h"
#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {

using namespace word_group;

std::size_t ClauseParser::things_of_fragment(std::size_t at, std::size_t end, Clause& clause,
                                             NounPhrase& subject) {
  std::size_t i = reader_.read(at, end, subject);
  clause.phrases = {subject};
  for (std::size_t k = at; k < i; ++k) clause.words.push_back(words_[k]);
  while (i < end && language_.joins(words_[i])) {  // "plates and cups in the sink"
    NounPhrase more;
    const std::size_t next = skip_joins(i, end), done = reader_.read(next, end, more);
    if (done == next || starts_clause(next, end)) break;
    if (done < end && subject.phrase == "channel" && (words_[done] == "up" || words_[done] == "down")) break;
    if (const std::size_t again = short_again(i + 1, end, clause); again != i + 1) {
      i = again;
      continue;
    }
    more.alternative = words_[i] == "or";  // "coke or beer please"
    clause.phrases.push_back(more);
    i = done;
  }
  // "all the cups except the mug to the sink"
  if (NounPhrase left_out;
      language_.hears_people() && i < end && (words_[i] == "except" || words_[i] == "but")) {
    const std::size_t from = i + 1 < end && words_[i + 1] == "for" ? i + 2 : i + 1;
    std::size_t done = reader_.read(from, end, left_out);
    NounPhrase there, goes_to;  // "every book but the one on the table to the counter"
    if (const std::size_t after = reader_.read_place(done, end, there);
        left_out.word == "one" && after != done && reader_.read_place(after, end, goes_to) != after) {
      left_out.at.push_back(std::move(there));
      done = after;
    }
    if (done != from && !left_out.person && !left_out.unknown && done < end &&
        (place_preposition(words_[done]) || words_[done] == "off" || words_[done] == "from")) {
      left_out.role = Role::kExcept;
      clause.phrases.push_back(std::move(left_out));
      i = done;
    }
  }
  // "a bowl of ice cream with syrup please"
  if (NounPhrase with;
      language_.hears_people() && i < end && words_[i] == "with" &&
      language_.content(subject.content.empty() ? subject.phrase : subject.content) != symbol::kNone) {
    const std::size_t done = reader_.read(i + 1, end, with);
    if (done != i + 1 && !with.person && !with.unknown && !with.pronoun) {
      with.role = Role::kWith;
      clause.phrases.push_back(std::move(with));
      i = done;
    }
  }
  while (i < end && words_[i] == "from") {  // "pillow from armchair 2 to the couch"
    NounPhrase source;
    const std::size_t done = reader_.read(i + 1, end, source, true);
    if (done == i + 1 || source.person || source.unknown) break;
    for (NounPhrase& phrase : clause.phrases) phrase.at.push_back(source);
    i = done;
  }
  // "energy drink out of it and onto the counter"
  if (i + 1 < end && (words_[i] == "from" || words_[i] == "out")) {
    std::size_t k = words_[i + 1] == "of" ? i + 2 : i + 1;
    NounPhrase source;
    k = std::max(reader_.read(k, end, source, true), k);
    if (k < end && words_[k] == "there") ++k;
    while (k < end && language_.joins(words_[k])) ++k;
    NounPhrase to;
    if (reader_.read_place(k, end, to) != k && !to.person && !source.unknown && !source.person) {
      if (!source.pronoun && !source.bare()) clause.phrases.front().at.push_back(source);
      i = k;
    }
  }
  return i;
}

// "pillow 4 armchair 4", "plate bowl both counter": things side by side, then the place where they go; `at`
// where it is none.
std::size_t ClauseParser::things_then_place(std::size_t at, std::size_t end, Clause& clause) {
  const NounPhrase& first = clause.phrases.front();
  if (!language_.hears_people() || first.bare() || first.pronoun || first.unknown || first.person ||
      first.everything || lexicon_->is_place_name(first.phrase))
    return at;
  bool both = clause.phrases.size() > 1;  // "plate and bowl counter"
  for (std::size_t i = at; i < end;) {
    if (words_[i] == "both" || words_[i] == "all") {
      ++i, both = true;
      continue;
    }
    NounPhrase next;
    const std::size_t done = reader_.read(i, end, next);
    if (done == i || next.bare() || next.pronoun || next.unknown || next.person || next.everything) return at;
    i = done;
    if (!lexicon_->is_place_name(next.phrase) || language_.holds_things(next.phrase)) {
      clause.phrases.push_back(std::move(next));
      continue;
    }
    const bool several = clause.phrases.size() > 1 || !clause.phrases.front().modifier.empty();
    if (!ends_here(i, end) || (several && !both)) return at;  // "mug kettle sink" may mean anything
    next.role = Role::kDestination, next.where = Where::kTo;
    for (std::size_t k = 0; k < clause.phrases.size(); ++k) {  // "plate bowl" are two things
      NounPhrase& thing = clause.phrases[k];
      if (thing.modifier.empty() || lexicon_->is_place_name(thing.modifier)) continue;
      NounPhrase other;
      other.phrase = other.word = thing.modifier, other.plural = thing.modifier_plural;
      thing.modifier.clear();
      clause.phrases.push_back(std::move(other));
    }
    clause.phrases.push_back(std::move(next));
    clause.frame = Frame::kPlace, clause.verb = "put";
    add(std::move(clause));
    return i;
  }
  return at;
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

// "everything off the stove", "spoon out of the mug", "a pillow for every armchair", "one cup for coke": adds
// the clause; `i` where it is none.
std::size_t ClauseParser::off_or_for(std::size_t i, std::size_t end, Clause& clause,
                                     const NounPhrase& subject) {
  NounPhrase place;
  const bool out_of = language_.hears_people() && i + 2 < end && words_[i] == "out" && words_[i + 1] == "of";
  if (i + 1 < end && (words_[i] == "off" || out_of)) {  // "everything off the stove", "spoon out of the mug"
    const std::size_t from = out_of ? i + 2 : i + 1;
    const std::size_t done = reader_.read(from, end, place, true);
    NounPhrase to;
    const bool moves = out_of && reader_.read_place(done, end, to) != done;
    if (done != from && !place.unknown && !place.person && !moves) {
      clause.frame = Frame::kTake, clause.verb = "take";
      place.role = Role::kSource;
      clause.phrases.push_back(place);
      add(std::move(clause));
      return done;
    }
    place = {};
  }
  if (i + 1 < end && words_[i] == "for") {  // "a pillow for every armchair"
    const std::size_t done = reader_.read(i + 1, end, place, true);
    // "one long cup for coke"
    if (language_.hears_people() && done != i + 1 && ends_here(done, end) &&
        language_.content(place.phrase) != symbol::kNone && language_.holds_things(subject.phrase) &&
        subject.content.empty()) {
      clause.frame = Frame::kFill, clause.verb = "fill";
      place.role = Role::kWith;
      clause.phrases.push_back(std::move(place));
      add(std::move(clause));
      return done;
    }
    const bool holder = language_.hears_people() && !place.unknown && !place.person &&
                        (lexicon_->is_place_name(place.phrase) || language_.holds_things(place.phrase) ||
                         (subject.some && language_.content(place.phrase) != symbol::kNone));
    if (done != i + 1 && (place.all || holder) && (lexicon_->is_place_name(place.phrase) || holder)) {
      clause.frame = Frame::kPlace, clause.verb = "put";
      place.role = Role::kDestination,
      place.where = language_.holds_things(place.phrase) ? Where::kIn : Where::kOn;
      clause.phrases.push_back(place);
      add(std::move(clause));
      return done;
    }
    place = {};
  }
  return i;
}

}  // namespace goalnet::inference
