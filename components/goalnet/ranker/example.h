// A demonstration prepared for learning: its instruction seen in its world, and its actions compressed.
#pragma once

#include <string>
#include <vector>

#include "components/goalnet/demonstration.h"
#include "components/goalnet/ranker/candidates.h"
#include "components/goalnet/ranker/hints.h"
#include "components/goalnet/ranker/instruction.h"
#include "components/goalnet/sym_sim.h"

namespace goalnet::inference {

struct Example {
  std::string id, scenario;
  bool perturbed = false;
  Instruction given, none;         // seen with and without the demonstration's grounding
  std::vector<SymState> states;    // as recorded
  std::vector<SymAction> actions;  // as recorded; kStop where an action makes no sense
  Reading read_given, read_none;   // by the grammar
  // The fewest actions whose natural runs (with_means) give the recorded actions: (index of the state,
  // action).
  std::vector<std::pair<std::size_t, SymAction>> macros;
};

std::vector<Example> make_examples(const std::vector<Demonstration>& demonstrations, Lexicon& lexicon,
                                   const Language& language, Symbols& symbols);

// Classes that the examples kept something on or in.
Places learn_places(const std::vector<const Example*>& examples);

}  // namespace goalnet::inference
