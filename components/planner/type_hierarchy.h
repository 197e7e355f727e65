// Which types are above which.
#pragma once

#include <optional>
#include <vector>

#include "components/planner/formula.h"

namespace goalnet::planner {

// `parents`, by type: those directly above it. Fills `ancestors`: itself and all above, sorted, with 0
// ("object") above every type. A type that is above itself, if there is one: then `ancestors` means nothing.
std::optional<TypeId> find_ancestors(const std::vector<std::vector<TypeId>>& parents,
                                     std::vector<std::vector<TypeId>>* ancestors);

}  // namespace goalnet::planner
