// The parts of a message, before any grammar: what may be a request of its own, or only tell something.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace goalnet::inference {

class Language;
class Lexicon;

struct SentencePart {
  std::size_t begin = 0, end = 0;  // among the words; punctuation belongs to no part
  bool within = false;             // stands in the middle of a clause: "..., [like the last time], ..."
  std::vector<std::string> signs;  // what tells requests from the rest; see Background
};

// Parts end at punctuation and before words that begin clauses ("so", "because", "which", "could you", ...).
std::vector<SentencePart> sentence_parts(const std::vector<std::string>& tokens, const Language& language);

// The words without those parts. Of the things that a part names "told_of THINGS" stays, so that "it" can be
// one.
std::vector<std::string> without_parts(const std::vector<std::string>& tokens,
                                       const std::vector<SentencePart>& parts, const std::vector<bool>& aside,
                                       const Language& language, const Lexicon& lexicon);

}  // namespace goalnet::inference
