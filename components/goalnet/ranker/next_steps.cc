#include "components/goalnet/ranker/next_steps.h"

#include <algorithm>

namespace goalnet::inference {

Plans::Plans(const std::vector<Plan>& plans) {
  for (const Plan& plan : plans) {
    auto& [weight, steps] = plans_.emplace_back(plan.weight, std::vector<Step>{});
    for (const StepKey key : plan.steps) {
      const std::size_t step = number(key);
      if (step == steps_.size()) steps_.push_back(key);
      const auto before = std::count_if(steps.begin(), steps.end(),
                                        [&](const Step& earlier) { return earlier.number == step; });
      steps.push_back({step, static_cast<std::uint32_t>(before)});
    }
  }
}

std::size_t Plans::number(StepKey step) const {
  return static_cast<std::size_t>(std::find(steps_.begin(), steps_.end(), step) - steps_.begin());
}

NextSteps::NextSteps(const Plans& plans, const std::vector<StepKey>& done) : shares_(plans.size(), 0.0f) {
  std::vector<std::uint32_t> times(plans.size() + 1, 0);  // done, of each step; of all others together
  for (const StepKey step : done) ++times[plans.number(step)];
  float total = 1e-6f;
  for (const auto& [plan_weight, steps] : plans.plans_) {
    const Plans::Step* next = nullptr;
    std::size_t common = 0;
    for (const Plans::Step& step : steps) {
      if (times[step.number] > step.before)
        ++common;
      else if (next == nullptr)
        next = &step;
    }
    const float fit = static_cast<float>(common + 1) / static_cast<float>(done.size() + 1);
    const float weight = plan_weight * fit * fit;
    total += weight;
    (next != nullptr ? shares_[next->number] : stop_) += weight;
  }
  for (float& share : shares_) share /= total;
  stop_ /= total;
}

}  // namespace goalnet::inference
