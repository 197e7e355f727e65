// Replays a plan step by step, as the text of the domain says. Simple on purpose, and independent: it shares
// nothing with the search but the parser, so that it can judge the search.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "components/core/outcome.h"
#include "components/core/predicate.h"
#include "components/planner/problem.h"

namespace goalnet::planner {

struct Validation {
  std::int64_t cost = 0;                 // of the plan, by the problem's metric
  std::vector<std::string> final_facts;  // "(on a b)", sorted
};

// kInvalidRequest for an unknown action or wrong arguments, kNoPlan for a precondition that fails ("step 3,
// (load p t a): ... does not hold") or a goal not reached.
Expected<Validation> validate(const Problem& problem, const std::vector<Action>& plan);

}  // namespace goalnet::planner
