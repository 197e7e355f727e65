// The scores of odd and of even scenarios apart: whoever mends something while looking at the odd ones learns
// from the even ones whether it helps elsewhere, too.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "components/goalnet/evaluation.h"

namespace goalnet::tools {

// One line for each half; nothing for runs whose scenario is no number.
void print_halves(const std::vector<inference::ModelRun>& runs);
// "odd" and "even": count and scores.
void add_halves(nlohmann::json& object, const std::vector<inference::ModelRun>& runs);

}  // namespace goalnet::tools
