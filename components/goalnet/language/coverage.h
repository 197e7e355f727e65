// Whether a reading uses all that the message names: who names two things and gets one of them brought was
// not understood.
#pragma once

#include <cstddef>
#include <vector>

#include "components/goalnet/language/clause.h"
#include "components/goalnet/language/resolve.h"
#include "components/goalnet/sym_sim.h"

namespace goalnet::inference {

// A command and the actions that were made of it.
struct ReadCommand {
  const Clause* clause = nullptr;
  std::size_t begin = 0, end = 0;  // among the actions
};

struct ReadMessage {
  const Words& words;
  const ParsedSentence& sentence;
  const std::vector<ReadCommand>& commands;
  const std::vector<SymAction>& actions;  // of all commands
};

// The first thing of the room that the message names and that neither an action, a clause that only tells,
// forbids or excludes something nor a place uses; kNone: all are used. Only what can be carried counts:
// furniture mostly tells where. `start`: before the first action.
Symbol unused_thing(const ReadMessage& message, const Language& language, const Lexicon& lexicon,
                    const Resolver& resolver, const SymState& start);

}  // namespace goalnet::inference
