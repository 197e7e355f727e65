// The head of a noun phrase, the name or what stands for one: a row of small rules, tried in order.
#pragma once

#include <optional>

#include "components/goalnet/language/noun_phrase.h"
#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {

class NounPhraseReader::Head {
 public:
  Head(const NounPhraseReader& reader, std::size_t at, std::size_t end, bool determined, NounPhrase& phrase)
      : reader_(reader),
        words_(reader.words_),
        language_(reader.language_),
        lexicon_(reader.lexicon_),
        end_(end),
        determined_(determined),
        phrase_(phrase),
        i_(at) {}
  std::size_t read();

 private:
  // Where the head and what belongs to it ends; where it begins, if it has no word of its own; nothing where
  // the rule does not fit.
  using Read = std::optional<std::size_t>;
  using Rule = Read (Head::*)();

  // noun_phrase_name.cc
  Read name();
  bool two_names();
  bool can_of();
  void numbered();
  void remember_name();
  // noun_phrase_head.cc
  Read nothing();
  Read that_one();
  Read other_name_of_one();
  Read the_one();
  Read the_thing();
  Read any_thing();
  Read pronoun();
  Read person();
  Read scoop();
  Read measure();
  Read hand();
  Read undetermined();
  Read other_ones();
  Read as_many();
  Read first_of_several();
  Read the_second();
  Read known();
  Read unknown();

  bool people() const { return language_.hears_people(); }
  bool is(std::size_t i, const char* word) const { return i < end_ && words_.text[i] == word; }
  const std::string& word() const { return words_.text[i_]; }
  std::size_t name_at(std::size_t i) const { return i < end_ ? reader_.names_[i] : 0; }
  std::size_t after(std::size_t at) { return reader_.after(at, end_, phrase_); }

  const NounPhraseReader& reader_;
  const Words& words_;
  const Language& language_;
  const Lexicon& lexicon_;
  const std::size_t end_;
  const bool determined_;
  NounPhrase& phrase_;
  std::size_t i_;
};

}  // namespace goalnet::inference
