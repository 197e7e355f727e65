// The steps that `goalnet bench infer` measures: a kitchen as large as the benchmark's, without data from
// outside.
#pragma once

#include <string>
#include <vector>

#include "components/goalnet/goal_model.h"

namespace goalnet::tools {

struct InferStep {
  std::string sentence;
  std::vector<WorldState> states;
  std::vector<Goal> goals;  // of the steps before

  inference::StepInput input() const { return {sentence, nullptr, states, goals}; }
};

// Instructions of different lengths, at their first and at later steps.
std::vector<InferStep> infer_steps();

}  // namespace goalnet::tools
