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
  std::string command;     // what was typed; goes into the metadata
  std::string checkpoint;  // a file written after each stage and resumed from; empty: none
  // What is being done and how far it is (0..1); called now and then. Returning false stops: kCancelled.
  std::function<bool(const std::string& what, double fraction)> progress;
};

// Bit-identical for the same demonstrations and options, also when it was stopped and goes on from the
// checkpoint; whoever has written the model removes that file. Errors: kCancelled, kInvalidRequest (language
// texts, the checkpoint of another training).
Expected<RankerParts> train(const std::vector<Demonstration>& demonstrations, const TrainingOptions& options);

}  // namespace goalnet::inference
