// What words do: verbs and the frames they open, names of contents, words without meaning of their own.
// From config/language/household.json, like the lexicon of things.
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "components/core/outcome.h"
#include "components/goalnet/language/phrase_rules.h"
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
  kTry,    // "try to", "help me": only the verb behind it counts
  kMake,   // a dish or a drink; or something hot, clean, ...
  kSwap,   // two things change places
  kClear,  // a place is freed of what stands there
  kCool,
  kPlay,  // a game on the console
};

// What a word of state ("open", "dirty") means for a verb that would bring it about or end it.
struct StateWord {
  Frame wanted = Frame::kNone;     // "should be open" -> kOpen
  Frame complaint = Frame::kNone;  // "is dirty" -> kWash
  std::string opposite;            // "open" -> "closed"
};

class Language {
 public:
  // `lexicon` comes from the same text and must outlive this.
  static Expected<Language> parse(std::string_view json, const std::string& name, const Lexicon& lexicon,
                                  Symbols& symbols);
  // Adds what a robot needs to understand people (config/language/english.json, words.json): more verbs and
  // small words, ways of saying the same, states, wishes, other words for known ones. Fails with
  // kInvalidRequest.
  Expected<void> add_english(std::string_view json, const std::string& name);
  // Adds how people talk besides (config/language/talk.json): the same sections, all of them optional, and
  // rewrites as patterns (see PhraseRules) over "groups". Fails with kInvalidRequest.
  Expected<void> add_talk(std::string_view json, const std::string& name);
  // Whether it is a robot's, that people talk to: what only people in a room say is read too.
  bool hears_people() const { return hears_people_; }
  Expected<void> add_other_words(std::string_view json, const std::string& name);
  // Adds what kinds of things English words name (config/language/kinds.json). Fails with kInvalidRequest.
  Expected<void> add_kinds(std::string_view json, const std::string& name);

  Frame verb(const std::string& word) const;             // of any form: "filling", "taken"
  std::string verb_base(const std::string& word) const;  // "filling" -> "fill"
  bool participle(const std::string& word) const;        // "filled", "washing"
  Symbol content(const std::string& phrase) const;       // kWater for "water"; kNone otherwise
  bool filler(const std::string& word) const { return fillers_.contains(word); }
  bool adverb(const std::string& word) const;  // "carefully": changes nothing
  bool known(const std::string& word) const;
  bool real_word(const std::string& word) const {
    return real_words_.contains(word);
  }                                                     // English, though unknown here
  bool names_something(const std::string& word) const;  // a verb or a word of a name
  bool names_thing(const std::string& word) const;      // a name, of one or many
  bool names_place(const std::string& phrase) const;    // "snack table"
  bool small_word(const std::string& word) const;       // the, on, it, ...: where blanks get lost
  bool meaningful(const std::string& word) const {
    return verb(word) != Frame::kNone || names_something(word);
  }
  bool joins(const std::string& word) const;   // and, then, ",", or
  bool copula(const std::string& word) const;  // is, has, looks, ...
  bool asks(const std::string& word) const { return questions_.contains(word); }
  bool time_unit(const std::string& word) const;
  bool person(const std::string& word) const { return people_.contains(word); }  // "grandma", "kid"
  bool english_verb(const std::string& word) const;  // any form of any common verb: "died", "wants"
  bool moves(const std::string& word) const { return moves_.contains(word); }  // "submerge": no verb here
  bool describes(const std::string& word) const { return describing_.contains(word); }  // "sensible"
  bool holds_things(const std::string& phrase) const;  // "cup", "plate": "a cup of coffee"
  bool side_or_part(const std::string& phrase) const;  // "door", "side": "the door of the fridge"
  bool tv_word(const std::string& phrase) const;       // channel, volume, sound
  bool keeps_its_s(const std::string& word) const;     // "this", "perhaps": no plurals

  Frame wanted_by_state(const std::string& word) const;
  Frame complaint(const std::string& word) const;
  std::string opposite_state(const std::string& word) const;
  // "thirsty" -> the words of a command; null where there is none.
  const std::vector<std::string>* wish(const std::string& word) const;
  // Replaces ways of saying the same; never longer than `most` words.
  std::vector<std::string> rewrite(std::vector<std::string> words, std::size_t most) const;

  // The word itself when known; else the only known word within a small typing error (one letter wrong,
  // missing, extra or two swapped; two such in words of eight letters or more); else the word itself. English
  // words that are merely unknown here are no typing errors.
  std::string correct(const std::string& word) const;
  // Known words within a small typing error, the likeliest first, and words that sound alike ("of" for
  // "off").
  std::vector<std::string> corrections(const std::string& word) const;
  // Whether it is no word at all, so that it may be a typing error.
  bool may_be_a_slip(const std::string& word) const;
  // The known word nearest in spelling, for "did you mean"; empty when nothing is near.
  std::string nearest(const std::string& word) const;
  // What to tell a person about a word that is not known, with the nearest known one where there is one.
  std::string unknown_word(const std::string& word) const;
  // Classes of the places where things of a class belong, the best first; from config/language/english.json.
  const std::vector<std::string>& homes(const std::string& class_name) const;
  // What kind of thing an English word names that no thing here has: "milk" -> "drink"; empty where unknown.
  std::string kind_of(const std::string& word) const;
  // Words that training saw in instructions: known, though no verb and no name.
  void add_known(const std::string& word) { seen_.insert(word); }
  // Another word for a known one ("deposit" -> "put"), from WordNet; the word itself where there is none.
  const std::string& synonym(const std::string& word) const;

 private:
  void collect_vocabulary();
  void add_vocabulary();
  std::vector<std::string> within_a_slip(const std::string& word) const;
  std::string written_out(const std::string& word) const;
  void add_state(const std::string& word, const std::string& wanted, const std::string& complaint,
                 const std::string& opposite);
  void add_degrees(const std::vector<std::string>& units);

  std::vector<std::string> vocabulary_;  // sorted; what typing errors are corrected to
  std::unordered_map<std::string, Frame> verbs_;
  std::unordered_map<std::string, std::string> inflected_;  // "taken" -> "take"
  std::unordered_map<std::string, Symbol> contents_;
  std::unordered_set<std::string> fillers_, seen_, questions_, real_words_, no_adverbs_, people_,
      english_verbs_, moves_, describing_;
  std::unordered_map<std::string, StateWord> states_;
  std::unordered_map<std::string, std::vector<std::string>> wishes_;
  PhraseRules rewrites_;
  bool hears_people_ = false;
  std::unordered_map<std::string, std::string> synonyms_, kinds_;
  std::unordered_map<std::string, std::vector<std::string>> homes_;
  std::unordered_map<std::string, std::vector<std::string>> mistaken_;  // "of" -> "off"
  const Lexicon* lexicon_ = nullptr;
};

// Damerau-Levenshtein distance (neighbours swapped count one), cut off at `most` + 1.
int spelling_distance(std::string_view a, std::string_view b, int most);

}  // namespace goalnet::inference
