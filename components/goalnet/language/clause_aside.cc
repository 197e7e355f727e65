// Short parts that ask for nothing: "ssh, the baby!", "exam in 20 minutes", "movie night!".
#include "components/goalnet/language/clause_parser.h"
#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {

using namespace word_group;

namespace {

constexpr std::size_t kLongestExclamation = 2;  // words
constexpr std::size_t kLongestSubject = 5;
constexpr std::array kOccasions = {"time"sv,  "night"sv,   "day"sv,    "break"sv,
                                   "party"sv, "evening"sv, "o'clock"sv};
constexpr std::array kTimes = {"second"sv, "minute"sv, "min"sv, "hour"sv, "day"sv};

}  // namespace

// "ssh, the baby!", "careful with that mug!": a part that nobody can read and that does not begin as requests
// do.
std::size_t ClauseParser::aside(std::size_t at, std::size_t end) {
  if (at > 0 && words_[at - 1] != "," && words_[at - 1] != ".") return at;
  const std::size_t stop = part_end(at, end);
  for (std::size_t i = at; i < stop; ++i)
    if (reader_.name_length(i) > 0) return at;  // something that is here may be asked for
  const bool verb_first = language_.english_verb(words_[at]) || !language_.known(words_[at]);
  if (verb_first && at + 1 < stop && (reader_.starts(at + 1, stop) || one_of(words_[at + 1], kParticles)))
    return at;
  ClauseParser trial = *this;
  trial.result_.stray.clear();
  const std::size_t count = trial.result_.clauses.size();
  trial.statement(at, stop);
  if (trial.result_.stray.empty() || trial.result_.clauses.size() > count) return at;
  add_told(at, stop);
  return stop;
}

// "exam in 20 minutes", "guests at eight": what happens, and when. Where a verb or a thing of this place is
// spoken of somebody may want that done then, which nobody here can.
bool ClauseParser::tells_time(std::size_t at, std::size_t stop) const {
  if (stop >= at + 2 && stop <= at + kLongestSubject && words_[stop - 1] == "at_later") {
    for (std::size_t i = at; i < stop; ++i)
      if (reader_.name_length(i) > 0 || is_pronoun(words_[i]) || opens_command(i, stop)) return false;
    return true;
  }
  if (stop < at + 3 || stop > at + kLongestSubject) return false;
  for (std::size_t i = at; i < stop; ++i)
    if (reader_.name_length(i) > 0 || is_pronoun(words_[i])) return false;
  if (opens_command(at, stop)) return false;
  const bool number = number_word(words_[stop - 1]) > 0 ||
                      words_[stop - 1].find_first_not_of("0123456789") == std::string::npos;
  if (words_[stop - 2] == "at") return number;
  return one_of(words_[stop - 1], kTimes) &&
         (words_[stop - 3] == "in" || (stop > at + 3 && words_[stop - 4] == "in"));
}

// "it starts right now": what somebody or something does, no command; `at` where it is none.
std::size_t ClauseParser::third_person(std::size_t at, std::size_t end) {
  static constexpr std::array kWho = {"it"sv, "he"sv, "she"sv};
  if (!language_.hears_people() || at + 1 >= end || !one_of(words_[at], kWho) ||
      !all_words_->plural[at + 1] || !language_.english_verb(words_[at + 1]) ||
      language_.verb(words_[at + 1]) != Frame::kStart || reader_.name_length(at + 1) > 0)
    return at;
  add_told(at, part_end(at, end));
  return part_end(at, end);
}

// "movie night!", "bedtime, kids": one or two words on their own that name and do nothing here.
std::size_t ClauseParser::exclamation(std::size_t at, std::size_t end) const {
  if (at > 0 && words_[at - 1] != "," && words_[at - 1] != ".") return at;
  std::size_t stop = at;
  while (stop < end && words_[stop] != ",") ++stop;
  if (tells_time(at, stop)) return stop;
  if (stop == at || stop - at > kLongestExclamation) return at;
  if (stop - at == 2 && one_of(words_[at + 1], kOccasions)) return stop;  // "movie night!"
  for (std::size_t i = at; i < stop; ++i)
    if (reader_.starts(i, stop) || reader_.name_length(i) > 0 || language_.verb(words_[i]) != Frame::kNone ||
        place_preposition(words_[i]) || language_.wish(words_[i]) != nullptr ||
        language_.wanted_by_state(words_[i]) != Frame::kNone || language_.asks(words_[i]) ||
        one_of(words_[i], kSubjects) || one_of(words_[i], kParticles))
      return at;
  return stop;
}

}  // namespace goalnet::inference
