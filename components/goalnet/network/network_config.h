// Sizes and parts of the GoalNet network. Every part of the paper's model can be switched off, for its
// ablations.
#pragma once

#include <string>

#include "components/core/outcome.h"

namespace goalnet::inference::network {

// What the recurrent memory reads at each step.
enum class TemporalContext {
  kNone,      // no memory: each step looks at the present only
  kPositive,  // the facts last predicted to hold (the paper's choice)
  kBoth,      // the facts last predicted to hold and not to hold
  kState,     // the encoded present state
};

enum class SentenceEncoding {
  kRecurrent,  // word vectors read by a bidirectional GRU, pooled by attention (self-contained)
  kWordMean,   // the mean of word vectors (the paper's ConceptNet exploration)
  kExternal,   // a vector made elsewhere, for example by SentenceBERT (encoder/)
};

struct NetworkConfig {
  // Sizes: numbers of floats.
  int word = 64;           // a stored word vector
  int sentence = 32;       // the GRU's state in each direction; a sentence vector is twice as long
  int object = 32;         // an encoded object
  int history = 48;        // the state of the temporal LSTM
  int decoder = 64;        // the state of the decoder
  int external = 0;        // the vector of an external sentence encoder, 0 without one
  int max_predicates = 8;  // most predicates decoded in one step

  // Parts.
  SentenceEncoding encoding = SentenceEncoding::kRecurrent;
  TemporalContext temporal = TemporalContext::kPositive;
  bool relations = true;              // graph messages along On, In and Near
  bool instance_grounding = true;     // which objects the sentence's words may mean
  bool instruction_attention = true;  // objects and words pooled by attention; off: their means
  bool goal_object_attention = true;  // the mentioned objects pooled separately
  bool positive = true;               // predict facts that shall hold
  bool negative = true;               // predict facts that shall not hold
  bool grammar_mask = true;           // only well-formed predicates that are not true yet

  bool operator==(const NetworkConfig&) const = default;
};

// JSON of a config, with sorted keys: the metadata "goalnet.network" of a model file.
std::string to_json(const NetworkConfig& config);
// The inverse. Unknown keys, wrong types and sizes outside 1..1024 are refused with kInvalidRequest.
Expected<NetworkConfig> parse_network_config(const std::string& json);

}  // namespace goalnet::inference::network
