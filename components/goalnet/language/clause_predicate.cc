// What a statement says of its subject: "... should be on the table", "... is dirty", "... needs water in
// it".
#include "components/goalnet/language/clause_predicate.h"

#include <algorithm>
#include <array>

#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {

using namespace word_group;

// What is said of the subject, from `at` on. `clause` is the last of the result.
std::size_t ClauseParser::predicate(std::size_t at, std::size_t end, Clause& clause, bool desired,
                                    bool negative) {
  return Predicate(*this, at, end, clause, desired, negative).read();
}

std::size_t ClauseParser::Predicate::read() {
  static constexpr std::array<Rule, 14> kRules = {
      &Predicate::ends,       // "(should be off) when I get back"
      &Predicate::wished,     // "(the plate should) come down from the shelf"
      &Predicate::told,       // "(the stove) has nothing on it"
      &Predicate::off_place,  // "(the book must come) off the couch"
      &Predicate::instead,    // "(should be on the table) rather than on the couch", "except the one on ..."
      &Predicate::not_there,  // "(should be on the table), not on the stove"
      &Predicate::at_place,   // "(should be) on the table", "(is) on channel 3"
      &Predicate::verb,       // "(should be) put in the sink", "(is) broken"
      &Predicate::state,      // "(should be) full of water", "(is) dirty"
      &Predicate::should_hold,       // "(should have) water in it"
      &Predicate::holds,             // "(one of the cups has) water in it"
      &Predicate::on_each,           // "(every armchair should have) a pillow on it"
      &Predicate::needs,             // "(the coffee needs) a squirt of chocolate"
      &Predicate::with_thing_going,  // "(it is loud) with the tv going"
  };
  while (i_ < end_ && (!language_.joins(word()) || goes_on()) && word() != "so") {
    if (word() == ",") ++i_;
    const bool read = std::ranges::any_of(kRules, [&](Rule rule) { return (this->*rule)(); });
    if (done_) return *done_;
    if (read) continue;
    // a new command without a join: "i cannot see it turn on the tv"
    if (parser_.opens_command(i_, end_) && i_ > at_) return i_;
    ++i_;
  }
  return i_;
}

// "..., except the one on the shelf", "..., not on the couch"
bool ClauseParser::Predicate::goes_on() const {
  return people() && i_ + 2 < end_ && word() == "," && clause_.mood == Mood::kCommand &&
         (is(i_ + 1, "except") || is(i_ + 1, "not") || (is(i_ + 1, "rather") && is(i_ + 2, "than")));
}

bool ClauseParser::Predicate::hangs_on(std::size_t at) const {
  static constexpr std::array kHangsOn = {"when"sv, "if"sv, "unless"sv, "as"sv, "because"sv};
  return people() && one_of(words_[at], kHangsOn);
}

// Whether the word is a state that is wanted or complained of.
bool ClauseParser::Predicate::states(std::size_t at) const {
  return language_.wanted_by_state(words_[at]) != Frame::kNone ||
         language_.complaint(words_[at]) != Frame::kNone;
}

bool ClauseParser::Predicate::went_on(std::size_t next) {
  if (next == i_) return false;
  i_ = next;
  return true;
}

bool ClauseParser::Predicate::ended(std::size_t next) {
  if (next == i_) return false;
  done_ = next;
  return true;
}

void ClauseParser::Predicate::command(Frame frame, const char* verb) {
  clause_.mood = Mood::kCommand, clause_.frame = frame, clause_.verb = verb;
}

// "should be off when I get back", "should be in the sink if it is dirty"
bool ClauseParser::Predicate::ends() {
  if (i_ == at_ || !((people() && word() == "correction") || hangs_on(i_))) return false;
  done_ = i_;
  return true;
}

bool ClauseParser::Predicate::wished() {
  if (!wants()) return false;
  const bool hold = people() && (word() == "hold" || word() == "bear") && i_ + 1 < end_ &&
                    !clause_.phrases.empty() && lexicon_.is_place_name(clause_.phrases.front().phrase);
  if (hold)  // "the shelf should hold the beer"
    if (const std::size_t done = parser_.has_thing(i_ + 1, end_, clause_); done != i_ + 1) return ended(done);
  return ended(parser_.comes(i_, end_, clause_)) || ended(parser_.goes_in(i_, end_, clause_)) ||
         ended(parser_.where_that_is(i_, end_, clause_));
}

bool ClauseParser::Predicate::told() {
  if (desired_ || clause_.mood != Mood::kStatement) return false;
  return went_on(parser_.state_of_place(i_, clause_)) || went_on(parser_.holds_no(i_, end_, clause_)) ||
         went_on(parser_.bears_thing(i_, end_, clause_));
}

bool ClauseParser::Predicate::instead() {
  return (clause_.mood == Mood::kCommand && went_on(parser_.instead_of(i_, end_, clause_))) ||
         went_on(parser_.except(i_, end_, clause_));
}

bool ClauseParser::Predicate::not_there() {
  if (!people() || word() != "not" || clause_.mood != Mood::kCommand) return false;
  NounPhrase place;
  const std::size_t done = reader_.read_place(i_ + 1, end_, place);
  return done != i_ + 1 && went_on(done);
}

bool ClauseParser::Predicate::verb() {
  if (language_.verb(word()) == Frame::kNone || !(language_.participle(word()) || desired_) ||
      language_.wanted_by_state(word()) != Frame::kNone)
    return false;
  if (!desired_) {
    clause_.state = word();
    ++i_;
    return true;
  }
  clause_.mood = negative_ ? Mood::kForbidden : Mood::kCommand;
  clause_.frame = language_.verb(word()), clause_.verb = language_.verb_base(word());
  ++i_;
  arguments();
  done_ = i_;
  return true;
}

// Things and places behind a verb.
void ClauseParser::Predicate::arguments() {
  Role role = Role::kDirect;
  Where where = Where::kTo;
  while (i_ < end_ && !language_.joins(word()) && !hangs_on(i_)) {
    clause_.words.push_back(word());
    if (!went_on(parser_.argument(i_, end_, clause_, role, where))) return;
  }
}

bool ClauseParser::Predicate::state() {
  if (!clause_.state.empty() || !states(i_)) return false;
  clause_.state = word();
  std::string wanted = word();
  if (desired_ && negative_) wanted = language_.opposite_state(word());
  if (desired_ && !wanted.empty() && language_.wanted_by_state(wanted) != Frame::kNone) {
    command(language_.wanted_by_state(wanted), wanted.c_str());
    clause_.state = wanted;
  }
  ++i_;
  if (clause_.mood == Mood::kCommand && is(i_, "of")) full_of();
  return true;
}

// "should be full of water"
void ClauseParser::Predicate::full_of() {
  NounPhrase content;
  const std::size_t done = reader_.read(i_ + 1, end_, content);
  if (done == i_ + 1) return;
  content.role = Role::kWith;
  clause_.phrases.push_back(content), i_ = done;
}

}  // namespace goalnet::inference
