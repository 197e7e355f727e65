// Trains and scores one variant on one fold, and keeps results in a file, so that `goalnet ablate` can go on
// later.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "components/goalnet/demonstration.h"
#include "components/goalnet/lexicon.h"
#include "tools/goalnet/ablate_variants.h"

namespace goalnet::tools {

struct AblateInput {
  std::vector<inference::Demonstration> demonstrations;
  inference::Lexicon things;
  inference::training::WordVectors vectors;
  std::string constants;
  int folds = 5;  // scenarios are dealt into this many
  int epochs = 30;
  std::uint64_t seed = 1;
};

// {"variant", "fold", "seconds" (training alone, wall clock; of the shipped model also its tests),
// "cpu_seconds", "given" and "none" {"sji", "ied", "f1", "grr", "exact"}, "sizes" [[changed facts, sji, f1,
// grr] of each demonstration, grounding given], "curve" [[loss, accuracy, held-out loss, held-out accuracy]
// by epoch]}.
Expected<nlohmann::json> ablate_one(const Variant& variant, int fold, const AblateInput& input,
                                    const std::function<void(const std::string&)>& report);

}  // namespace goalnet::tools
