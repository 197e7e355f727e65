// The paper's baseline: She and Chai 2016, "Incremental acquisition of verb hypothesis space towards physical
// world interaction". Each verb has a space of hypotheses (what changes when it is done), made from
// demonstrations; a log-linear model over hand-made features ranks them for a sentence and a world. The best
// one is the whole goal, predicted once at the start.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "components/goalnet/baseline/verb_frames.h"
#include "components/goalnet/demonstration.h"
#include "components/goalnet/goal_model.h"
#include "components/goalnet/network/lexicon.h"

namespace goalnet::inference::baseline {

inline constexpr int kSheFeatures = 17;

// How a hypothesis came about.
struct Evidence {
  int whole = 0;                                    // demonstrations of which it is all that changed
  int part = 0;                                     // of which it is a part
  std::vector<std::vector<std::string>> sentences;  // words of (at most ten of) the sentences, sorted
};

struct SheParts {
  // verb -> hypothesis -> the demonstrations behind it. The verb "" holds the hypotheses of all verbs.
  std::map<std::string, std::map<Hypothesis, Evidence>> spaces;
  std::vector<double> weights = std::vector<double>(kSheFeatures);
  network::Lexicon lexicon;
};

// Learns spaces and weights. `states` of the demonstrations should be complete (all objects listed).
// Deterministic.
std::shared_ptr<const SheParts> train_she(const std::vector<Demonstration>& demonstrations,
                                          network::Lexicon lexicon);

// A model over shared parts; safe to make one per thread.
std::unique_ptr<GoalModel> make_she_model(std::shared_ptr<const SheParts> parts);

}  // namespace goalnet::inference::baseline
