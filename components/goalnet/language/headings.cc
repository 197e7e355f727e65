// "guests: two plates", "tidy the sofa: book to the shelf": what stands before a colon.
#include <algorithm>
#include <array>
#include <optional>

#include "components/goalnet/language/language.h"
#include "components/goalnet/language/noun_phrase.h"
#include "components/goalnet/language/spoken_forms.h"
#include "components/goalnet/language/word_groups.h"
#include "components/goalnet/lexicon.h"

namespace goalnet::inference {

using namespace word_group;

namespace {

// One heading: the words from `begin_` up to the colon at `colon_`. Each rule changes the words where it fits
// and returns where to go on.
class Heading {
 public:
  Heading(std::vector<std::string>& words, const Language& language, std::size_t colon)
      : words_(words), language_(language), colon_(colon), begin_(colon) {
    while (begin_ > 0 && !ends_part(words_, begin_ - 1)) --begin_;
    at_start_ = begin_ == 0 || words_[begin_ - 1] == ".";
  }

  std::size_t resolve() {
    for (const auto rule : {&Heading::things_to_place, &Heading::verb_of_list, &Heading::tidied,
                            &Heading::says_nothing, &Heading::verb})
      if (const auto next = (this->*rule)()) return *next;
    words_[colon_] = ",";
    return colon_;
  }

 private:
  using Read = std::optional<std::size_t>;
  auto word(std::size_t i) const { return words_.begin() + static_cast<long>(i); }
  bool opens_with_verb() const {
    return language_.verb(words_[begin_]) != Frame::kNone && !language_.participle(words_[begin_]);
  }

  Read things_to_place();
  bool only_things(std::size_t end, bool waste) const;
  Read verb_of_list();
  Read tidied();
  Read says_nothing();
  Read verb();

  std::vector<std::string>& words_;
  const Language& language_;
  const std::size_t colon_;
  std::size_t begin_;
  bool at_start_ = false;  // of a sentence
};

// "snack table: chips + bowl": that is where they go; "rubbish: the can"
Heading::Read Heading::things_to_place() {
  static constexpr std::array kWaste = {"rubbish"sv, "trash"sv, "garbage"sv, "waste"sv};  // what to bin
  std::string heading;
  for (std::size_t k = begin_; k < colon_; ++k) heading += (k > begin_ ? " " : "") + words_[k];
  const bool waste = colon_ == begin_ + 1 && one_of(words_[begin_], kWaste);
  if (!at_start_ || !(waste || language_.names_place(heading))) return {};
  std::size_t end = colon_ + 1;
  while (end < words_.size() && words_[end] != ".") ++end;
  if (end == colon_ + 1 || !only_things(end, waste)) return {};
  if (waste) words_[begin_] = "bin";
  std::vector<std::string> said = {"put"};
  said.insert(said.end(), word(colon_ + 1), word(end));
  said.insert(said.end(), {"to", "the"});
  said.insert(said.end(), word(begin_), word(colon_));
  words_.erase(word(begin_), word(end));
  words_.insert(word(begin_), said.begin(), said.end());
  return begin_ + said.size() - 1;
}

bool Heading::only_things(std::size_t end, bool waste) const {
  static constexpr std::array kNoList = {"nothing"sv, "no"sv, "not"sv, "but"sv};
  return std::all_of(word(colon_ + 1), word(end), [&](const std::string& said) {
    return said != ":" && said != "off" && !place_preposition(said) &&
           (language_.verb(said) == Frame::kNone || language_.names_something(singular(said))) &&
           !(waste && (language_.copula(said) || one_of(said, kNoList))) &&
           language_.wanted_by_state(said) == Frame::kNone;
  });
}

// "swap those two: the pillow and the book", "bring me these: ...": the verb is for what is listed
Heading::Read Heading::verb_of_list() {
  static constexpr std::array kThese = {"these"sv, "those"sv,     "them"sv, "both"sv,  "two"sv,
                                        "three"sv, "following"sv, "the"sv,  "things"sv};
  std::size_t verb_end = colon_;
  while (verb_end > begin_ && one_of(words_[verb_end - 1], kThese)) --verb_end;
  const bool listed = colon_ + 1 < words_.size() && words_[colon_ + 1] != ".";
  if (verb_end == colon_ || verb_end == begin_ || !listed || !opens_with_verb()) return {};
  words_.erase(word(verb_end), word(colon_ + 1));
  return verb_end;
}

// "tidy the sofa: book to the shelf, bowl to the counter": what comes behind says how
Heading::Read Heading::tidied() {
  static constexpr std::array kTidies = {"tidy"sv,     "clean"sv,     "clear"sv,      "organise"sv,
                                         "organize"sv, "sort"sv,      "straighten"sv, "swap"sv,
                                         "exchange"sv, "declutter"sv, "prepare"sv,    "set"sv,
                                         "arrange"sv,  "rearrange"sv, "ready"sv,      "fix"sv};
  static constexpr std::array kBefore = {"let"sv,  "lets"sv, "us"sv,   "please"sv, "so"sv,  "ok"sv,
                                         "time"sv, "to"sv,   "we"sv,   "can"sv,    "you"sv, "could"sv,
                                         "now"sv,  "will"sv, "need"sv, "should"sv, "'s"sv};
  static constexpr std::array kPlaces = {"to"sv, "on"sv, "in"sv, "into"sv, "onto"sv};
  std::size_t tidies = begin_;
  while (tidies < colon_ && one_of(words_[tidies], kBefore)) ++tidies;
  if (!at_start_ || colon_ == begin_ || !one_of(words_[tidies], kTidies)) return {};
  bool places = false;
  for (std::size_t k = colon_; k < words_.size() && words_[k] != "."; ++k)
    places = places || one_of(words_[k], kPlaces);
  if (!places) return {};
  words_.erase(word(begin_), word(colon_ + 1));
  return begin_;
}

// "guests: two plates"
Heading::Read Heading::says_nothing() {
  constexpr std::size_t kLongest = 5;
  if (!at_start_ || colon_ == begin_ || colon_ - begin_ > kLongest) return {};
  for (std::size_t k = begin_; k < colon_; ++k)
    if (language_.meaningful(words_[k]) || language_.meaningful(singular(words_[k])) ||
        number_word(words_[k]) > 0 || language_.asks(words_[k]) ||
        language_.wanted_by_state(words_[k]) != Frame::kNone)
      return {};
  words_.erase(word(begin_), word(colon_ + 1));
  return begin_;
}

// "bring: the salt and the fork"
Heading::Read Heading::verb() {
  if (!at_start_ || colon_ != begin_ + 1 || !opens_with_verb()) return {};
  words_.erase(word(colon_));
  return colon_;
}

}  // namespace

void resolve_headings(std::vector<std::string>& words, const Language& language) {
  for (std::size_t i = 0; i < words.size(); ++i)
    if (words[i] == ":") i = Heading(words, language, i).resolve();
}

}  // namespace goalnet::inference
