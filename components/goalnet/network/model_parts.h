// The parts of a network model as they stand in a file: configuration, words, grammar, weights.
#pragma once

#include <memory>
#include <string>

#include "components/goalnet/network/grammar.h"
#include "components/goalnet/network/lexicon.h"
#include "components/goalnet/network/network_config.h"
#include "components/goalnet/network/weights.h"
#include "components/goalnet/safetensors.h"

namespace goalnet::inference::network {

// Turns a raw score of certainty into a probability of being right: 1 / (1 + exp(-(slope * x + offset))),
// where x is the mean log probability of the decoded predicates. Fitted on runs that the training did not
// see.
struct Calibration {
  double slope = 1;
  double offset = 3;
  double operator()(double mean_log_probability) const;
};

struct ModelParts {
  NetworkConfig config;
  Lexicon lexicon;
  Grammar grammar;
  NetworkWeights weights;
  Calibration calibration;
};

// Metadata keys of a network model, beside "goalnet.kind" = "network".
inline constexpr const char* kConfigKey = "goalnet.network";
inline constexpr const char* kLexiconKey = "goalnet.lexicon";
inline constexpr const char* kGrammarKey = "goalnet.grammar";
inline constexpr const char* kCalibrationKey = "goalnet.calibration";

// Checks everything; errors name the file and what is wrong. On the heap: the network keeps references into
// it.
Expected<std::unique_ptr<ModelParts>> load_parts(const SafeTensors& file);

}  // namespace goalnet::inference::network
