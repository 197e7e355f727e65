// What else speaks for an action, beside the words and the world: what recorded neighbours of the instruction
// did, and what its grammar reads in it.
#pragma once

#include <cstdint>
#include <vector>

#include "components/goalnet/lexicon.h"
#include "components/goalnet/ranker/next_steps.h"
#include "components/goalnet/sym_sim.h"

namespace goalnet::inference {

inline constexpr ClassId kNoClass = 0xffff;

// How much the recorded neighbours speak for an action. See neighbours.h.
struct NeighbourVote {
  Verb verb;
  ClassId x, y;  // classes; kNoClass where the action has no such argument
  float weight;  // 0..1: share of the neighbours that did this anywhere in their run
};

// The same for single objects, by neighbours whose room looked alike: people who see the same room mean the
// same cup by "the cup".
struct Habit {
  SymAction action;
  float weight;  // 0..1
};

// The grammar's reading of an instruction in a world (language/frames.h).
struct Reading {
  std::vector<SymAction> macros;
  bool complete = false;  // every clause was understood
};

struct Hints {
  std::vector<NeighbourVote> votes;  // sorted by verb, x, y; each once
  std::vector<Habit> habits;         // sorted by action
  Reading reading;
  Plans plans_by_words;  // steps by class
  Plans plans_by_room;   // steps by object
};

}  // namespace goalnet::inference
