// What neighbours would do next: of each neighbour's run the first step that was not done yet.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "components/goalnet/ranker/step_key.h"

namespace goalnet::inference {

// A neighbour's whole run, carried over to the things that this instruction names.
struct Plan {
  float weight = 0;  // 0..1; those of all plans sum to 1
  std::vector<StepKey> steps;
};

// The plans of all neighbours, their steps as small numbers: they are gone through at every moment.
class Plans {
 public:
  Plans() = default;
  explicit Plans(const std::vector<Plan>& plans);
  // The number of a step; size() when it is in no plan.
  std::size_t number(StepKey step) const;
  std::size_t size() const { return steps_.size(); }

 private:
  friend class NextSteps;
  struct Step {
    std::size_t number;
    std::uint32_t before;  // how often it comes earlier in the same plan
  };
  std::vector<StepKey> steps_;  // each once
  std::vector<std::pair<float, std::vector<Step>>> plans_;
};

class NextSteps {
 public:
  // `done`: the run so far, in the keys of the plans. A plan that shares little with it counts less.
  NextSteps(const Plans& plans, const std::vector<StepKey>& done);
  // Shares of the plans, 0..1: that would do this now, and that would stop.
  float share(std::size_t number) const { return number < shares_.size() ? shares_[number] : 0; }
  float stop() const { return stop_; }

 private:
  std::vector<float> shares_;  // by number
  float stop_ = 0;
};

}  // namespace goalnet::inference
