// Proves that two parts of a goal can never hold together, where the delete relaxation sees no conflict.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "components/planner/budget.h"
#include "components/planner/ground_task.h"

namespace goalnet::planner {

// A pair of goal literals that exclude each other in every reachable state, if one is found. The proof is by
// induction: the pair does not hold at first, and every action that produces one of the two destroys the
// other, or needs something that excludes the other. A bounded effort: nothing found proves nothing.
std::optional<std::pair<Literal, Literal>> find_goal_mutex(const GroundTask& task, Budget& budget);

}  // namespace goalnet::planner
