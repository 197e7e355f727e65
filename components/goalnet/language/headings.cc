// "guests: two plates", "tidy the sofa: book to the shelf": what stands before a colon.
#include <algorithm>
#include <array>

#include "components/goalnet/language/language.h"
#include "components/goalnet/language/noun_phrase.h"
#include "components/goalnet/language/spoken_forms.h"
#include "components/goalnet/language/word_groups.h"
#include "components/goalnet/lexicon.h"

namespace goalnet::inference {

using namespace word_group;

void resolve_headings(std::vector<std::string>& words, const Language& language) {
  constexpr std::size_t kLongestHeading = 5;
  static constexpr std::array kWaste = {"rubbish"sv, "trash"sv, "garbage"sv, "waste"sv};  // what to bin
  static constexpr std::array kNoList = {"nothing"sv, "no"sv, "not"sv, "but"sv};
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] != ":") continue;
    std::size_t begin = i;
    while (begin > 0 && !ends_part(words, begin - 1)) --begin;
    bool says_something = false;
    for (std::size_t k = begin; k < i; ++k)
      says_something = says_something || language.meaningful(words[k]) ||
                       language.meaningful(singular(words[k])) || number_word(words[k]) > 0 ||
                       language.asks(words[k]) || language.wanted_by_state(words[k]) != Frame::kNone;
    const bool at_start = begin == 0 || words[begin - 1] == ".";
    // "snack table: chips + bowl": that is where they go
    std::string heading;
    for (std::size_t k = begin; k < i; ++k) heading += (k > begin ? " " : "") + words[k];
    const bool waste = i == begin + 1 && one_of(words[begin], kWaste);
    if (at_start && (waste || language.names_place(heading))) {
      std::size_t things_end = i + 1;
      bool only_things = i + 1 < words.size();
      for (; things_end < words.size() && words[things_end] != "."; ++things_end) {
        const std::string& word = words[things_end];
        only_things = only_things && word != ":" && word != "off" && !place_preposition(word) &&
                      (language.verb(word) == Frame::kNone || language.names_something(singular(word))) &&
                      !(waste && (language.copula(word) || one_of(word, kNoList))) &&
                      language.wanted_by_state(word) == Frame::kNone;
      }
      if (only_things && things_end > i + 1) {
        if (waste) words[begin] = "bin";
        std::vector<std::string> said = {"put"};
        said.insert(said.end(), words.begin() + static_cast<long>(i) + 1,
                    words.begin() + static_cast<long>(things_end));
        said.insert(said.end(), {"to", "the"});
        said.insert(said.end(), words.begin() + static_cast<long>(begin),
                    words.begin() + static_cast<long>(i));
        words.erase(words.begin() + static_cast<long>(begin), words.begin() + static_cast<long>(things_end));
        words.insert(words.begin() + static_cast<long>(begin), said.begin(), said.end());
        i = begin + said.size() - 1;
        continue;
      }
    }
    // "tidy the sofa: book to the shelf, bowl to the counter": what comes behind says how
    static constexpr std::array kTidies = {"tidy"sv,     "clean"sv,     "clear"sv,      "organise"sv,
                                           "organize"sv, "sort"sv,      "straighten"sv, "swap"sv,
                                           "exchange"sv, "declutter"sv, "prepare"sv,    "set"sv,
                                           "arrange"sv,  "rearrange"sv, "ready"sv,      "fix"sv};
    std::size_t stop = i + 1;
    while (stop < words.size() && words[stop] != ".") ++stop;
    const bool places =
        std::any_of(words.begin() + static_cast<long>(i), words.begin() + static_cast<long>(stop),
                    [](const std::string& w) {
                      return w == "to" || w == "on" || w == "in" || w == "into" || w == "onto";
                    });
    static constexpr std::array kBefore = {"let"sv,  "lets"sv, "us"sv,   "please"sv, "so"sv,  "ok"sv,
                                           "time"sv, "to"sv,   "we"sv,   "can"sv,    "you"sv, "could"sv,
                                           "now"sv,  "will"sv, "need"sv, "should"sv, "'s"sv};
    std::size_t tidies = begin;
    while (tidies < i && one_of(words[tidies], kBefore)) ++tidies;
    // "swap those two: the pillow and the book", "bring me these: ...": the verb is for what is listed
    static constexpr std::array kThese = {"these"sv, "those"sv,     "them"sv,  "both"sv, "two"sv,
                                          "three"sv, "following"sv, "these"sv, "the"sv,  "things"sv};
    std::size_t verb_end = i;
    while (verb_end > begin && one_of(words[verb_end - 1], kThese)) --verb_end;
    if (verb_end < i && verb_end > begin && i + 1 < stop && language.verb(words[begin]) != Frame::kNone &&
        !language.participle(words[begin])) {
      words.erase(words.begin() + static_cast<long>(verb_end), words.begin() + static_cast<long>(i) + 1);
      i = verb_end;
      continue;
    }
    if (at_start && i > begin && one_of(words[tidies], kTidies) && places) {
      words.erase(words.begin() + static_cast<long>(begin), words.begin() + static_cast<long>(i) + 1);
      i = begin;
      continue;
    }
    if (at_start && i > begin && i - begin <= kLongestHeading && !says_something) {
      words.erase(words.begin() + static_cast<long>(begin), words.begin() + static_cast<long>(i) + 1);
      i = begin;
    } else if (at_start && i == begin + 1 && language.verb(words[begin]) != Frame::kNone &&
               !language.participle(words[begin])) {
      words.erase(words.begin() + static_cast<long>(i));
    } else {
      words[i] = ",";
    }
  }
}

}  // namespace goalnet::inference
