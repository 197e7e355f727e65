// A thing named before what is to be done with it: "the fork, bring it to me".
#include "components/goalnet/language/clause_topic.h"

#include <algorithm>
#include <array>

namespace goalnet::inference {

using namespace word_group;

std::size_t ClauseParser::topic(std::size_t at, std::size_t end) { return Topic(*this, at, end).read(); }

std::size_t ClauseParser::Topic::read() {
  done_ = reader_.read(at_, end_, phrase_);
  if (done_ == at_ || !another(phrase_)) return at_;
  if (phrase_.phrase == "channel" && phrase_.number > 0) return at_;  // "channel 6, and unmute it"
  if (told_of_later()) {
    parser_.add_told(at_, end_);
    return end_;
  }
  more_things();
  named_only_ = is(done_, ",");
  places();
  more_in_places();
  // "spoon in the bowl, put it ...": that is a request of its own
  definite_ = one_of(words_[at_], kArticles) || one_of(words_[at_], kPointers) || phrase_.everything;
  state();
  if (is_what_it_was()) return end_;
  if (!is(done_, ",") || !(definite_ || named_only_ || already_ || fetched_from_there())) return at_;
  if (verb_and_place() || verb_alone()) return command_about_them();
  return then_it();
}

// "the tap!! Somebody left it running"
bool ClauseParser::Topic::told_of_later() const {
  if (done_ < end_ || end_ >= words_.size()) return false;
  for (const Clause& clause : result_.clauses)
    if (clause.mood == Mood::kCommand) return false;
  return any_word(end_, words_.size(), [&](const std::string& word) {
    return is_pronoun(word) || (people() && (word == "that" || word == "those"));
  });
}

// "the coke, the beer and the chips, all on the table"
void ClauseParser::Topic::more_things() {
  while (is(done_, ",") || is(done_, "and")) {
    NounPhrase listed;
    const std::size_t after = reader_.read(done_ + 1, end_, listed);
    if (after == done_ + 1 || !another(listed) || !(is(after, ",") || is(after, "and"))) return;
    more_.push_back(std::move(listed));
    done_ = after;
  }
}

// "the can on the stove, give it here"
void ClauseParser::Topic::places() {
  for (NounPhrase place; done_ < end_; place = {}) {
    const std::size_t after = reader_.read_place(done_, end_, place);
    if (after == done_) return;
    phrase_.at.push_back(place);
    done_ = after;
  }
}

// "the cushion on armchair 1 and the one on armchair 2, swap them"
void ClauseParser::Topic::more_in_places() {
  while (people() && !phrase_.at.empty() && is(done_, "and")) {
    NounPhrase other, there;
    const std::size_t named = reader_.read(done_ + 1, end_, other);
    const std::size_t after = named == done_ + 1 ? named : reader_.read_place(named, end_, there);
    if (named == done_ + 1 || !another(other)) return;
    if (after != named) other.at.push_back(there);
    if (other.at.empty() || !(is(after, ",") || is(after, "and"))) return;
    more_.push_back(std::move(other));
    done_ = after;
  }
}

// "the beer's empty, toss it", "kettle's already full, boil it"
void ClauseParser::Topic::state() {
  already_ = done_ + 2 < end_ && (words_[done_] == "already" || words_[done_] == "still");
  if (already_ && language_.wanted_by_state(words_[done_ + 1]) != Frame::kNone && words_[done_ + 2] == ",")
    ++done_;
  if (is(done_ + 1, ",") && (definite_ || already_) &&
      (language_.wanted_by_state(words_[done_]) != Frame::kNone ||
       language_.complaint(words_[done_]) != Frame::kNone))
    ++done_;
}

// "put it in the sink, the mug I mean"
bool ClauseParser::Topic::is_what_it_was() {
  if (!after_command() || result_.clauses.size() != 1 || !definite_ || !parser_.ends_here(done_, end_) ||
      (done_ < end_ && words_[done_] != "correction"))
    return false;
  bool pronoun = false;
  for (NounPhrase& old : result_.clauses.back().phrases)
    if (old.pronoun && old.role == Role::kDirect && (old.word == "it" || old.word == "them" || old.plural)) {
      phrase_.role = Role::kDirect;
      old = phrase_;
      pronoun = true;
    }
  return pronoun;
}

// "the plate and the bowl, bring to the counter"
bool ClauseParser::Topic::verb_and_place() const {
  const std::size_t verb = done_ + 1;
  if (!parser_.opens_command(verb, end_) || !(definite_ || people()) || verb + 1 >= end_ ||
      language_.wanted_by_state(words_[verb]) != Frame::kNone)
    return false;
  NounPhrase place;
  const std::size_t after = reader_.read_place(verb + 1, end_, place);
  const Frame frame = language_.verb(words_[verb]);
  return after != verb + 1 && !place.person && !place.pronoun && parser_.ends_here(after, end_) &&
         (frame == Frame::kPlace || frame == Frame::kBring || frame == Frame::kTake);
}

// "book on shelf: fetch": tells which one. "coke in the glass, bring it" is a request of its own.
bool ClauseParser::Topic::fetched_from_there() const {
  if (!people() || phrase_.at.empty() || !is(done_, ",") || !parser_.opens_command(done_ + 1, end_))
    return false;
  const Frame frame = language_.verb(words_[done_ + 1]);
  return (frame == Frame::kBring || frame == Frame::kTake) &&
         std::none_of(phrase_.at.begin(), phrase_.at.end(),
                      [&](const NounPhrase& place) { return language_.holds_things(place.phrase); });
}

// "beer + coke, bring here", "the bowl, wash": behind the verb only who wants it, and where
bool ClauseParser::Topic::verb_alone() const {
  static constexpr std::array kHere = {"here"sv, "over"sv, "to"sv};
  if (!people() || !parser_.opens_command(done_ + 1, end_) || !(phrase_.at.empty() || fetched_from_there()) ||
      language_.wanted_by_state(words_[done_ + 1]) != Frame::kNone)
    return false;
  for (std::size_t k = done_ + 2; k < end_ && words_[k] != ","; ++k) {
    const std::string& word = words_[k];
    if (is_pronoun(word) || one_of(word, kPointers) || word == "all" || word == "both") return false;
    if (!parser_.harmless(k) && !one_of(word, kHere) && !one_of(word, kPersons)) return false;
  }
  return true;
}

std::size_t ClauseParser::Topic::command_about_them() {
  phrase_.role = Role::kDirect;
  parser_.fronted_ = {std::move(phrase_)};
  for (NounPhrase& other : more_) {
    other.role = Role::kDirect;
    parser_.fronted_.push_back(std::move(other));
  }
  return parser_.command(done_ + 1, end_, Mood::kCommand);
}

// a command with "it", or "water in", follows
std::size_t ClauseParser::Topic::then_it() {
  static constexpr std::array kYes = {"yes"sv, "yeah"sv, "yep"sv, "yup"sv, "aye"sv, "okay"sv, "ok"sv};
  std::size_t next = done_ + 1;
  while (people() && next + 2 < end_ && one_of(words_[next], kYes) && words_[next + 1] == ",")
    next += 2;  // "the book on the shelf, yes, I need it"
  while (people() && next + 1 < end_ && words_[next] == "so") ++next;  // "..., so put one there"
  if (next >= end_) return at_;
  const bool again = subject_again(next);
  if (words_[next] != "wish" && !parser_.opens_command(parser_.skip_joins(next, end_), end_) &&
      !named_only_ && !again)
    return at_;
  if (!again && !refers(next)) return at_;
  Clause clause;
  clause.mood = Mood::kStatement;
  clause.phrases = {std::move(phrase_)};
  clause.phrases.insert(clause.phrases.end(), more_.begin(), more_.end());
  parser_.add(std::move(clause));
  return done_;
}

// "the plates, they go in the sink"
bool ClauseParser::Topic::subject_again(std::size_t next) const {
  return people() && next + 1 < end_ && is_pronoun(words_[next]) &&
         (one_of(words_[next + 1], kDesire) || words_[next + 1] == "all");
}

// Whether the part at `next` speaks of what was named.
bool ClauseParser::Topic::refers(std::size_t next) const {
  for (std::size_t i = next; i < end_ && words_[i] != ","; ++i) {
    const std::string& word = words_[i];
    if (word == "it" || word == "them" || word == "that") return true;
    if ((word == "all" || word == "both") && (i == next || i + 2 >= end_ || number_word(words_[i + 1]) > 0))
      return true;
    if (word == "there" && people() && lexicon_.is_place_name(phrase_.phrase)) return true;
    if ((word == "in" || word == "on") && (i + 1 >= end_ || words_[i + 1] == ",")) return true;
  }
  return false;
}

}  // namespace goalnet::inference
