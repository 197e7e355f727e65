// An action as one number.
#pragma once

#include <cstdint>

#include "components/goalnet/sym_sim.h"

namespace goalnet::inference {

// Of its things or of their classes.
using StepKey = std::uint64_t;
constexpr StepKey step_key(Verb verb, std::uint16_t x, std::uint16_t y) {
  return static_cast<StepKey>(verb) << 32 | static_cast<StepKey>(x) << 16 | y;
}

}  // namespace goalnet::inference
