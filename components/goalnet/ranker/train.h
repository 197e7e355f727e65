// Trains the shipped model on a folder of demonstrations.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "components/goalnet/demonstration.h"
#include "components/goalnet/ranker/ranker_model.h"

namespace goalnet::inference {

struct TrainingOptions {
  RankerOptions ranker;
  bool given = true, none = true;  // which settings to train: with and without the demonstrations' grounding
  bool rerank = true;              // also train the choice among candidate runs
  LanguageTexts language;
  std::string command;  // what was typed; goes into the metadata
  // What is being done and how far it is (0..1); called now and then. Returning false stops: kCancelled.
  std::function<bool(const std::string& what, double fraction)> progress;
};

// Bit-identical for the same demonstrations and options.
Expected<RankerParts> train(const std::vector<Demonstration>& demonstrations, const TrainingOptions& options);

}  // namespace goalnet::inference
