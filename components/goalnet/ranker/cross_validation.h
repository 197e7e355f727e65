// How well the shipped kind of model does on what it has not seen: trained anew for each fold.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "components/goalnet/evaluation.h"
#include "components/goalnet/other_sentences.h"
#include "components/goalnet/ranker/train.h"

namespace goalnet::inference {

// What no training demonstration of a fold shares with the tested ones.
enum class FoldBy {
  kScenario,  // the scenario
  kVerb,      // the verb: no training sentence holds a verb that the fold tests
};

struct Fold {
  std::vector<std::size_t> train, test;  // indices of demonstrations
};

// Perturbed demonstrations are never tested; by verb, neither are sentences without one (their main verb is
// the first). The same on every machine. Fails as make_parts() does.
Expected<std::vector<Fold>> make_folds(const std::vector<Demonstration>& demonstrations, FoldBy by, int folds,
                                       std::uint64_t seed, const LanguageTexts& language);

struct CrossValidationOptions {
  bool grounding = true;
  unsigned threads = 1;      // folds at a time
  TrainingOptions training;  // its progress is not called
  OtherSentences
      sentences;  // said instead of the recorded ones when testing; training hears the recorded ones
  // Share of the whole that is done, from one thread at a time.
  std::function<void(double done)> progress;
};

struct FoldScores {
  std::size_t trained_on = 0;
  Scores mean;
  std::vector<ModelRun> runs;
};

// Does not depend on the number of threads. Fails as train() does.
Expected<std::vector<FoldScores>> cross_validate(const std::vector<Demonstration>& demonstrations,
                                                 const std::vector<Fold>& folds,
                                                 const CrossValidationOptions& options);

// How far the models' confidence was the score they got: runs sorted by confidence, in bins of equally many.
struct CalibrationBin {
  double confidence = 0, sji = 0;  // means
  std::size_t runs = 0;
};
std::vector<CalibrationBin> calibration(const std::vector<FoldScores>& folds, std::size_t bins = 10);
// The mean distance between the bins' confidence and SJI.
double calibration_error(const std::vector<CalibrationBin>& bins);

}  // namespace goalnet::inference
