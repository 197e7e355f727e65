// Places and things in what a statement says: "... should be on the table", "... has water in it".
#include <array>

#include "components/goalnet/language/clause_predicate.h"
#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {

using namespace word_group;

// "must come off the couch"
bool ClauseParser::Predicate::off_place() {
  if (!people() || word() != "off" || !wants()) return false;
  NounPhrase place;
  const std::size_t done = reader_.read(i_ + 1, end_, place, true);
  if (done == i_ + 1 || place.person || place.unknown) return false;
  command(Frame::kTake, "take");
  place.role = Role::kSource;
  clause_.phrases.push_back(place);
  return went_on(done);
}

bool ClauseParser::Predicate::at_place() {
  NounPhrase place;
  const std::size_t done = reader_.read_place(i_, end_, place);
  if (done == i_ || place.person) return false;
  if (desired_ && negative_) {  // should not be there: take it away
    command(Frame::kTake, "take");
    place.role = Role::kSource;
    clause_.phrases.push_back(place);
  } else if (desired_) {
    command(Frame::kPlace, "put");
    clause_.belongs = true;
    place.role = Role::kDestination;
    clause_.phrases.push_back(place);
  } else if (only_told_of_tv(place) && !under_if()) {  // "the tv is on channel three" tells how it is
    clause_.state = "on";
  } else if (place.phrase == "channel" && place.number > 0) {  // "my show is on channel 2"
    clause_.frame = Frame::kChange, clause_.verb = "change", clause_.wish = true;
    place.role = Role::kDirect;
    clause_.phrases = {place};
  } else if (!clause_.phrases.empty()) {
    clause_.phrases.front().at.push_back(place);
  }
  return went_on(done);
}

bool ClauseParser::Predicate::only_told_of_tv(const NounPhrase& place) const {
  static constexpr std::array kTelevisions = {"tv"sv, "telly"sv, "television"sv};
  return clause_.mood == Mood::kStatement && place.phrase == "channel" && clause_.phrases.size() == 1 &&
         one_of(clause_.phrases.front().phrase, kTelevisions);
}

// Whether the part up to the predicate is a condition.
bool ClauseParser::Predicate::under_if() const {
  static constexpr std::array kIf = {"if"sv, "unless"sv, "when"sv, "whenever"sv, "case"sv};
  for (std::size_t i = at_; i-- > 0 && words_[i] != "," && words_[i] != ".";)
    if (one_of(words_[i], kIf)) return true;
  return false;
}

// "should have water in it"
bool ClauseParser::Predicate::should_hold() {
  if (!wants()) return false;
  NounPhrase content;
  const std::size_t done = reader_.read(i_, end_, content);
  const Symbol what = language_.content(content.phrase);
  const bool liquid = what != symbol::kIceCream && what != symbol::kChocolate && what != symbol::kVanilla &&
                      what != symbol::kSalt;
  if (done == i_ || what == symbol::kNone || !(liquid || !people())) return false;
  command(Frame::kFill, "fill");
  content.role = Role::kWith;
  clause_.phrases.push_back(content);
  i_ = done;
  if ((is(i_, "in") || is(i_, "inside")) && is(i_ + 1, "it")) i_ += 2;
  return true;
}

// "one of the cups has water in it"
bool ClauseParser::Predicate::holds() {
  if (!people() || desired_ || clause_.mood != Mood::kStatement || clause_.phrases.empty()) return false;
  NounPhrase& holder = clause_.phrases.front();
  if (!holder.content.empty() || !language_.holds_things(holder.phrase)) return false;
  NounPhrase content;
  const std::size_t done = reader_.read(i_, end_, content);
  if (done == i_ || done + 1 >= end_ || !(is(done, "in") || is(done, "inside")) ||
      !is_pronoun(words_[done + 1]) || language_.content(content.phrase) == symbol::kNone || negative_)
    return false;
  holder.content = content.phrase;
  return went_on(done + 2);
}

// "every armchair should have a pillow on it", "every cup needs a spoon in it"
bool ClauseParser::Predicate::on_each() {
  if (!wants() || clause_.phrases.empty()) return false;
  NounPhrase thing, on_it;
  const std::size_t done = reader_.read(i_, end_, thing);
  const std::size_t after = done == i_ ? i_ : reader_.read_place(done, end_, on_it);
  if (done == i_ || after == done || !on_it.pronoun || thing.pronoun || thing.person || thing.unknown)
    return false;
  NounPhrase holder = clause_.phrases.front();
  holder.role = Role::kDestination, holder.where = on_it.where;
  command(Frame::kPlace, "put");
  clause_.phrases = {thing, holder};
  return went_on(after);
}

// "the coffee needs a squirt of chocolate", "make sure every armchair has a pillow"
bool ClauseParser::Predicate::needs() {
  static constexpr std::array kNeeds = {"need"sv, "want"sv, "lack"sv, "has"sv, "have"sv};
  return people() && i_ > 0 && one_of(words_[i_ - 1], kNeeds) && wants() &&
         went_on(parser_.has_thing(i_, end_, clause_));
}

// "it is loud with the tv going": tells of the tv
bool ClauseParser::Predicate::with_thing_going() {
  if (!people() || word() != "with" || clause_.mood != Mood::kStatement) return false;
  NounPhrase thing;
  const std::size_t done = reader_.read(i_ + 1, end_, thing);
  if (done == i_ + 1 || done >= end_ || thing.person || thing.unknown || !states(done)) return false;
  Clause told;
  told.mood = Mood::kStatement, told.state = words_[done];
  told.phrases = {std::move(thing)};
  parser_.add(std::move(told));
  done_ = done + 1;
  return true;
}

}  // namespace goalnet::inference
