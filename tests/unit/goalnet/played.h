// Made-up demonstrations for tests of training.
#pragma once

#include "components/goalnet/demonstration.h"
#include "components/goalnet/sym_sim.h"
#include "components/goalnet/sym_state.h"

namespace goalnet::inference {

// Adds the state after each of its actions; the first state is there.
inline void play_actions(Demonstration& demonstration, Symbols& symbols) {
  SymState state = to_sym_state(demonstration.states[0].facts, symbols);
  for (const std::string& text : demonstration.actions) {
    apply(*parse_action(text, symbols), state);
    demonstration.states.push_back({demonstration.states[0].objects, to_fact_set(state, symbols)});
  }
}

}  // namespace goalnet::inference
