// The words of an instruction as the grammar reads them: phrases that say the same made equal, typing errors
// mended, other words for known ones replaced.
#pragma once

#include <string>
#include <vector>

namespace goalnet::inference {

class Language;

struct Words {
  std::vector<std::string> text;  // singular; "." between sentences, "," between parts
  std::vector<bool> plural;       // whether the word was one
};

// From what tokenize() gives.
Words normal_words(const std::vector<std::string>& tokens, const Language& language);

}  // namespace goalnet::inference
