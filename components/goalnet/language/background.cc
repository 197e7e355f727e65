#include "components/goalnet/language/background.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace goalnet::inference {

Expected<Background> Background::parse(std::string_view text, const std::string& name) {
  Background background;
  try {
    const auto file = nlohmann::json::parse(text);
    background.bias_ = file.at("bias").get<double>();
    background.weights_ = file.at("weights").get<std::unordered_map<std::string, double>>();
  } catch (const nlohmann::json::exception& error) {
    return fail(Outcome::kInvalidRequest, name + ": " + error.what());
  }
  return background;
}

double Background::of(const std::vector<std::string>& signs) const {
  double sum = bias_;
  for (const std::string& sign : signs)
    if (const auto it = weights_.find(sign); it != weights_.end()) sum += it->second;
  return 1 / (1 + std::exp(-sum));
}

}  // namespace goalnet::inference
