#include "components/goalnet/language/word_spans.h"

#include <algorithm>
#include <array>

#include "components/goalnet/language/language.h"
#include "components/goalnet/language/noun_phrase.h"
#include "components/goalnet/language/word_groups.h"
#include "components/goalnet/lexicon.h"

namespace goalnet::inference {

using namespace word_group;

bool WordSpans::ends(std::size_t at) const {
  return at >= words_.size() || words_[at] == "." || words_[at] == ",";
}

std::size_t WordSpans::part_begin(std::size_t at) const {
  while (at > 0 && !ends(at - 1)) --at;
  return at;
}

std::size_t WordSpans::part_end(std::size_t at) const {
  while (!ends(at)) ++at;
  return at;
}

bool WordSpans::is_one(std::size_t at, std::initializer_list<std::string_view> words) const {
  return at < words_.size() && std::find(words.begin(), words.end(), words_[at]) != words.end();
}

std::size_t WordSpans::phrase(std::size_t at, std::initializer_list<std::string_view> phrases) const {
  std::size_t farthest = at;
  for (std::string_view phrase : phrases) {
    std::size_t i = at;
    while (!phrase.empty() && i < words_.size()) {
      const std::size_t blank = std::min(phrase.find(' '), phrase.size());
      if (words_[i] != phrase.substr(0, blank)) break;
      phrase.remove_prefix(std::min(blank + 1, phrase.size()));
      ++i;
    }
    if (phrase.empty()) farthest = std::max(farthest, i);
  }
  return farthest;
}

std::size_t WordSpans::skip_small(std::size_t at) const {
  while (is_one(
      at, {"please", "so",  "and", "then", "but",  "oh",    "ah", "ok",       "okay", "well",   "just", "now",
           "hey",    "yes", "um",  "uh",   "also", "right", "no", "actually", "hmm",  "anyway", "yeah"}))
    ++at;
  return at;
}

std::size_t WordSpans::name(std::size_t at) const {
  constexpr std::size_t kLongest = 3;
  // "can you", "the plates can go" are no cans
  if (is(at, "can") && (at == 0 || ends(at - 1) ||
                        is_one(at + 1, {"you", "i", "we", "be", "go", "not", "come", "have", "also"})))
    return 0;
  if (is(at, "new")) return 0;  // "news" is kept in the singular, too
  std::string name;
  std::size_t length = 0;
  for (std::size_t i = at; i < at + kLongest && !ends(i); ++i) {
    name += (i > at ? " " : "") + words_[i];
    const std::string one = singular(name);
    if (language_.names_thing(name) || language_.names_place(one) || language_.tv_word(one) ||
        language_.content(name) != symbol::kNone)
      length = i + 1 - at;
  }
  return length;
}

std::size_t WordSpans::thing(std::size_t at) const {
  std::size_t i = at;
  while (!ends(i) && name(i) == 0 &&
         (one_of(words_[i], kArticles) || one_of(words_[i], kPointers) || one_of(words_[i], kAll) ||
          one_of(words_[i], kStates) || one_of(words_[i], kVague) || number_word(words_[i]) > 0 ||
          ordinal_word(words_[i]) > 0 || is_one(i, {"both", "any", "some", "of", "either"})))
    ++i;
  const std::size_t length = is(i, "one") || is(i, "ones") ? 1 : name(i);
  if (length == 0) return i > at && is(i - 1, "one") ? i : at;
  i += length;
  if (is(i, "number") && !ends(i + 1) && number_word(words_[i + 1]) > 0) ++i;
  if (!ends(i) && number_word(words_[i]) > 0 && number_word(words_[i]) <= 6 && name(i + 1) == 0 &&
      !is_one(i, {"both", "couple"}))
    ++i;
  if (is(i, "of") && name(i + 1) > 0) i += 1 + name(i + 1);
  return i;
}

std::size_t WordSpans::things(std::size_t at) const {
  std::size_t done = thing(at);
  while (done != at && (is(done, "and") || is(done, "or")) && thing(done + 1) != done + 1)
    done = thing(done + 1);
  return done;
}

std::size_t WordSpans::place(std::size_t at) const {
  if (ends(at) || (!place_preposition(words_[at]) && words_[at] != "from")) return at;
  std::size_t i = at + 1;
  while (is_one(i, {"of", "to"})) ++i;
  const std::size_t done = thing(i);
  return done == i ? at : done;
}

std::size_t WordSpans::somewhere(std::size_t at) const {
  const std::size_t done = place(at);
  return done == at ? thing(at) : done;
}

bool WordSpans::names(std::size_t from, std::size_t to) const {
  for (std::size_t i = from; i < to; ++i)
    if (name(i) > 0) return true;
  return false;
}

bool WordSpans::order(std::size_t at) const {
  return !ends(at) && language_.verb(words_[at]) != Frame::kNone &&
         language_.verb_base(words_[at]) == words_[at] &&
         (name(at) == 0 ||
          (!ends(at + 1) && (one_of(words_[at + 1], kArticles) || is_pronoun(words_[at + 1]))));
}

bool WordSpans::orders(std::size_t from, std::size_t to) const {
  for (std::size_t i = from; i < to; ++i) {
    if (i > from && !ends(i - 1) && words_[i - 1] != "and" && words_[i - 1] != "then") continue;
    std::size_t verb = skip_small(i);
    while (is_one(verb, {"can", "could", "would", "will", "you", "please", "kindly", "i", "we", "want",
                         "need", "to", "like", "just", "go", "robot", "maybe", "perhaps"})) {
      if (verb > i && is_one(verb, {"want", "need", "like"})) return true;
      ++verb;
    }
    if (verb < to && order(verb)) return true;
  }
  return false;
}

std::vector<std::string> cut(const std::vector<std::string>& words, std::size_t from, std::size_t to) {
  return {words.begin() + static_cast<long>(from), words.begin() + static_cast<long>(to)};
}

void replace(std::vector<std::string>& words, std::size_t from, std::size_t to,
             const std::vector<std::string>& with) {
  const auto at = words.erase(words.begin() + static_cast<long>(from), words.begin() + static_cast<long>(to));
  words.insert(at, with.begin(), with.end());
}

}  // namespace goalnet::inference
