// How sure to be of a reading: a logistic function of signs, fitted on labelled instructions
// (tools/fit_confidence; config/language/confidence.json).
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "components/goalnet/language/frames.h"

namespace goalnet::inference {

inline constexpr std::array<std::string_view, 9> kSignNames = {
    "corrected",    // words whose spelling was mended
    "synonyms",     // words replaced by a known one
    "ties",         // choices among equal objects that nothing told apart
    "loose",        // what was said of an object holds for none
    "generic",      // objects named by a word for many kinds
    "vague",        // adjectives that could not be checked
    "passed_over",  // statements and questions of which nothing was made
    "indirect",     // a wish or a complaint, not a command
    "support"};     // how far the learned runs agree, 0..1
using Signs = std::array<double, kSignNames.size()>;

// Counts are cut off at 3: more of the same says little more.
Signs signs_of(const Words& words, const Understanding& understanding, double support);

class ReadingConfidence {
 public:
  // {"bias": 2.0, "weights": {"corrected": -0.5, ...}}. Fails with kInvalidRequest.
  static Expected<ReadingConfidence> parse(std::string_view json, const std::string& name);

  // The probability that the reading is what was meant, 0..1.
  double of(const Signs& signs) const;

 private:
  double bias_ = 0;
  Signs weights_{};
};

}  // namespace goalnet::inference
