#include "components/goalnet/language/slip_words.h"

#include <algorithm>
#include <array>

#include "components/goalnet/language/language.h"
#include "components/goalnet/language/noun_phrase.h"
#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {

using namespace word_group;

std::size_t interjection(const std::vector<std::string>& words, std::size_t at, bool& sure) {
  static constexpr std::array kAlways = {"sorry"sv, "oops"sv, "whoops"sv, "pardon"sv,   "hmm"sv, "hm"sv,
                                         "er"sv,    "erm"sv,  "uh"sv,     "um"sv,       "eh"sv,  "err"sv,
                                         "ehm"sv,   "uhm"sv,  "uhh"sv,    "actually"sv, "nope"sv};
  static constexpr std::array kBeforeAPause = {"no"sv, "wait"sv, "nah"sv, "damn"sv};
  static constexpr std::array kUnsure = {"oh"sv, "ah"sv, "well"sv, "ok"sv, "okay"sv};
  static constexpr std::array<std::array<std::string_view, 2>, 9> kPairs = {{{"my", "bad"},
                                                                             {"i", "mean"},
                                                                             {"i", "meant"},
                                                                             {"my", "mistake"},
                                                                             {"my", "apologies"},
                                                                             {"excuse", "me"},
                                                                             {"hang", "on"},
                                                                             {"hold", "on"},
                                                                             {"oh", "no"}}};
  if (at >= words.size()) return at;
  for (const auto& pair : kPairs)
    if (at + 1 < words.size() && words[at] == pair[0] && words[at + 1] == pair[1]) return sure = true, at + 2;
  if (one_of(words[at], kAlways)) return sure = true, at + 1;
  if (one_of(words[at], kBeforeAPause)) {
    bool more = false;
    const bool fits = ends_part(words, at + 1) || interjection(words, at + 1, more) != at + 1 ||
                      words[at + 1] == "not" || (words[at] == "no" && one_of(words[at + 1], kArticles));
    if (fits) return sure = true, at + 1;
  }
  return one_of(words[at], kUnsure) ? at + 1 : at;
}

std::size_t quantity(const std::vector<std::string>& words, std::size_t at, std::string& many) {
  if (at + 1 < words.size() && words[at] == "make" && (words[at + 1] == "it" || words[at + 1] == "that"))
    at += 2;
  std::size_t i = at;
  if (i < words.size() && (words[i] == "just" || words[i] == "only")) ++i;
  if (i >= words.size()) return at;
  const bool all = words[i] == "all" || words[i] == "both";
  if (!all && number_word(words[i]) == 0) return at;
  many = words[i++];
  if (all && i < words.size() && number_word(words[i]) > 0) ++i;
  if (i + 1 < words.size() && words[i] == "of" && words[i + 1] == "them") i += 2;
  return i;
}

// Where the thing or number begins that ends before `at`, with its article; `at` where there is none.
std::size_t SlipWords::thing_begin(std::size_t at) const {
  std::size_t begin = at;
  bool named = false;
  while (begin > 0 && !ends_part(words_, begin - 1)) {
    const bool pair = begin > 1 && !ends_part(words_, begin - 2) && name(begin - 2) == 2;
    const bool one = name(begin - 1) > 0 || number_word(words_[begin - 1]) > 0;
    if (!pair && !one && !small(begin - 1)) break;
    named = named || pair || one;
    begin -= pair ? 2 : 1;
    if (one_of(words_[begin], kArticles)) break;
  }
  return named ? begin : at;
}

bool SlipWords::said_in(std::size_t begin, std::size_t end, const std::string& word) const {
  return std::find(words_.begin() + static_cast<long>(begin), words_.begin() + static_cast<long>(end),
                   word) != words_.begin() + static_cast<long>(end);
}

bool SlipWords::goes_on_at(std::size_t i) const {
  return !ends_part(words_, i) &&
         (place_preposition(words_[i]) || one_of(words_[i], kParticles) || words_[i] == "with");
}

