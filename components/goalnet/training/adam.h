// AdamW over a fixed list of tensors. Our own, so that its whole state can be stored and restored bit for
// bit.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <torch/torch.h>

namespace goalnet::inference::training {

class Adam {
 public:
  struct Settings {
    double beta1 = 0.9, beta2 = 0.999, epsilon = 1e-8;
    double weight_decay = 1e-2;   // times the learning rate, taken from every weight at each step
    double largest_gradient = 5;  // norm of all gradients together; longer ones are shortened
  };
  using Parameters = std::vector<std::pair<std::string, torch::Tensor>>;

  Adam(Parameters& parameters, const Settings& settings);
  // One step with the gradients that backward() left, which it clears.
  void step(double learning_rate);

  std::int64_t steps = 0;
  std::vector<torch::Tensor> first, second;  // moments, in the order of the parameters

 private:
  Parameters& parameters_;
  Settings settings_;
};

}  // namespace goalnet::inference::training
