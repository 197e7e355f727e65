// Text to words: lower case, punctuation apart. Bounded in time and memory; never fails on odd characters.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "components/core/outcome.h"

namespace goalnet::inference {

inline constexpr std::size_t kMaxSentenceBytes = 4096;  // longer text is no instruction
inline constexpr std::size_t kMaxWords = 256;

// Words of a sentence, ASCII letters lowered. Letters, digits and '_' make words ("mug_1"); "2/3" stays one
// word; a possessive "'s" falls away, "it's" becomes "it is"; ".", ";", "!" and "?" become the word ".";
// commas, colons and dashes become ","; "&" and "+" become "and"; "->" becomes "to"; all else (hyphens,
// arrows, pictures) separates. Accents of Latin letters are dropped. Letters of other scripts make words that
// no model knows. Fails with kInvalidRequest for invalid UTF-8, control characters other than white space,
// more than kMaxSentenceBytes bytes or kMaxWords words.
Expected<std::vector<std::string>> tokenize(std::string_view sentence);

}  // namespace goalnet::inference
