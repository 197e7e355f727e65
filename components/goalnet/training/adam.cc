#include "components/goalnet/training/adam.h"

#include <cmath>

namespace goalnet::inference::training {

Adam::Adam(Parameters& parameters, const Settings& settings) : parameters_(parameters), settings_(settings) {
  for (const auto& [name, tensor] : parameters_) {
    first.push_back(torch::zeros_like(tensor));
    second.push_back(torch::zeros_like(tensor));
  }
}

void Adam::step(double learning_rate) {
  torch::NoGradGuard no_gradients;
  ++steps;
  double squares = 0;
  for (const auto& [name, tensor] : parameters_) {
    if (tensor.grad().defined()) squares += tensor.grad().pow(2).sum().item<double>();
  }
  const double norm = std::sqrt(squares);
  const double scale = norm > settings_.largest_gradient ? settings_.largest_gradient / norm : 1;
  const double bias1 = 1 - std::pow(settings_.beta1, static_cast<double>(steps));
  const double bias2 = 1 - std::pow(settings_.beta2, static_cast<double>(steps));
  for (std::size_t i = 0; i < parameters_.size(); ++i) {
    torch::Tensor& tensor = parameters_[i].second;
    if (!tensor.grad().defined()) continue;  // a part that is switched off
    const torch::Tensor gradient = tensor.grad() * scale;
    first[i].mul_(settings_.beta1).add_(gradient, 1 - settings_.beta1);
    second[i].mul_(settings_.beta2).addcmul_(gradient, gradient, 1 - settings_.beta2);
    tensor.mul_(1 - learning_rate * settings_.weight_decay);
    tensor.addcdiv_(first[i], (second[i] / bias2).sqrt_().add_(settings_.epsilon), -learning_rate / bias1);
    tensor.mutable_grad().zero_();
  }
}

}  // namespace goalnet::inference::training
