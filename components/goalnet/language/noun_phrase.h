// Noun phrases: "both empty cups", "the plate in the sink", "a scoop of ice cream", "it", "the other one".
#pragma once

#include <string>
#include <vector>

#include "components/goalnet/language/language.h"
#include "components/goalnet/language/words.h"

namespace goalnet::inference {

enum class Role : std::uint8_t { kDirect, kDestination, kSource, kWith, kExcept };

// How something stands to a place.
enum class Where : std::uint8_t { kOn, kIn, kNear, kUnder, kTo };

struct NounPhrase {
  Role role = Role::kDirect;
  Where where = Where::kTo;             // of a destination or a place: the preposition
  std::string phrase;                   // the name, normal form; empty for a pronoun or "everything"
  std::string word;                     // as said, for messages
  std::string content;                  // "coffee" of "a cup of coffee", "the mug with coffee in it"
  std::string modifier;                 // "shelf" of "the shelf pillow"
  bool modifier_plural = false;         // "plates" of "plates sink now"
  std::vector<std::string> adjectives;  // words of state: empty, full, hot, open, left, other, held, ...
  std::vector<NounPhrase> at;           // where it is said to be: "in the sink"
  int count = 0;                        // "two", "both"; 0 when not said
  int ordinal = 0;                      // "second" -> 2; 0 when not said
  int number = 0;                       // "pillow 4": the number in its name
  bool pronoun = false, plural = false;
  bool all = false;                 // all, every, each, both
  bool definite = false;            // the, that, this
  bool some = false;                // some, a few
  bool everything = false;          // "everything", "the rest": things without a name
  bool rest = false;                // "the rest", "the others": what was not spoken of yet
  bool person = false;              // me, us, you: no thing
  bool hand = false;                // "in your hand"
  bool scoop = false;               // "a scoop of"
  bool alternative = false;         // after "or": only if the one before cannot be had
  bool joined = false;              // follows "and" after a place: "in the sink and the glass"
  bool filled_with_things = false;  // "a bowl of chips"
  bool negated = false;             // of a place: not there
  bool on_floor = false;            // "from the floor": on or in nothing
  bool unknown = false;             // `word` names nothing that is known

  bool has(std::string_view adjective) const;
  bool bare() const { return phrase.empty() && !pronoun && !everything; }
};

// Numbers and ordinals in words or digits; 0 for other words.
int number_word(const std::string& word);
int ordinal_word(const std::string& word);
bool is_pronoun(const std::string& word);
// "in", "onto", "next to" (as "beside"), ...
bool place_preposition(const std::string& word, Where* where = nullptr);

// Reads noun phrases out of a sentence of words.
class NounPhraseReader {
 public:
  NounPhraseReader(const Words& words, const Language& language, const Lexicon& lexicon);

  // Reads a phrase that begins at word `at` and ends before `end`. Returns where it ends: `at` when there is
  // none. `place`: after a preposition; "one" stands for the last place there, for the last thing elsewhere.
  std::size_t read(std::size_t at, std::size_t end, NounPhrase& phrase, bool place = false) const;
  // Reads "in the sink", "next to the tv" at `at`: a preposition of place and a phrase.
  std::size_t read_place(std::size_t at, std::size_t end, NounPhrase& place) const;
  // How many words at `at` make a known name; 0 for none.
  std::size_t name_length(std::size_t at) const { return names_[at]; }
  // Takes over what "one" stands for from a reader of the same words.
  void recall(const NounPhraseReader& other) {
    last_thing_ = other.last_thing_, last_place_ = other.last_place_;
  }
  // Whether a noun phrase could begin here.
  bool starts(std::size_t at, std::size_t end) const;

 private:
  class Opening;  // up to the head: noun_phrase_opening.h
  class Head;     // noun_phrase_head.h
  class Behind;   // behind it: noun_phrase_behind.h

  std::size_t read_phrase(std::size_t at, std::size_t end, NounPhrase& phrase) const;
  std::string one() const;
  bool modifier_ahead(std::size_t at, std::size_t end) const;
  std::string name(std::size_t at) const;
  std::size_t head(std::size_t at, std::size_t end, bool determined, NounPhrase& phrase) const;
  std::size_t after(std::size_t at, std::size_t end, NounPhrase& phrase) const;
  std::size_t relative(std::size_t at, std::size_t end, NounPhrase& phrase) const;
  std::size_t bears(std::size_t at, std::size_t end, NounPhrase& phrase, bool stranded = false) const;
  std::size_t has_on_it(std::size_t at, std::size_t end, NounPhrase& phrase) const;
  std::size_t lacks(std::size_t at, std::size_t end, NounPhrase& phrase) const;
  bool leads_part(std::size_t at) const;
  std::size_t of(std::size_t at, std::size_t end, NounPhrase& phrase) const;
  std::size_t floor(std::size_t at,
                    std::size_t end) const;  // behind "off the floor"; `at` where it is not that

  const Words& words_;
  const Language& language_;
  const Lexicon& lexicon_;
  std::vector<std::size_t> names_;
  mutable std::string last_thing_, last_place_;  // what "one" stands for
  mutable bool in_place_ = false;
};

}  // namespace goalnet::inference
