// Derived predicates are definitions: a use of one means its body. This is what the parser checks about them.
#pragma once

#include "components/planner/domain.h"

namespace goalnet::planner {

// Whether some definition of `predicate` uses it, directly or through other derived predicates.
bool depends_on_itself(const Domain& domain, PredicateId predicate);

}  // namespace goalnet::planner
