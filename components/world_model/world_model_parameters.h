// What must hold between the world model's parameters (their table is WorldModelNode::describe).
#pragma once

#include "components/core/outcome.h"
#include "components/world_model/params.h"

namespace goalnet::world_model {

// kInvalidRequest, naming the parameter, where a threshold's end is tighter than its begin.
Expected<void> check_thresholds(const Params& params);

}  // namespace goalnet::world_model
