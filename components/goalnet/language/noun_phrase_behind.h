// What may follow the head of a noun phrase: a row of small rules, tried in order at each word behind it.
#pragma once

#include <optional>

#include "components/goalnet/language/noun_phrase.h"
#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {

class NounPhraseReader::Behind {
 public:
  Behind(const NounPhraseReader& reader, std::size_t at, std::size_t end, NounPhrase& phrase)
      : reader_(reader),
        words_(reader.words_.text),
        language_(reader.language_),
        lexicon_(reader.lexicon_),
        end_(end),
        phrase_(phrase),
        i_(at) {}
  std::size_t read();

 private:
  // Where what follows ends; the same place where nothing that belongs to the phrase follows; nothing where
  // the rule does not fit.
  using Read = std::optional<std::size_t>;
  using Rule = Read (Behind::*)();

  // noun_phrase_after.cc
  Read on_floor();
  Read of();
  Read that_is();
  Read bears_something();
  Read whatever_is();
  Read held_or_lying();
  Read that_we_have();
  Read lacking();
  Read nearest();
  Read left_or_right();
  // noun_phrase_with.cc
  Read with_on_it();
  Read with_beside();
  Read with_in_it();
  Read that_holds(std::size_t at);

  bool people() const { return language_.hears_people(); }
  bool is(std::size_t i, const char* word) const { return i < end_ && words_[i] == word; }
  const std::string& word() const { return words_[i_]; }

  const NounPhraseReader& reader_;
  const std::vector<std::string>& words_;
  const Language& language_;
  const Lexicon& lexicon_;
  const std::size_t end_;
  NounPhrase& phrase_;
  std::size_t i_;
};

}  // namespace goalnet::inference
