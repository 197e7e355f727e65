// One action of a domain as schemas: one for each case of its parameters, its toggles and its disjunctions;
// see compiled_domain.h. Internal to the planner.
#pragma once

#include <cstdint>
#include <stop_token>

#include "components/planner/compiled_domain.h"

namespace goalnet::planner {

// Fills compiled.schemas; compiled.is_fluent is known. Not complete once `stop` asks.
void compile_actions(CompiledDomain& compiled, const std::stop_token& stop);

}  // namespace goalnet::planner
