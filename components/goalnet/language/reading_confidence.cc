#include "components/goalnet/language/reading_confidence.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace goalnet::inference {

Signs signs_of(const Words& words, const Understanding& understanding, double support) {
  const auto count = [](int n) { return static_cast<double>(std::clamp(n, 0, 3)); };
  return {count(words.corrected),
          count(words.synonyms),
          count(understanding.doubts.ties),
          count(understanding.doubts.loose),
          count(understanding.doubts.generic),
          count(understanding.doubts.vague),
          count(understanding.passed_over),
          understanding.indirect ? 1.0 : 0.0,
          std::clamp(support, 0.0, 1.0)};
}

Expected<ReadingConfidence> ReadingConfidence::parse(std::string_view text, const std::string& name) {
  ReadingConfidence confidence;
  try {
    const auto file = nlohmann::json::parse(text);
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
