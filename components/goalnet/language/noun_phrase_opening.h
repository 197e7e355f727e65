// What a noun phrase begins with, word by word up to its head.
#pragma once

#include <optional>

#include "components/goalnet/language/noun_phrase.h"
#include "components/goalnet/language/word_groups.h"

namespace goalnet::inference {

class NounPhraseReader::Opening {
 public:
  Opening(const NounPhraseReader& reader, std::size_t at, std::size_t end, NounPhrase& phrase)
      : reader_(reader), words_(reader.words_.text), at_(at), end_(end), phrase_(phrase), i_(at) {}
  std::size_t read();

 private:
  // Each says whether the word belongs to the phrase; where it ends the phrase, `done_` tells where.
  bool determiner();
  bool rest();
  bool of() const;
  bool number();
  bool adjective();

  bool stands_alone() const;
  bool relative_follows() const;
  bool number_of_last(int number);
  bool one_of_last();
  bool some_of_last(int number);

  bool is(std::size_t i, const char* word) const { return i < end_ && words_[i] == word; }
  const std::string& word() const { return words_[i_]; }

  const NounPhraseReader& reader_;
  const std::vector<std::string>& words_;
  const std::size_t at_, end_;
  NounPhrase& phrase_;
  std::size_t i_;
  bool determined_ = false;
  std::optional<std::size_t> done_;
};

}  // namespace goalnet::inference
