// What is left out or denied: "all but the mug", "the book, not the one on the couch", "on the table rather
// than on the couch".
#include "components/goalnet/language/clause_parser.h"
#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {

using namespace word_group;

std::size_t ClauseParser::instead_of(std::size_t at, std::size_t end, Clause& clause) {
  if (!language_.hears_people() || at + 2 >= end) return at;
  const bool denied = words_[at] == "not";
  const bool other = (words_[at] == "rather" && words_[at + 1] == "than") ||
                     (words_[at] == "instead" && words_[at + 1] == "of");
  if (!denied && !other) return at;
  const std::size_t from = at + (denied ? 1 : 2);
  NounPhrase place, thing;
  if (const std::size_t done = reader_.read_place(from, end, place); done != from && !place.person)
    return done;
  if (denied) return at;
  const std::size_t done = reader_.read(from, end, thing);
  if (done == from || thing.person || thing.unknown || clause.phrases.empty()) return at;
  if (!lexicon_->is_place_name(thing.phrase)) {
    thing.role = Role::kExcept;
    clause.phrases.push_back(std::move(thing));
  }
  return done;
}

std::size_t ClauseParser::except(std::size_t at, std::size_t end, Clause& clause) {
  if (!language_.hears_people() || words_[at] != "except" || clause.mood != Mood::kCommand) return at;
  const std::size_t from = at + 1 < end && words_[at + 1] == "for" ? at + 2 : at + 1;
  NounPhrase left_out, there;
  const std::size_t done = reader_.read(from, end, left_out);
  if (done == from || left_out.person || left_out.unknown) return at;
  const std::size_t after = reader_.read_place(done, end, there);
  if (after != done) left_out.at.push_back(there);
  left_out.role = Role::kExcept;
  clause.phrases.push_back(std::move(left_out));
  return after;
}

// "not the one on the couch", "not the mug": reads it from "not" on; `at` where no thing is denied.
std::size_t ClauseParser::denied(std::size_t at, std::size_t end, NounPhrase& phrase) const {
  if (at + 1 >= end || words_[at] != "not") return at;
  NounPhrase there;
  const std::size_t done = reader_.read(at + 1, end, phrase);
  if (done == at + 1 || (phrase.person && language_.hears_people())) return at;
  phrase.role = Role::kExcept;
  const bool one = phrase.word == "one" || phrase.word == "that";
  const std::size_t after = language_.hears_people() && one ? reader_.read_place(done, end, there) : done;
  if (after != done) phrase.at.push_back(std::move(there));
  return after;
}

// "(bring me a book.) Not the one on the couch.": of what was asked before; `at` where it is none.
std::size_t ClauseParser::not_that_one(std::size_t at, std::size_t end) {
  NounPhrase other;
  const std::size_t done = denied(at, end, other);
  if (!language_.hears_people() || done == at || other.at.empty() || !ends_here(done, end) ||
      result_.clauses.empty())
    return at;
  Clause& last = result_.clauses.back();
  const NounPhrase* asked = last.first(Role::kDirect);
  if (last.mood != Mood::kCommand || asked == nullptr || asked->pronoun ||
      (other.word != "one" && other.phrase != asked->phrase))
    return at;
  last.phrases.push_back(std::move(other));
  return done;
}

// "everything on the couch except the xbox (should go on the table)": what stands before the verb, from the
// end of the subject's name on; `at` where nothing is left out.
std::size_t ClauseParser::subject_but(std::size_t at, std::size_t end, NounPhrase& subject,
                                      NounPhrase& left_out) const {
  if (!language_.hears_people() || at >= end) return at;
  NounPhrase place, other;
  const std::size_t but = reader_.read_place(at, end, place);
  if (but + 1 >= end || (words_[but] != "except" && words_[but] != "but")) return at;
  const std::size_t from = words_[but + 1] == "for" ? but + 2 : but + 1;
  const std::size_t named = reader_.read(from, end, other);
  NounPhrase there;
  const std::size_t done = named == from ? from : reader_.read_place(named, end, there);
  if (done != named) other.at.push_back(std::move(there));
  if (done == from || done >= end || other.person || other.unknown ||
      !(language_.copula(words_[done]) || one_of(words_[done], kDesire) || words_[done] == "can"))
    return at;
  if (but != at) subject.at.push_back(std::move(place));
  left_out = std::move(other);
  left_out.role = Role::kExcept;
  return done;
}

// "only burner four should be on": that one, and no other; `at` where it is none.
std::size_t ClauseParser::only_on(std::size_t at, std::size_t end) {
  if (!language_.hears_people() || words_[at] != "only") return at;
  NounPhrase thing;
  const std::size_t named = reader_.read(at + 1, end, thing);
  if (named == at + 1 || thing.person || thing.unknown || thing.pronoun || thing.bare()) return at;
  std::size_t k = named;
  bool wanted = false;
  for (; k < end && (language_.copula(words_[k]) || one_of(words_[k], kDesire)); ++k)
    wanted = wanted || one_of(words_[k], kDesire);
  if (!wanted || k >= end || language_.wanted_by_state(words_[k]) != Frame::kStart || !ends_here(k + 1, end))
    return at;
  Clause on, off;
  on.frame = Frame::kStart, on.verb = "start", on.phrases = {thing};
  off.frame = Frame::kStop, off.verb = "stop";
  NounPhrase all;
  all.phrase = all.word = thing.phrase, all.all = all.plural = true;
  thing.role = Role::kExcept;
  off.phrases = {std::move(all), std::move(thing)};
  add(std::move(off));
  add(std::move(on));
  return part_end(k + 1, end);
}

// "do not bring the coke but the beer": the second is asked for. `before`: clauses before it was read.
void ClauseParser::but_this(std::size_t before) {
  if (!language_.hears_people() || result_.clauses.size() != before + 1) return;
  Clause& forbidden = result_.clauses.back();
  const NounPhrase* not_this = forbidden.first(Role::kDirect);
  if (forbidden.mood != Mood::kForbidden || not_this == nullptr || not_this->everything || not_this->all ||
      not_this->plural || forbidden.first(Role::kExcept) == nullptr)
    return;
  Clause asked = forbidden;
  std::erase_if(asked.phrases, [](const NounPhrase& phrase) { return phrase.role == Role::kDirect; });
  for (NounPhrase& phrase : asked.phrases)
    if (phrase.role == Role::kExcept) phrase.role = Role::kDirect;
  asked.mood = Mood::kCommand;
  std::erase_if(forbidden.phrases, [](const NounPhrase& phrase) { return phrase.role == Role::kExcept; });
  add(std::move(asked));
}

}  // namespace goalnet::inference
