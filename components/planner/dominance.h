// Finds effects for whose sake a schema need not be grounded; see CompiledEffect::dominated.
#pragma once

#include "components/planner/compiled_domain.h"

namespace goalnet::planner {

// Schema B dominates effect e of schema A if B's parameters are all determined by the literal of e, B's
// precondition is part of A's, B's effects are among A's, and B costs no more. A plan that uses A only for e
// can use B instead: B is possible wherever A is, and does not change what A changes besides. If something
// else that A does is needed, A is grounded for that.
void mark_dominated_effects(CompiledDomain& compiled);

}  // namespace goalnet::planner
