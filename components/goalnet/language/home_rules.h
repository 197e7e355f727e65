// What actions do at home where the benchmark's rules (SymSim) differ, and what an action is for.
#pragma once

#include <vector>

#include "components/goalnet/sym_sim.h"

namespace goalnet::inference {

// As apply(), with contents that move when poured, any syrup squeezed out, and heat where there is fire or a
// running microwave.
void apply_at_home(const SymAction& action, SymState& state);

// What an action is for, without its side effects: a robot that puts a mug down need not be told to let go of
// it. Water counts for what is in `handled` only: what stands in the sink anyway is no purpose. Heat comes by
// itself, some time later.
SymDelta purpose(const SymAction& action, const SymState& before, const std::vector<Symbol>& handled);

}  // namespace goalnet::inference
