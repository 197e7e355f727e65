// What neighbours would do next: of each neighbour's run the first step that was not done yet.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "components/goalnet/ranker/hints.h"

namespace goalnet::inference {

class NextSteps {
 public:
  // `done`: the run so far, in the keys of the plans. A plan that shares little with it counts less.
  NextSteps(const std::vector<Plan>& plans, const std::vector<StepKey>& done);
  // Shares of the plans, 0..1: that would do this now, and that would stop.
  float share(StepKey step) const;
  float stop() const { return stop_; }

 private:
  std::vector<std::pair<StepKey, float>> shares_;  // few: at most one for each plan
  float stop_ = 0;
};

}  // namespace goalnet::inference
