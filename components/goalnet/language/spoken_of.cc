// "I read the one on the shelf, bring me that book": which one is told in one part, of what kind in another.
#include <algorithm>

#include "components/goalnet/language/language.h"
#include "components/goalnet/language/noun_phrase.h"
#include "components/goalnet/language/spoken_forms.h"
#include "components/goalnet/language/word_groups.h"
#include "components/goalnet/lexicon.h"

namespace goalnet::inference {

using namespace word_group;

void name_the_one(std::vector<std::string>& words, const Language& language) {
  static constexpr std::array kTellers = {"i"sv, "we"sv, "the"sv, "my"sv};
  static constexpr std::array kAsks = {"want"sv, "need"sv, "like"sv, "wish"sv, "would"sv, "should"sv};
  const auto ends = [&](std::size_t i) { return i >= words.size() || words[i] == "." || words[i] == ","; };
  for (std::size_t begin = 0; begin < words.size();) {
    std::size_t end = begin;
    bool asks = false;
    for (; !ends(end); ++end) asks = asks || one_of(words[end], kAsks);
    const std::size_t from = begin;
    begin = end + 1;
    if (asks || from == end || !one_of(words[from], kTellers)) continue;
    for (std::size_t i = from; i + 3 < end; ++i) {
      if (words[i] != "the" || !place_preposition(words[i + 2])) continue;
      const bool one = words[i + 1] == "one";
      if (!one && !language.names_something(words[i + 1])) continue;
      std::size_t stop = i + 3;
      while (stop < end && !language.copula(words[stop]) && words[stop] != "and") ++stop;
      std::size_t that = end;  // "that book", with no place of its own
      while (that + 1 < words.size() &&
             !(words[that] == "that" &&
               (one ? language.names_something(words[that + 1]) : words[that + 1] == words[i + 1])))
        ++that;
      if (that + 1 >= words.size() || (that + 2 < words.size() && place_preposition(words[that + 2]))) break;
      const std::vector<std::string> place(words.begin() + static_cast<long>(i) + 2,
                                           words.begin() + static_cast<long>(stop));
      words[that] = "the", words[i + 1] = words[that + 1];
      words.insert(words.begin() + static_cast<long>(that) + 2, place.begin(), place.end());
      return;
    }
  }
}

}  // namespace goalnet::inference
