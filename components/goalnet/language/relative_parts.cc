// What is said in between of a thing that is known already ("the salt, which should never have been there,
// ..."), and wishes that name the thing first ("a glass of water would do").
#include <algorithm>
#include <array>

#include "components/goalnet/language/language.h"
#include "components/goalnet/language/noun_phrase.h"
#include "components/goalnet/language/spoken_forms.h"
#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {

using namespace word_group;

namespace {

void erase(std::vector<std::string>& words, std::size_t from, std::size_t to) {
  words.erase(words.begin() + static_cast<long>(from), words.begin() + static_cast<long>(to));
}

}  // namespace

void drop_relative_parts(std::vector<std::string>& words, const Language& language) {
  static constexpr std::array kDenies = {"not"sv, "never"sv, "should"sv, "shouldnt"sv, "isnt"sv, "doesnt"sv};
  static constexpr std::array kIs = {"is"sv, "are"sv, "stands"sv, "lies"sv, "sits"sv};
  static constexpr std::array kSets = {"tv"sv, "telly"sv, "television"sv, "set"sv};
  for (std::size_t i = 1; i + 2 < words.size(); ++i) {
    if (words[i] != "," || words[i + 1] != "which" || language.names_thing(words[i + 2]) ||
        words[i + 2] == "one")
      continue;  // "..., which book is it?"
    std::size_t end = i + 2;
    bool denies = false, channel = false;
    for (; !ends_part(words, end); ++end) {
      denies = denies || one_of(words[end], kDenies) || one_of(words[end], kDesire) || words[end] == "but";
      channel = channel || words[end] == "channel";
    }
    // "the news, which is on channel five, ..." says what to turn to; "the tv, which is on channel three,
    // ..." how it is
    if (channel && (denies || !one_of(words[i - 1], kSets))) continue;
    // "the pillow, which is on the shelf, ..." says which one
    const bool places =
        !denies && one_of(words[i + 2], kIs) && i + 3 < end && place_preposition(words[i + 3]);
    const bool goes_on =
        end + 1 < words.size() && words[end] == "," &&
        (language.copula(words[end + 1]) || one_of(words[end + 1], kDesire) || words[end + 1] == "has" ||
         words[end + 1] == "needs" || words[end + 1] == "can" || (channel && words[end + 1] == "by"));
    if (goes_on) erase(words, end, end + 1);
    if (places) {
      words[i + 1] = "that";
      erase(words, i, i + 1);
    } else {
      erase(words, i, end);
    }
  }
}

void last_requests(std::vector<std::string>& words, const Language& language) {
  static constexpr std::array kMore = {"more"sv, "last"sv, "other"sv, "final"sv};
  for (std::size_t i = 0; i + 3 < words.size(); ++i) {
    if (words[i] != "thing" || i == 0 || !one_of(words[i - 1], kMore)) continue;
    std::size_t begin = i - 1, at = i + 1;
    while (begin > 0 &&
           (words[begin - 1] == "one" || words[begin - 1] == "just" || words[begin - 1] == "another"))
      --begin;
    while (at < words.size() && ends_part(words, at)) ++at;
    if (at == i + 1 || at >= words.size() || !(one_of(words[at], kArticles) || one_of(words[at], kPointers)))
      continue;
    bool says = false;
    for (std::size_t k = at; !ends_part(words, k); ++k)
      says = says || language.copula(words[k]) || one_of(words[k], kDesire) || words[k] == "can" ||
             words[k] == "'s";
    erase(words, begin, at);
    if (!says) words.insert(words.begin() + static_cast<long>(begin), "wish");
  }
}

void wishes_first(std::vector<std::string>& words) {
  static constexpr std::array kWould = {"would"sv, "will"sv, "wil"sv};
  static constexpr std::array kDoes = {"do"sv, "suffice"sv};
  static constexpr std::array kBegins = {"a"sv,     "an"sv,      "some"sv, "just"sv, "only"sv,
                                         "maybe"sv, "perhaps"sv, "one"sv,  "two"sv};
  static constexpr std::array kBehind = {"nicely"sv, "fine"sv, "me"sv, "please"sv, "for"sv, "it"sv};
  const bool asks = std::any_of(words.begin(), words.end(), [](const std::string& word) {
    return word == "want" || word == "need" || word == "wish" || word == "like" || word == "bring" ||
           word == "get";
  });
  for (std::size_t i = 2; i + 1 < words.size() && !asks; ++i) {
    const bool enough =
        (words[i] == "is" || words[i] == "are") && (words[i + 1] == "plenty" || words[i + 1] == "enough");
    if (!enough && (!one_of(words[i], kWould) || !one_of(words[i + 1], kDoes))) continue;
    std::size_t end = i + 2, begin = i;
    while (!ends_part(words, end) && one_of(words[end], kBehind)) ++end;
    while (begin > 0 && !ends_part(words, begin - 1)) --begin;
    if (!ends_part(words, end) || !one_of(words[begin], kBegins)) continue;
    erase(words, i, end);
    words.insert(words.begin() + static_cast<long>(begin), "wish");
  }
}

}  // namespace goalnet::inference
