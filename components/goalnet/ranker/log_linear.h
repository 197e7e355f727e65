// A log-linear choice model: p(candidate) ~ exp(sum of its features' weights). Training is deterministic.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace goalnet::inference {

// The candidates of one decision: features of candidate i are features[offsets[i] .. offsets[i + 1]).
struct Decision {
  std::vector<std::uint32_t> features;
  std::vector<std::uint32_t> offsets;  // one more than candidates
  std::vector<float> target;           // what share of belief each candidate should have; sums to 1
  std::vector<float> offset;           // added to the candidates' scores while learning; empty: zeros
  float weight = 1;
};

struct LogLinearOptions {
  int epochs = 10;
  float rate = 0.008f;  // of the step, see LogLinear::train
  float decay = 2e-6f;  // L2, applied to what is touched
  std::uint64_t seed = 1;
};

class LogLinear {
 public:
  explicit LogLinear(std::size_t buckets) : weights_(buckets, 0.0f) {}

  float score(std::span<const std::uint32_t> features) const {
    float sum = 0;
    for (const std::uint32_t feature : features) sum += weights_[feature];
    return sum;
  }
  // Of each candidate, features[offsets[i] .. offsets[i + 1]). Several at once: one alone waits for its sum.
  void score(std::span<const std::uint32_t> features, std::span<const std::uint32_t> offsets,
             std::vector<float>& scores) const;
  // Replaces `scores` by probabilities at the given temperature.
  static void softmax(std::vector<float>& scores, float temperature = 1);

  // Steps shrink with the sum of squared gradients to the power of 0.3. AdaGrad's 0.5 lets rare features
  // learn too fast, 0 lets them learn too little (Duchi et al. 2011 for the family). `progress(epoch, loss)`
  // after each epoch; returning false ends the training early.
  void train(std::span<const Decision> decisions, const LogLinearOptions& options,
             const std::function<bool(int, double)>& progress = {});

  std::vector<float>& weights() { return weights_; }
  const std::vector<float>& weights() const { return weights_; }

 private:
  std::vector<float> weights_;
};

}  // namespace goalnet::inference
