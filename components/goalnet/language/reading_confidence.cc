#include "components/goalnet/language/reading_confidence.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace goalnet::inference {

Expected<ReadingConfidence> ReadingConfidence::parse(std::string_view text, const std::string& name) {
  ReadingConfidence confidence;
  try {
    const auto file = nlohmann::json::parse(text);
    confidence.least_ = file.at("least").get<double>();
    confidence.bias_ = file.at("bias").get<double>();
    for (std::size_t i = 0; i < kSignNames.size(); ++i)
      confidence.weights_[i] = file.at("weights").at(std::string(kSignNames[i])).get<double>();
  } catch (const nlohmann::json::exception& error) {
    return fail(Outcome::kInvalidRequest, name + ": " + error.what());
  }
  return confidence;
}

double ReadingConfidence::of(const Signs& signs) const {
  double sum = bias_;
  for (std::size_t i = 0; i < signs.size(); ++i) sum += weights_[i] * signs[i];
  return 1 / (1 + std::exp(-sum));
}

}  // namespace goalnet::inference
