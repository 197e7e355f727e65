// What takes back or changes a part of the clause before it ("no wait, the fork"): what is mended.
#include "components/goalnet/language/clause_correction.h"

#include <algorithm>

namespace goalnet::inference {

using namespace word_group;

std::size_t ClauseParser::correction(std::size_t at, std::size_t end) {
  return Correction(*this, at, end).read();
}

std::size_t ClauseParser::Correction::read() {
  static constexpr std::array<Rule, 5> kRules = {&Correction::from_elsewhere, &Correction::other_way,
                                                 &Correction::other_state, &Correction::all_of_them,
                                                 &Correction::number};
  skip_small_words();
  denied();
  skip_reason();
  drop_unfinished();
  last_ = mended_command();
  if (last_ == nullptr) return unread();
  const bool alone = people() && next_ >= end_ && end_ + 1 < words_.size();  // "No wait. Put it there."
  if (next_ >= end_ && !alone) return unread();
  if (const Read done = said_anew(alone ? end_ + 1 : next_)) return *done;
  if (alone) return unread();
  for (const Rule rule : kRules)
    if (const Read done = (this->*rule)()) return *done;
  return thing();
}

void ClauseParser::Correction::skip_small_words() {
  const auto says_what = [&](const std::string& word) {
    return word == "i" || word == "we" || number_word(word) > 0 || one_of(word, kParticles);
  };
  for (; next_ < end_; ++next_) {
    const std::string& word = words_[next_];
    if (word == "correction" || language_.joins(word)) continue;
    if (!parser_.harmless(next_) || reader_.starts(next_, end_) || place_preposition(word) ||
        (people() && says_what(word)))
      return;
  }
}

// "no wait, not the egg, get me the syrup", "not two, three"
void ClauseParser::Correction::denied() {
  while (people() && is(next_, "not") && next_ + 1 < end_) {
    NounPhrase denied;
    std::size_t done = next_ + 1;
    if (number_word(words_[done]) > 0 && is(done + 1, ","))
      denied.number = number_word(words_[done++]);
    else if (done = reader_.read_place(next_ + 1, end_, denied); done == next_ + 1)
      done = reader_.read(next_ + 1, end_, denied);
    if (done == next_ + 1 || !is(done, ",")) return;
    const bool number_follows =
        denied.number > 0 && denied.phrase.empty() && done + 1 < end_ && number_word(words_[done + 1]) > 0;
    next_ = number_follows ? done + 1 : parser_.skip_joins(done, end_);
    not_this_ = denied;
  }
}

// "no, scratch that, I am driving, the coke"
void ClauseParser::Correction::skip_reason() {
  const std::size_t stop = parser_.part_end(next_, end_);
  if (!people() || next_ >= end_ || stop >= end_ ||
      !(parser_.tells(next_, stop) || words_[next_] == "wish_to"))
    return;
  next_ = parser_.skip_joins(stop, end_);
  while (is(next_, "so")) ++next_;
}

// "swap the beer and the coke's ... no wait": what was left of it goes as well
void ClauseParser::Correction::drop_unfinished() {
  if (!people()) return;
  while (result_.clauses.size() > 1 && result_.clauses.back().mood == Mood::kStatement &&
         result_.clauses[result_.clauses.size() - 2].mood == Mood::kCommand)
    result_.clauses.pop_back();
}

bool ClauseParser::Correction::denies(const NounPhrase& old) const {
  return !old.pronoun && (not_this_.phrase.empty() || old.phrase == not_this_.phrase) &&
         (not_this_.number == 0 || old.number == not_this_.number);
}

// The command before it; null where there is none. "put the beer in the bin and wash the glass, oh no, not
// the beer, the coke": the one about the beer.
Clause* ClauseParser::Correction::mended_command() {
  if (result_.clauses.empty()) return nullptr;
  Clause* last = &result_.clauses.back();
  if (told_which())
    for (auto of = result_.clauses.rbegin(); of != result_.clauses.rend(); ++of)
      if (of->mood == Mood::kCommand &&
          std::any_of(of->phrases.begin(), of->phrases.end(), [&](const auto& old) { return denies(old); })) {
        last = &*of;
        break;
      }
  const bool wished = people() && last->mood == Mood::kStatement && last->wish &&
                      last->frame != Frame::kNone && next_ < end_ && !parser_.opens_command(next_, end_) &&
                      words_[next_] != "wish";
  return last->mood == Mood::kCommand || wished ? last : nullptr;
}

// "put the mug in the sink, no, wash the mug": what is said anew is read as any command; what the first was
// about may still be "it"
auto ClauseParser::Correction::said_anew(std::size_t anew) -> Read {
  if (!parser_.opens_command(anew, words_.size()) && words_[anew] != "wish") return {};
  if (people()) {
    last_->mood = Mood::kStatement, last_->frame = Frame::kNone, last_->verb.clear(), last_->state.clear();
    std::erase_if(last_->phrases, [](const NounPhrase& phrase) { return phrase.role != Role::kDirect; });
  } else {
    result_.clauses.pop_back();
  }
  return unread();
}

}  // namespace goalnet::inference
