#include "components/goalnet/ranker/next_steps.h"

#include <algorithm>
#include <optional>

namespace goalnet::inference {

NextSteps::NextSteps(const std::vector<Plan>& plans, const std::vector<StepKey>& done) {
  float total = 1e-6f;
  std::vector<bool> met;  // of what was done
  for (const Plan& plan : plans) {
    met.assign(done.size(), false);
    std::size_t common = 0;
    std::optional<StepKey> next;
    for (const StepKey step : plan.steps) {
      std::size_t i = 0;
      while (i < done.size() && (done[i] != step || met[i])) ++i;
      if (i < done.size())
        met[i] = true, ++common;
      else if (!next)
        next = step;
    }
    const float fit = static_cast<float>(common + 1) / static_cast<float>(done.size() + 1);
    const float weight = plan.weight * fit * fit;
    total += weight;
    if (!next) {
      stop_ += weight;
      continue;
    }
    const auto known =
        std::find_if(shares_.begin(), shares_.end(), [&](const auto& share) { return share.first == *next; });
    if (known == shares_.end())
      shares_.emplace_back(*next, weight);
    else
      known->second += weight;
  }
  for (auto& [step, share] : shares_) share /= total;
  stop_ /= total;
}

float NextSteps::share(StepKey step) const {
  for (const auto& [known, share] : shares_)
    if (known == step) return share;
  return 0;
}

}  // namespace goalnet::inference
