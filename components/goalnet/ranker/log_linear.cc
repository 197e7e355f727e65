#include "components/goalnet/ranker/log_linear.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "components/goalnet/random.h"

namespace goalnet::inference {

void LogLinear::score(std::span<const std::uint32_t> features, std::span<const std::uint32_t> offsets,
                      std::vector<float>& scores) const {
  constexpr std::size_t kAtOnce = 4;
  const std::size_t count = offsets.size() - 1;
  scores.assign(count, 0.0f);
  for (std::size_t first = 0; first < count; first += kAtOnce) {
    const std::size_t last = std::min(first + kAtOnce, count);
    std::size_t common = 0;  // so many features all of them have
    if (last - first == kAtOnce) {
      std::array<const std::uint32_t*, kAtOnce> at;
      std::array<float, kAtOnce> sum{};
      common = features.size();
      for (std::size_t k = 0; k < kAtOnce; ++k) {
        at[k] = features.data() + offsets[first + k];
        common = std::min<std::size_t>(common, offsets[first + k + 1] - offsets[first + k]);
      }
      for (std::size_t f = 0; f < common; ++f)
        for (std::size_t k = 0; k < kAtOnce; ++k) sum[k] += weights_[at[k][f]];
      for (std::size_t k = 0; k < kAtOnce; ++k) scores[first + k] = sum[k];
    }
    for (std::size_t i = first; i < last; ++i)
      for (std::size_t f = offsets[i] + common; f < offsets[i + 1]; ++f) scores[i] += weights_[features[f]];
  }
}

void LogLinear::softmax(std::vector<float>& scores, float temperature) {
  const float most = *std::max_element(scores.begin(), scores.end());
  float sum = 0;
  for (float& score : scores) sum += score = std::exp((score - most) / temperature);
  for (float& score : scores) score /= sum;
}

void LogLinear::train(std::span<const Decision> decisions, const LogLinearOptions& options,
                      const std::function<bool(int, double)>& progress) {
  constexpr float kPower = 0.3f;  // by the log loss of unseen decisions, among 0, 0.1, ... 0.5
  std::vector<float> squares(weights_.size(), 1e-2f);
  std::vector<float> total(weights_.size(),
                           0.0f);  // of weights over the second half: their average generalises better
  std::vector<std::uint32_t> order(decisions.size());
  std::iota(order.begin(), order.end(), 0u);
  Random random(options.seed);
  std::vector<float> scores;
  int averaged = 0;
  for (int epoch = 0; epoch < options.epochs; ++epoch) {
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
    double loss = 0;
    for (const std::uint32_t index : order) {
      const Decision& decision = decisions[index];
      const std::size_t count = decision.target.size();
      const std::span<const std::uint32_t> features(decision.features);
      const auto of = [&](std::size_t i) {
        return features.subspan(decision.offsets[i], decision.offsets[i + 1] - decision.offsets[i]);
      };
      score(features, decision.offsets, scores);
      if (!decision.offset.empty())
        for (std::size_t i = 0; i < count; ++i) scores[i] += decision.offset[i];
      softmax(scores);
      for (std::size_t i = 0; i < count; ++i) {
        if (decision.target[i] > 0) loss -= decision.target[i] * std::log(std::max(scores[i], 1e-9f));
        const float gradient = decision.weight * (scores[i] - decision.target[i]);
        if (std::fabs(gradient) < 1e-3f) continue;
        for (const std::uint32_t feature : of(i)) {
          const float g = gradient + options.decay * weights_[feature] * 1000.0f;
          squares[feature] += g * g;
          weights_[feature] -= options.rate * g / std::pow(squares[feature], kPower);
        }
      }
    }
    if (2 * epoch >= options.epochs) {
      for (std::size_t i = 0; i < total.size(); ++i) total[i] += weights_[i];
      ++averaged;
    }
    if (progress && !progress(epoch, loss / static_cast<double>(decisions.size()))) break;
  }
  if (averaged > 0)
    for (std::size_t i = 0; i < total.size(); ++i) weights_[i] = total[i] / static_cast<float>(averaged);
}

}  // namespace goalnet::inference
