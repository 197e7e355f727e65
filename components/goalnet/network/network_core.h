// One inference step without strings: sentence, world and history in, decoded predicates out. What
// NetworkModel wraps and what the benchmarks measure.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "components/goalnet/goal_model.h"
#include "components/goalnet/network/decoder.h"
#include "components/goalnet/network/model_parts.h"
#include "components/goalnet/network/network.h"
#include "components/goalnet/network/world_encoder.h"

namespace goalnet::inference::network {

// Not thread-safe. step() allocates nothing once it has seen a world, sentence and history as large.
class NetworkCore {
 public:
  explicit NetworkCore(std::unique_ptr<ModelParts> parts);

  const ModelParts& parts() const { return *parts_; }
  // Sets the words of the instruction, for groundings and matching names; returns how many are known.
  int set_words(std::vector<std::string> texts);
  // Encodes the words last set, or an external encoder's vector.
  void encode_sentence() { network_.read_sentence(sentence_.words); }
  void encode_sentence(const Vector& external) { network_.read_sentence(external); }
  // Decodes the goal of the last state; `input.sentence` is not looked at. Errors: kInvalidRequest (too many
  // objects).
  Expected<const DecodedGoal*> step(const StepInput& input);

 private:
  Expected<void> read_world(const StepInput& input, std::size_t step);

  std::unique_ptr<ModelParts> parts_;
  NameTable names_;
  WorldEncoder world_encoder_;
  Network network_;
  Decoder decoder_;
  std::vector<std::string> texts_;
  EncodedSentence sentence_;
  EncodedWorld world_;
  DecodedGoal decoded_;
};

}  // namespace goalnet::inference::network
