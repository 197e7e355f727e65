// A sentence as clauses: a verb's frame with the things it is about, by role.
#pragma once

#include <string>
#include <vector>

#include "components/goalnet/language/language.h"
#include "components/goalnet/ranker/instruction.h"

namespace goalnet::inference {

enum class Role : std::uint8_t { kDirect, kDestination, kSource, kWith };

// "both empty cups", "it", "the shelf pillow".
struct NounPhrase {
  Role role = Role::kDirect;
  std::string phrase;  // normal form; empty for a pronoun
  bool pronoun = false;
  bool plural = false;
  bool all = false;      // all, every, each
  int count = 0;         // "two", "both"; 0 when not said
  int ordinal = 0;       // "second" -> 2; 0 when not said
  bool some = false;     // "some ice cream"
  bool inside = false;   // "in", "into", "inside" before a destination
  std::string modifier;  // "shelf" of "shelf pillow"
  std::vector<std::string> adjectives;
};

struct Clause {
  Frame frame = Frame::kNone;
  std::string verb;
  std::vector<NounPhrase> phrases;
  std::vector<std::string> particles;  // on, off, up, down, out, away
  std::vector<std::string> unknown;    // words that mean nothing here and stand where a thing should
  std::vector<std::string> words;

  bool has(const std::string& word) const;
  bool has_particle(const std::string& word) const;
};

struct ParsedSentence {
  std::vector<Clause> clauses;
  std::vector<std::string> stray;  // unknown words outside any clause with a verb
};

ParsedSentence parse_clauses(const Instruction& instruction, const Language& language);

}  // namespace goalnet::inference
