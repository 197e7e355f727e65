// The same step by libtorch, where this build has it.
#pragma once

#include <functional>
#include <vector>

#include "components/goalnet/safetensors.h"
#include "tools/bench/infer/steps.h"

namespace goalnet::tools {

// Runs the forward pass of step i, its decoded predicates given; empty in a build without libtorch.
std::function<void(std::size_t i)> make_infer_peer(const inference::SafeTensors& file,
                                                   const std::vector<InferStep>& steps);

}  // namespace goalnet::tools
