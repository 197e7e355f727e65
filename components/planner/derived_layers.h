// Derived predicates: which of them define themselves, and in which order those are computed.
//
// A definition that does not lead back to itself is only a name for its body and is written out where it is
// used. The others
// ("above" follows from "above") are computed anew in every state, layer by layer: what a definition needs
// not to hold must be known before, in a layer below.
#pragma once

#include <optional>

#include "components/planner/domain.h"

namespace goalnet::planner {

// Sets Domain::layer. The predicate whose definition needs that it does not hold itself, if there is one:
// then the definitions mean nothing.
std::optional<PredicateId> assign_layers(Domain& domain);

}  // namespace goalnet::planner
