// How likely a part of a message is background: it asks for nothing itself ("I bought it ages ago", "so it
// softens a bit"). A logistic function over signs of the part, fitted on labelled instructions
// (tools/fit_background; config/language/background.json).
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "components/core/outcome.h"

namespace goalnet::inference {

class Background {
 public:
  // {"bias": -1.0, "weights": {"SUBJECT": 0.8, ...}}. Fails with kInvalidRequest.
  static Expected<Background> parse(std::string_view json, const std::string& name);

  // 0..1, for the signs of a SentencePart.
  double of(const std::vector<std::string>& signs) const;

 private:
  double bias_ = 0;
  std::unordered_map<std::string, double> weights_;
};

}  // namespace goalnet::inference
