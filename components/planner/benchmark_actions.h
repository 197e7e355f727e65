// Demonstrations spell actions their own way ("keep Mug_1 On Sink", "turn stoveknob_1"); the PDDL of
// config/domains/benchmark.pddl cannot. Conversion in both directions.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "components/core/outcome.h"
#include "components/core/predicate.h"

namespace goalnet::planner {

// "keep Mug_1 On Sink" → keep-on Mug_1 Sink; "turn stoveknob_1" → turn StoveKnob_1; "noop" → an action
// without name. A keep without a relation ("keep Mug_1 Coke_1 Microwave") is the release that it acted as.
// Words keep their spelling where the names of the domain differ only in case: look-up ignores case. Fails
// with kInvalidRequest for other verbs and counts of words.
Expected<Action> from_demonstration(std::string_view text);

// keep-on Mug_1 Sink → "keep Mug_1 On Sink"; turn-on and turn-off → "turn". The inverse, with the lower-case
// names of knobs, buttons and doors that demonstrations use.
std::string to_demonstration(const Action& action);

}  // namespace goalnet::planner
