// How sure to be of a reading: a logistic function of signs, fitted on what became of instructions when they
// were first met (tools/fit_confidence; config/language/confidence.json).
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "components/core/outcome.h"

namespace goalnet::inference {

inline constexpr std::array<std::string_view, 13> kSignNames = {
    "ties",              // choices among equal objects that nothing told apart
    "loose",             // what was said of an object holds for none
    "generic",           // objects named by a word for many kinds
    "unused_things",     // the next five: see LeftUnused
    "unused_places",     //
    "beside",            //
    "unused_numbers",    //
    "denied_used",       //
    "unheard_turns",     // "not", "but", "only", ... without which the reading would be the same
    "unheard_slips",     // "sorry", "actually", ... in the same way
    "idle",              // much was said, and all of it is so already
    "corrected_itself",  // "no wait", read as a correction
    "conditions"};       // clauses behind "if"
using Signs = std::array<double, kSignNames.size()>;

class ReadingConfidence {
 public:
  // {"least": 0.6, "bias": 2.0, "weights": {"ties": -0.5, ...}}. Fails with kInvalidRequest.
  static Expected<ReadingConfidence> parse(std::string_view json, const std::string& name);

  // The probability that the reading is what was meant, 0..1.
  double of(const Signs& signs) const;
  // A reading less likely than that is not acted upon.
  double least() const { return least_; }

 private:
  double least_ = 0, bias_ = 0;
  Signs weights_{};
};

}  // namespace goalnet::inference
