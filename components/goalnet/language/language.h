// What words do: verbs and the frames they open, names of contents, words without meaning of their own.
// From config/language/household.json, like the lexicon of things.
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "components/core/outcome.h"
#include "components/goalnet/lexicon.h"
#include "components/goalnet/symbols.h"

namespace goalnet::inference {

// What a verb asks for.
enum class Frame : std::uint8_t {
  kNone,
  kGo,
  kTake,
  kPlace,
  kBring,
  kDiscard,
  kFill,
  kPour,
  kEmpty,
  kTurn,
  kStart,
  kStop,
  kOpen,
  kClose,
  kWash,
  kHeat,
  kBoil,
  kAdd,
  kSqueeze,
  kScoop,
  kInsert,
  kRelease,
  kChange,
  kMute,
  kRaise,
  kLower,
};

class Language {
 public:
  // `lexicon` comes from the same text and must outlive this.
  static Expected<Language> parse(std::string_view json, const std::string& name, const Lexicon& lexicon,
                                  Symbols& symbols);

  Frame verb(const std::string& word) const;
  Symbol content(const std::string& phrase) const;  // kWater for "water"; kNone otherwise
  bool filler(const std::string& word) const { return fillers_.contains(word); }
  bool known(const std::string& word) const;

  // The word itself when known; else the only known word within a small typing error (one letter wrong,
  // missing, extra or two swapped; two such in words of eight letters or more); else the word itself.
  std::string correct(const std::string& word) const;
  // The known word nearest in spelling, for "did you mean"; empty when nothing is near.
  std::string nearest(const std::string& word) const;
  // What to tell a person about a word that is not known, with the nearest known one where there is one.
  std::string unknown_word(const std::string& word) const;
  // Words that training saw in instructions: known, though no verb and no name.
  void add_known(const std::string& word) { seen_.insert(word); }
  // Other words for known ones ("deposit" -> "put"), for example from WordNet.
  void add_synonym(const std::string& word, const std::string& known);
  const std::string& synonym(const std::string& word) const;

 private:
  std::vector<std::string> vocabulary_;  // sorted; what typing errors are corrected to
  std::unordered_map<std::string, Frame> verbs_;
  std::unordered_map<std::string, Symbol> contents_;
  std::unordered_set<std::string> fillers_, seen_;
  std::unordered_map<std::string, std::string> synonyms_;
  const Lexicon* lexicon_ = nullptr;
};

// Damerau-Levenshtein distance (neighbours swapped count one), cut off at `most` + 1.
int spelling_distance(std::string_view a, std::string_view b, int most);

}  // namespace goalnet::inference
