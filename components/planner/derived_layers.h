// Derived predicates: which of them are computed, and in which order.
//
// A definition that does not lead back to itself is only a name for its body and is written out where it is
// used, unless that gets very long. The others ("above" follows from "above") are computed anew in every
// state, layer by layer: what a definition needs not to hold must be known before, in a layer below.
#pragma once

#include <optional>
#include <stop_token>

#include "components/planner/domain.h"

namespace goalnet::planner {

// Sets Domain::layer. The predicate whose definition needs that it does not hold itself, if there is one:
// then the definitions mean nothing.
// Means nothing where `stop` asked meanwhile.
std::optional<PredicateId> assign_layers(Domain& domain, const std::stop_token& stop = {});

}  // namespace goalnet::planner
