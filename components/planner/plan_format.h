// Plans as text, in the format of the International Planning Competition.
#pragma once

#include <string>

#include "components/planner/plan.h"

namespace goalnet::planner {

// "(move a b)\n(pick ball)\n; cost = 2 (unit cost)\n"; with_costs: the problem minimises total-cost.
std::string to_competition_format(const Plan& plan, bool with_costs);

// "; expanded = 12\n...": search statistics as comments of that format.
std::string statistics_as_comments(const Plan& plan);

}  // namespace goalnet::planner
