// What a training has computed so far, stage by stage, in a safetensors file beside the model to come.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "components/core/outcome.h"

namespace goalnet::inference {

// Every stage depends on the data and the options alone, never on another stage's random numbers: a training
// that takes some stages from here ends with the same weights, bit by bit.
class Checkpoint {
 public:
  Checkpoint() = default;  // keeps nothing
  // Reads what an interrupted training left at `path`, if anything. `identity` says which training this is
  // (data, options, version). Errors: kInvalidRequest when the file is another training's or damaged.
  static Expected<Checkpoint> open(const std::string& path, const std::string& identity);

  // nullptr: not computed yet.
  const std::vector<float>* find(const std::string& stage) const;
  // Writes the file; finite numbers only. Errors: kInvalidRequest when it cannot be written.
  Expected<void> keep(const std::string& stage, std::vector<float> values);

 private:
  std::string path_, identity_;
  std::map<std::string, std::vector<float>> stages_;
};

}  // namespace goalnet::inference
