// Where a command or another clause may begin, and what stands before it.
#include <algorithm>

#include "components/goalnet/language/clause_parser.h"
#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {

using namespace word_group;

std::size_t ClauseParser::skip_joins(std::size_t at, std::size_t end) const {
  while (at < end &&
         ((language_.joins(words_[at]) &&
           !(words_[at] == "next" && at + 1 < end && reader_.name_length(at + 1) > 0)) ||  // "next channel"
          (language_.filler(words_[at]) && !reader_.starts(at, end) && !language_.asks(words_[at]) &&
           words_[at] != "let" && words_[at] != "i" && words_[at] != "we" && !place_preposition(words_[at]) &&
           !one_of(words_[at], kSubordinate) && !one_of(words_[at], kParticles) &&
           language_.verb(words_[at]) == Frame::kNone)))
    ++at;
  return at;
}

bool ClauseParser::harmless(std::size_t at) const {
  return language_.filler(words_[at]) || language_.adverb(words_[at]);
}

// Whether the word is a verb here. "microwave" and "spoon" are things too: they are verbs before a thing.
bool ClauseParser::opens_command(std::size_t at, std::size_t end) const {
  if (at >= end || language_.verb(words_[at]) == Frame::kNone) return false;
  if (language_.hears_people() && all_words_->plural[at] && at > 0 &&
      (one_of(words_[at - 1], kPossessives) || words_[at - 1] == "both"))
    return false;  // "my hands", "both hands"
  if (language_.hears_people() && words_[at] == "go" && at > 0 && one_of(words_[at - 1], kPossessives))
    return false;  // "back from my run"
  if (language_.hears_people() && words_[at] == "up" && !reader_.starts(at + 1, end))
    return false;  // "too high up"
  const std::size_t name = reader_.name_length(at);
  if (name == 0) return true;
  if (name > 1) return false;
  if (language_.hears_people() && (words_[at] == "spoon" || words_[at] == "fork") && at + 1 < end &&
      place_preposition(words_[at + 1]))
    return false;  // "fork on plate one, spoon on plate two"
  if (language_.hears_people() && words_[at] == "heat" && at > 0 &&
      (at + 1 >= end || words_[at + 1] == ",") && (words_[at - 1] == "and" || words_[at - 1] == "then"))
    return true;  // "place in the microwave and heat"
  std::size_t next = at + 1;
  while (next < end && (words_[next] == "up" || words_[next] == "out" || words_[next] == "on")) ++next;
  if (next < end && (is_pronoun(words_[next]) || words_[next] == "that" || words_[next] == "this"))
    return true;
  return reader_.starts(next, end) && !(next == at + 1 && reader_.name_length(next) > 0 && at > 0 &&
                                        (words_[at - 1] == "the" || words_[at - 1] == "a"));
}

// "(somebody went out) and left a burner on": what was told before goes on; no command is in the past.
bool ClauseParser::told_on(std::size_t at, std::size_t end) const {
  return language_.hears_people() && at > 0 && words_[at - 1] == "and" && opens_command(at, end) &&
         reader_.name_length(at) == 0 && language_.participle(words_[at]) && !words_[at].ends_with("ing") &&
         !result_.clauses.empty() && result_.clauses.back().mood == Mood::kStatement;
}

// "(put the mug in the sink,) but first empty it": what is said behind "first" is done before.
void ClauseParser::first_of_all(std::size_t joined, std::size_t at, std::size_t end) {
  const auto said = [&](const char* word) {
    return std::find(words_.begin() + static_cast<long>(joined), words_.begin() + static_cast<long>(at),
                     word) != words_.begin() + static_cast<long>(at);
  };
  if (language_.hears_people() && said("first") && said("but") && opens_command(at, end) &&
      !result_.clauses.empty() && result_.clauses.back().mood == Mood::kCommand)
    insert_before_ = result_.clauses.size() - 1;
}

// "(so) that coffee has to go", "that coke needs to be in the fridge": points at a thing; "so that the
// coffee stays hot" says why.
bool ClauseParser::that_thing_ought(std::size_t at, std::size_t end) const {
  if (!language_.hears_people() || at + 1 >= end || reader_.name_length(at + 1) == 0) return false;
  for (std::size_t i = at + 1 + reader_.name_length(at + 1); i + 1 < end && words_[i] != ","; ++i)
    if (words_[i] == "must" || words_[i] == "should" || one_of(words_[i], kDesire) ||
        ((words_[i] == "has" || words_[i] == "have") && words_[i + 1] == "to"))
      return true;
  return false;
}

bool ClauseParser::starts_clause(std::size_t at, std::size_t end) const {
  if (at >= end) return false;
  if (words_[at] == "not" || words_[at] == "never" || words_[at] == "wish" || one_of(words_[at], kTurns) ||
      one_of(words_[at], kSubordinate) ||
      (language_.asks(words_[at]) && at + 1 < end && words_[at + 1] == "not"))
    return true;
  return opens_command(at, end);
}

std::size_t ClauseParser::skip_part(std::size_t at, std::size_t end) const {
  while (at < end && words_[at] != ",") ++at;
  return at;
}

void ClauseParser::for_later() {
  result_.for_later = true;
  if (result_.problem.empty())
    result_.problem = "wishes for later are not kept; say it when it is to be done";
}

}  // namespace goalnet::inference
