// Text to words: lower case, punctuation apart. Bounded in time and memory; never fails on odd characters.
#pragma once

#include <cstdint>
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
enum class Endings : std::uint8_t {
  kDropped,
  kKept,  // "the kettle's hot" keeps "'s" as a word of its own: what it stands for, the words around it tell;
          // so does
          // ":" behind a heading
};
Expected<std::vector<std::string>> tokenize(std::string_view sentence, Endings endings = Endings::kDropped);

}  // namespace goalnet::inference
