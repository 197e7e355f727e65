// Corrections by a thing or a place: "no wait, the fork", "I mean the tv", "sorry, the shelf".
#include <algorithm>

#include "components/goalnet/language/clause_correction.h"

namespace goalnet::inference {

std::size_t ClauseParser::Correction::thing() {
  read_thing();
  place_of_thing();
  suffices();
  for (const Rule rule : {&Correction::count, &Correction::goes_on})
    if (const Read done = (this->*rule)()) return *done;
  if (done_ == next_ || !parser_.ends_here(done_, end_)) return next_;
  as_unknown_or_only_place();
  for (const Rule rule :
       {&Correction::same_number, &Correction::in_place_of_denied, &Correction::other_source})
    if (const Read done = (this->*rule)()) return *done;
  return in_its_place();
}

// Reads what is meant; behind a place without a preposition it may be a place: "on plate one, sorry, plate
// two".
void ClauseParser::Correction::read_thing() {
  done_ = reader_.read_place(next_, end_, phrase_);
  role_ = Role::kDestination;
  if (done_ != next_) return;
  const NounPhrase* there = last_->first(Role::kDestination);
  const bool number = number_word(words_[next_]) > 0 && there != nullptr;
  done_ = reader_.read(next_, end_, phrase_, number && people());
  const bool again =
      people() && there != nullptr && !phrase_.phrase.empty() && there->phrase == phrase_.phrase;
  const bool place = there != nullptr && (again || lexicon_.is_place_name(phrase_.phrase));
  role_ = place ? Role::kDestination : Role::kDirect;
  if (place) phrase_.where = there->where;
}

// "put the lid, no, the plate on the counter"
void ClauseParser::Correction::place_of_thing() {
  if (role_ != Role::kDirect || done_ == next_) return;
  NounPhrase place;
  const std::size_t after = reader_.read_place(done_, end_, place);
  if (after == done_ || place.person || !parser_.ends_here(after, end_) ||
      last_->first(Role::kDestination) != nullptr)
    return;
  done_ = after;
  if ((last_->frame == Frame::kTake || last_->frame == Frame::kBring) && people() && !phrase_.pronoun) {
    phrase_.at.push_back(place);  // "the book from the shelf, no, the one on the table"
    return;
  }
  place.role = Role::kDestination;
  last_->phrases.push_back(std::move(place));
}

// "one book, no, two of them"
auto ClauseParser::Correction::count() -> Read {
  if (!people() || !phrase_.pronoun || phrase_.count == 0 || done_ == next_) return {};
  for (NounPhrase& old : last_->phrases) {
    if (old.role != Role::kDirect || old.pronoun) continue;
    old.count = phrase_.count, old.plural = phrase_.count > 1, old.all = false;
    return parser_.part_end(done_, end_);
  }
  return {};
}

// "pour half, no, all of the coffee from the mug into the glass": the same verb with all that
auto ClauseParser::Correction::goes_on() -> Read {
  if (!people() || done_ == next_ || parser_.ends_here(done_, end_) || role_ != Role::kDirect ||
      phrase_.unknown || !(place_preposition(words_[done_]) || words_[done_] == "from"))
    return {};
  return command_anew();
}

// The last command's verb with what is meant and all that follows.
std::size_t ClauseParser::Correction::command_anew() {
  Clause anew = result_.clauses.back();
  anew.phrases.clear(), anew.particles.clear(), anew.unknown.clear(), anew.state.clear();
  anew.words = {anew.verb};
  Role role = Role::kDirect;
  Where where = Where::kTo;
  std::size_t i = next_;
  while (i < end_ && words_[i] != ",") {
    anew.words.push_back(words_[i]);
    const std::size_t done = parser_.argument(i, end_, anew, role, where);
    if (done == i) break;
    i = done;
  }
  result_.clauses.pop_back();
  return parser_.end_command(std::move(anew), i, end_);
}

// "go to the window, I mean the tv"
void ClauseParser::Correction::as_unknown_or_only_place() {
  for (const NounPhrase& old : last_->phrases)
    if (old.unknown || (old.role == Role::kDestination && last_->phrases.size() == 1))
      role_ = old.role, phrase_.where = old.where;
}

// "put on five, the channel I mean": says the same
auto ClauseParser::Correction::same_number() -> Read {
  if (!people() || told_which() || phrase_.number != 0 || phrase_.ordinal != 0 || phrase_.count != 0 ||
      !phrase_.adjectives.empty() || !phrase_.at.empty() || phrase_.plural ||
      std::none_of(last_->phrases.begin(), last_->phrases.end(), [&](const NounPhrase& old) {
        return old.number > 0 && !old.phrase.empty() && old.phrase == phrase_.phrase;
      }))
    return {};
  return done_;
}

// "the fork and the plate, no, not the plate, the spoon": only that one
auto ClauseParser::Correction::in_place_of_denied() -> Read {
  if (!told_which()) return {};
  for (NounPhrase& old : last_->phrases) {
    if (!denies(old)) continue;
    phrase_.role = old.role, phrase_.where = old.where;
    old = std::move(phrase_);
    return done_;
  }
  return {};
}

// "move the pillow from armchair one to armchair four, I mean from armchair two"
auto ClauseParser::Correction::from_elsewhere() -> Read {
  NounPhrase source;
  const std::size_t from = is(next_, "from") ? next_ + 1 : next_;  // a small word, skipped before
  if (!people() || !is(from - 1, "from")) return {};
  const std::size_t done = reader_.read(from, end_, source, true);
  if (done == from || source.person || source.unknown || !parser_.ends_here(done, end_)) return {};
  std::erase_if(last_->phrases, [](const NounPhrase& old) { return old.role == Role::kSource; });
  for (NounPhrase& old : last_->phrases)
    if (old.role == Role::kDirect) old.at.clear();
  source.role = Role::kSource;
  last_->phrases.push_back(std::move(source));
  return done;
}

// "take the book from the couch, sorry, the shelf"
auto ClauseParser::Correction::other_source() -> Read {
  if (!people() || role_ != Role::kDirect || !lexicon_.is_place_name(phrase_.phrase) || !phrase_.at.empty())
    return {};
  NounPhrase* from = nullptr;
  for (NounPhrase& old : last_->phrases) {
    if (old.role == Role::kSource) from = &old;
    if (old.role == Role::kDirect && !old.at.empty() && !lexicon_.is_place_name(old.phrase))
      from = &old.at.back();
  }
  if (from == nullptr) return {};
  phrase_.role = from->role, phrase_.where = from->where;
  *from = std::move(phrase_);
  return done_;
}

std::size_t ClauseParser::Correction::in_its_place() {
  phrase_.role = role_;
  last_->unknown.clear();
  const bool other_place = !phrase_.at.empty() && role_ == Role::kDirect;
  std::erase_if(last_->phrases, [&](const NounPhrase& old) {
    return old.role == role_ || (other_place && old.role == Role::kSource);
  });
  last_->phrases.push_back(std::move(phrase_));
  return done_;
}

}  // namespace goalnet::inference
