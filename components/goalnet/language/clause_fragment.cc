// Requests without a verb: "tap on please", "channel 5", "the mug please", "and the other plate too".
#include "components/goalnet/language/clause_fragment.h"

#include <algorithm>
#include <array>

namespace goalnet::inference {

using namespace word_group;

std::size_t ClauseParser::fragment(std::size_t at, std::size_t end) {
  return Fragment(*this, at, end).read();
}

std::size_t ClauseParser::Fragment::read() {
  static constexpr std::array<Rule, 24> kRules = {&Fragment::one_of_nothing,
                                                  &Fragment::other_than,
                                                  &Fragment::place_told_again,
                                                  &Fragment::unknown_thing,
                                                  &Fragment::switched,
                                                  &Fragment::too_much,
                                                  &Fragment::place_behind_pause,
                                                  &Fragment::in,
                                                  &Fragment::in_there,
                                                  &Fragment::off_place,
                                                  &Fragment::for_place,
                                                  &Fragment::to_somebody,
                                                  &Fragment::to_place,
                                                  &Fragment::in_state,
                                                  &Fragment::channel,
                                                  &Fragment::listed_then_place,
                                                  &Fragment::content_then_place,
                                                  &Fragment::things_then_place,
                                                  &Fragment::thing_then_place,
                                                  &Fragment::too,
                                                  &Fragment::place_alone,
                                                  &Fragment::and_that,
                                                  &Fragment::asked_for,
                                                  &Fragment::as_before};
  things();
  if (const std::size_t done = parser_.all_of_them(at_, end_, subject_, i_); done != at_) return done;
  for (const Rule rule : kRules)
    if (const Read done = (this->*rule)()) return *done;
  if (const Read done = says_nothing()) return *done;
  result_.stray.push_back(words_[at_]);
  return std::max(i_, at_ + 1);
}

std::size_t ClauseParser::Fragment::ask(Frame frame, const char* verb, std::size_t next) {
  clause_.frame = frame, clause_.verb = verb;
  parser_.add(std::move(clause_));
  return next;
}

std::size_t ClauseParser::Fragment::ask_to_bring(std::size_t next) {
  clause_.to_person = clause_.wish = true;
  return ask(Frame::kTake, "bring", next);
}

bool ClauseParser::Fragment::polite() const {
  static constexpr std::array kPolite = {"please"sv, "now"sv, "quick"sv, "asap"sv, "thank"sv};
  static constexpr std::array kToPeople = {"fast"sv, "thanks"sv};
  return behind().polite || any_word(0, words_.size(), [&](const std::string& word) {
           return one_of(word, kPolite) || (people() && one_of(word, kToPeople));
         });
}

ClauseParser::Fragment::Behind ClauseParser::Fragment::behind() const {
  Behind behind;
  std::size_t k = i_;
  if (NounPhrase purpose; is(k, "for")) {
    k = std::max(reader_.read(k + 1, end_, purpose), k + 1);
    behind.polite = purpose.person;
  }
  for (; k < end_ && !language_.joins(words_[k]); ++k) {
    const bool here = people() && words_[k] == "here";
    if (!parser_.harmless(k) && !here) return behind;
    behind.polite = behind.polite || here || words_[k] == "please" || words_[k] == "me" || words_[k] == "us";
  }
  if (is(k, ",") && is(k + 1, "please")) behind.polite = true;
  behind.harmless = true;
  return behind;
}

// "the one on the shelf": of what?
auto ClauseParser::Fragment::one_of_nothing() -> Read {
  if (!people() || subject_.word != "one" || words_[at_] != "the" || !subject_.adjectives.empty() ||
      (subject_.at.empty() && !(i_ < end_ && place_preposition(words_[i_]))))
    return {};
  result_.stray.push_back("one");
  return parser_.part_end(at_, end_);
}

// "another book please, not the one on the couch"
auto ClauseParser::Fragment::other_than() -> Read {
  if (!people()) return {};
  for (std::size_t k = i_; k < end_; ++k) {
    if (words_[k] != "not") {
      if (!language_.joins(words_[k]) && !parser_.harmless(k)) return {};
      continue;
    }
    NounPhrase left_out;
    const std::size_t after = parser_.denied(k, end_, left_out);
    if (after == k || !parser_.ends_here(after, end_)) return {};
    clause_.phrases.push_back(std::move(left_out));
    return ask_to_bring(after);
  }
  return {};
}

// "on the table please, the coffee table"
auto ClauseParser::Fragment::place_told_again() -> Read {
  if (!people() || at_ == 0 || words_[at_ - 1] != "," || !after_command() || !parser_.ends_here(i_, end_))
    return {};
  NounPhrase* there = nullptr;
  for (NounPhrase& phrase : result_.clauses.back().phrases)
    if (phrase.role == Role::kDestination) there = &phrase;
  if (there == nullptr || subject_.phrase == there->phrase || !subject_.phrase.ends_with(" " + there->phrase))
    return {};
  there->phrase = subject_.phrase;
  return i_;
}

auto ClauseParser::Fragment::unknown_thing() -> Read {
  if (!subject_.unknown) return {};
  result_.stray.push_back(subject_.word.empty() ? words_[at_] : subject_.word);
  return std::max(i_, at_ + 1);
}

// "tap on please", "volume down"
auto ClauseParser::Fragment::switched() -> Read {
  static constexpr std::array kWays = {"on"sv, "off"sv, "up"sv, "down"sv};
  if (i_ >= end_ || !one_of(words_[i_], kWays) || reader_.starts(i_ + 1, end_)) return {};
  clause_.particles = {words_[i_]};
  clause_.words.push_back(words_[i_]);
  return ask(Frame::kTurn, "turn", i_ + 1);
}

// "the telly's too loud": its "is" was lost with the apostrophe
auto ClauseParser::Fragment::too_much() -> Read {
  if (!is(i_, "too") || i_ + 1 >= end_ || language_.complaint(words_[i_ + 1]) == Frame::kNone) return {};
  clause_.mood = Mood::kStatement, clause_.frame = Frame::kNone, clause_.state = words_[i_ + 1];
  parser_.add(std::move(clause_));
  return parser_.part_end(i_, end_);
}

// "the fridge open", "both plates clean please"
auto ClauseParser::Fragment::in_state() -> Read {
  if (i_ >= end_ || language_.wanted_by_state(words_[i_]) == Frame::kNone) return {};
  clause_.state = words_[i_];
  return ask(language_.wanted_by_state(words_[i_]), words_[i_].c_str(), i_ + 1);
}

// "next channel", "channel 5"
auto ClauseParser::Fragment::channel() -> Read {
  const bool neighbour = subject_.phrase == "channel" && (subject_.has("next") || subject_.has("previous"));
  const bool numbered = language_.tv_word(subject_.phrase) && (subject_.number > 0 || subject_.ordinal > 0);
  if (!neighbour && !numbered) return {};
  return ask(Frame::kChange, "change", i_);
}

// "the other plate too"
auto ClauseParser::Fragment::too() -> Read {
  if (is(i_, "too") && parser_.ends_here(i_, end_) && parser_.again(clause_)) return i_ + 1;
  return {};
}

// "the coke goes in the trash, and the beer": as well, though there is a "now" somewhere
auto ClauseParser::Fragment::and_that() -> Read {
  if (!people() || at_ == 0 || words_[at_ - 1] != "and" || !subject_.definite ||
      !parser_.ends_here(i_, end_) || result_.clauses.empty() ||
      any_word(at_, end_, [](const std::string& word) { return word == "please"; }))
    return {};
  const Frame before = result_.clauses.back().frame;
  if (before != Frame::kPlace && before != Frame::kDiscard && before != Frame::kWash &&
      before != Frame::kHeat)
    return {};
  if (!parser_.again(clause_)) return {};
  return parser_.part_end(i_, end_);
}

// "the mug please"; "spoon and fork": a list of things and nothing else
auto ClauseParser::Fragment::asked_for() -> Read {
  if (!behind().harmless) return {};
  const bool list =
      people() && at_ == 0 && i_ >= words_.size() && clause_.phrases.size() > 1 &&
      std::none_of(clause_.phrases.begin(), clause_.phrases.end(), [&](const NounPhrase& phrase) {
        return phrase.unknown || phrase.person || phrase.pronoun || phrase.bare() ||
               phrase.alternative ||  // "(which is better,) beer or coke?"
               phrase.role != Role::kDirect || lexicon_.is_place_name(phrase.phrase);
      });
  if (!list && !polite()) return {};
  std::size_t next = i_;
  while (people() && next < end_ && !language_.joins(words_[next])) ++next;
  return ask_to_bring(next);
}

// "... And a pillow."
auto ClauseParser::Fragment::as_before() -> Read {
  if (!parser_.ends_here(i_, end_) || !parser_.again(clause_)) return {};
  std::size_t next = i_;
  while (next < end_ && words_[next] != ",") ++next;
  return next;
}

auto ClauseParser::Fragment::says_nothing() -> Read {
  if (!parser_.says_nothing_here(at_, end_)) return {};
  const std::size_t stop = parser_.part_end(at_, end_);
  result_.passed.push_back(words_[at_]);
  parser_.add_told(at_, stop);
  return stop;
}

}  // namespace goalnet::inference
