// Several episodes as arrays that the training network reads. No libtorch here: plain vectors.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "components/goalnet/network/world_encoder.h"
#include "components/goalnet/training/episodes.h"
#include "components/goalnet/training/vocabulary.h"

namespace goalnet::inference::training {

// One predicate to learn. -1 where there is no such part.
struct Target {
  int token = network::kStopToken, main = -1, second = -1, value = -1;
};

// One step: what the network sees and what it shall decode, closed by a stop.
struct StepExample {
  network::EncodedWorld world;
  std::vector<Target> targets;  // empty: nothing to learn here
  int goals_before = 0;         // how many goals the memory has read
};

// One episode, encoded.
struct EncodedEpisode {
  std::vector<int> words;
  std::vector<float> external;  // the sentence by an external encoder; empty without one
  std::vector<StepExample> steps;
  std::vector<std::vector<network::PastPredicate>> past;  // by pursued goal
};

// Encodes episodes for one configuration. Owns the table of names that the encoded worlds point into.
class EpisodeEncoder {
 public:
  EpisodeEncoder(const network::NetworkConfig& config, const Vocabulary& vocabulary);

  // `with_grounding` off: as a deployed robot sees it. Goals that cannot be told in the world's objects are
  // left out.
  Expected<EncodedEpisode> encode(const Episode& episode, bool with_grounding);
  const network::NameTable& names() const { return names_; }

 private:
  std::vector<Target> targets_of(const Goal& goal, const WorldState& state) const;

  const network::NetworkConfig& config_;
  const Vocabulary& vocabulary_;
  network::NameTable names_;
  network::WorldEncoder worlds_;
};

}  // namespace goalnet::inference::training
