// Text to BERT's word pieces, as the uncased models do it: lower case, accents off, punctuation apart, and
// each word as the longest pieces that the vocabulary has.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "components/core/outcome.h"

namespace goalnet::inference {

class WordPiece {
 public:
  // One piece a line, as in vocab.txt; its number is its line. Must have [UNK], [CLS] and [SEP].
  // kInvalidRequest otherwise, and for more than a million pieces.
  static Expected<WordPiece> parse(std::string_view vocabulary, const std::string& name);
  static Expected<WordPiece> load(const std::filesystem::path& path);

  // [CLS] pieces [SEP], cut to `most` numbers. Any bytes are read; what is not UTF-8 is left out.
  std::vector<int> encode(std::string_view text, std::size_t most) const;
  std::size_t size() const { return pieces_.size(); }

 private:
  void add_word(const std::string& word, std::vector<int>& ids) const;

  std::unordered_map<std::string, int> pieces_;
  int unknown_ = 0, begin_ = 0, end_ = 0;
};

}  // namespace goalnet::inference
