// A sentence as one vector, made by something other than the network's own recurrent encoder.
#pragma once

#include <span>
#include <string_view>

#include "components/core/outcome.h"

namespace goalnet::inference {

// Deterministic. Not thread-safe: may keep scratch memory.
class SentenceEncoder {
 public:
  virtual ~SentenceEncoder() = default;
  // A short name stored in model files, so that a model is never run with another encoder than it was trained
  // with.
  virtual std::string_view name() const = 0;
  virtual int dimension() const = 0;
  // Writes dimension() floats of a sentence of valid UTF-8. kInvalidRequest for text it cannot read.
  virtual Expected<void> encode(std::string_view sentence, std::span<float> out) = 0;
};

}  // namespace goalnet::inference
