// What a message names that its reading does nothing with: a misreading mostly passes over part of what was
// said. Nothing here refuses anything (coverage.h does); these are signs of how sure to be
// (reading_confidence.h).
#pragma once

#include <vector>

#include "components/goalnet/language/language.h"
#include "components/goalnet/language/words.h"
#include "components/goalnet/ranker/instruction.h"
#include "components/goalnet/sym_sim.h"

namespace goalnet::inference {

struct LeftUnused {
  // Names of what no action uses, what none of it stands on, and what is neither denied nor to be left alone.
  int things = 0;       // to carry
  int places = 0;       // furniture, devices
  int beside = 0;       // of either, what stands where the used things stand or go: may only tell where
  int numbers = 0;      // "number three", where nothing used has that number and there are not as many
  int denied_used = 0;  // "no coffee", "not the glass", and yet it is used
  std::vector<std::string> words;  // those names and numbers, for messages
};

// `said`: the whole message as the grammar reads it first; `start`: before the first action.
LeftUnused left_unused(const Words& said, const std::vector<SymAction>& actions,
                       const Instruction& instruction, const SymState& start, const Language& language,
                       const Lexicon& lexicon, const Symbols& symbols);

// "not", "only", "but", ...: words that turn what is asked for round, and must therefore matter.
bool turns_round(const std::string& word);
// "sorry", "actually", "I mean", ...: what was said before may be taken back.
bool owns_slip(const std::string& word);

}  // namespace goalnet::inference
