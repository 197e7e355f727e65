// Corrections by a word: "no, up", "or better off", "actually all", "no, two", "the mug is enough".
#include <algorithm>
#include <array>

#include "components/goalnet/language/clause_correction.h"

namespace goalnet::inference {

using namespace word_group;

// "one channel down, no, up": the same the other way
auto ClauseParser::Correction::other_way() -> Read {
  if (!people() || next_ >= end_ || !parser_.ends_here(next_ + 1, end_)) return {};
  static constexpr std::array<std::array<std::string_view, 2>, 6> kWays = {{{"up", "next"},
                                                                            {"down", "previous"},
                                                                            {"on", "on"},
                                                                            {"off", "off"},
                                                                            {"left", "left"},
                                                                            {"right", "right"}}};
  const std::string& said = words_[next_];
  const auto way = std::find_if(kWays.begin(), kWays.end(), [&](const auto& w) { return w[0] == said; });
  if (way == kWays.end()) return {};
  const std::size_t index = static_cast<std::size_t>(way - kWays.begin());
  const auto& opposite = kWays[index % 2 == 0 ? index + 1 : index - 1];
  bool changed = false;
  const auto turn = [&](std::vector<std::string>& words) {
    for (std::string& word : words)
      for (const std::size_t k : {0u, 1u})
        if (word == opposite[k]) word = std::string(way->at(k)), changed = true;
  };
  const auto turn_frame = [&](Frame from, Frame to, std::string_view by) {
    if (last_->frame == from && said == by) last_->frame = to, changed = true;
  };
  turn(last_->particles), turn(last_->words);
  for (NounPhrase& phrase : last_->phrases) turn(phrase.adjectives);
  turn_frame(Frame::kRaise, Frame::kLower, "down"), turn_frame(Frame::kLower, Frame::kRaise, "up");
  turn_frame(Frame::kStart, Frame::kStop, "off"), turn_frame(Frame::kStop, Frame::kStart, "on");
  if (!changed) return {};
  return parser_.part_end(next_, end_);
}

// "turn it down, or better still off"
auto ClauseParser::Correction::other_state() -> Read {
  if (!people()) return {};
  std::size_t state = next_;
  while (is(state, "still")) ++state;
  if (state >= end_ || last_->first(Role::kDirect) == nullptr ||
      language_.wanted_by_state(words_[state]) == Frame::kNone || !parser_.ends_here(state + 1, end_))
    return {};
  last_->frame = language_.wanted_by_state(words_[state]), last_->verb = words_[state];
  last_->particles.clear(), last_->state.clear(), last_->words = {words_[state]};
  return parser_.part_end(state, end_);
}

// "two books, actually all"
auto ClauseParser::Correction::all_of_them() -> Read {
  if (!people() || !(is(next_, "all") || is(next_, "both")) || !parser_.ends_here(next_ + 1, end_)) return {};
  for (NounPhrase& old : last_->phrases)
    if (old.role == Role::kDirect && !old.pronoun && !old.phrase.empty()) {
      old.count = words_[next_] == "both" ? 2 : 0, old.plural = old.all = true;
      return parser_.part_end(next_, end_);
    }
  return {};
}

// "one book, no, two"; "channel one, no, five"; "a book, no, two"
auto ClauseParser::Correction::number() -> Read {
  if (!people() || next_ >= end_ || number_word(words_[next_]) == 0 ||
      (next_ + 1 < end_ && words_[next_ + 1] != ","))
    return {};
  NounPhrase* named = nullptr;
  for (NounPhrase& old : last_->phrases)
    if (old.role == Role::kDirect && !old.pronoun && (old.count > 0 || old.number > 0 || old.all) &&
        named == nullptr)
      named = &old;
  if (named == nullptr && last_->first(Role::kDestination) == nullptr)
    for (NounPhrase& old : last_->phrases)
      if (old.role == Role::kDirect && !old.pronoun && !old.definite && !old.phrase.empty()) named = &old;
  if (named == nullptr) return {};
  const int number = number_word(words_[next_]);
  if (named->number > 0)
    named->number = number;
  else
    named->count = number, named->plural = number > 1, named->all = false;
  return next_ + 1;
}

// "no wait, the mug is enough", "..., the mug will do"
void ClauseParser::Correction::suffices() {
  static constexpr std::array kWill = {"is"sv, "are"sv, "will"sv, "would"sv, "be"sv};
  static constexpr std::array kSuffices = {"enough"sv, "fine"sv, "do"sv,    "okay"sv,
                                           "better"sv, "good"sv, "plenty"sv};
  if (!people() || done_ == next_) return;
  std::size_t k = done_;
  while (k < end_ && one_of(words_[k], kWill)) ++k;
  if (k > done_ && k < end_ && one_of(words_[k], kSuffices) && parser_.ends_here(k + 1, end_)) done_ = k + 1;
}

}  // namespace goalnet::inference