// Whether the word at `i` was said in the sentence that ends before `end`.
bool SlipWords::said_before(std::size_t end, std::size_t i) const {
  for (std::size_t k = end; k-- > 0 && words_[k] != ".";)
    if (words_[k] == words_[i] && number_word(words_[k]) == 0) return true;
  return false;
}

bool SlipWords::hesitates(const std::string& word) {
  static constexpr std::array kSounds = {"sorry"sv, "oops"sv, "whoops"sv, "hmm"sv, "hm"sv,
                                         "er"sv,    "erm"sv,  "uh"sv,     "um"sv};
  return one_of(word, kSounds);
}

bool SlipWords::small(std::size_t i) const {
  return one_of(words_[i], kArticles) || one_of(words_[i], kPointers) || ordinal_word(words_[i]) > 0 ||
         one_of(words_[i], kStates) || one_of(words_[i], kVague) || one_of(words_[i], kAll);
}

// How many words at `i` make a name; 0 for none.
std::size_t SlipWords::name(std::size_t i) const {
  if (!ends_part(words_, i + 1) && language_.names_thing(words_[i] + " " + words_[i + 1])) return 2;
  const std::string one = singular(words_[i]);
  if (language_.names_thing(words_[i]) || language_.tv_word(one) || language_.names_place(one)) return 1;
  return language_.names_something(words_[i]) && language_.verb(words_[i]) == Frame::kNone ? 1 : 0;
}

bool SlipWords::named_before(std::size_t at) const {
  for (std::size_t i = 0; i < at; ++i)
    if (!ends_part(words_, i) && name(i) > 0) return true;
  return false;
}

// Whether the sentence before tells how many.
bool SlipWords::counted_before(std::size_t at) const {
  for (std::size_t i = at; i-- > 0 && words_[i] != ".";)
    if (!ends_part(words_, i) && name(i) > 0)
      for (std::size_t k = i; k-- > 0 && i - k < 3 && !ends_part(words_, k);)
        if (number_word(words_[k]) > 0 || words_[k] == "both" || words_[k] == "all" || words_[k] == "a")
          return true;
  return false;
}

// A thing or a place and nothing else: "the fork", "burner four", "in the sink", "two", "the second".
// `open`: the part may go on behind it.
std::size_t SlipWords::thing(std::size_t at, bool open) const {
  constexpr std::size_t kLongestThing = 6;
  std::size_t i = at;
  if (i < words_.size() && place_preposition(words_[i])) ++i;
  if (i + 1 < words_.size() && language_.verb(words_[i]) != Frame::kNone && !ends_part(words_, i + 1) &&
      name(i) == 0 && name(i + 1) == 0)
    return at;  // "sorry, water the plants"
  bool named = false;
  while (!ends_part(words_, i) && words_[i] != "and" && !is_tail(i)) {
    std::size_t length = name(i);
    if (length == 0 && number_word(words_[i]) > 0) length = 1;
    if (open && named && length == 0 && goes_on_at(i)) return i;
    if (i - at >= kLongestThing || (length == 0 && !small(i) && words_[i] != "of")) return at;
    named = named || length > 0 || (i > at && ordinal_word(words_[i]) > 0);
    i += std::max<std::size_t>(length, 1);
  }
  return named ? i : at;
}

bool SlipWords::is_tail(std::size_t i) const {
  static constexpr std::array kTails = {"please"sv, "instead"sv, "sorry"sv, "thanks"sv,
                                        "then"sv,   "rather"sv,  "pls"sv};
  if (one_of(words_[i], kTails)) return true;
  return words_[i] == "i" && i + 1 < words_.size() && (words_[i + 1] == "mean" || words_[i + 1] == "meant");
}

// Whether no list goes on at `at`: "sorry, the fork and the plate" may be all that is wanted.
bool SlipWords::tail(std::size_t at) const {
  std::size_t i = at;
  while (i < words_.size() && (words_[i] == "," || words_[i] == "and" || words_[i] == "then")) ++i;
  if (i >= words_.size() || words_[i] == "." || is_tail(i)) return true;
  bool more = false;
  if (interjection(words_, i, more) != i) return true;
  return thing(i) == i;
}

}  // namespace goalnet::inference
