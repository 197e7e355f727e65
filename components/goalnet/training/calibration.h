// How certain the model may be: fitted on steps that the training did not see.
#pragma once

#include <vector>

#include "components/goalnet/network/model_parts.h"
#include "components/goalnet/safetensors.h"
#include "components/goalnet/training/episodes.h"

namespace goalnet::inference::training {

struct CalibrationSample {
  double mean_log_probability;  // of the decoded choices
  bool right;                   // the decoded goal is the person's
};

// Logistic regression by Newton's method, held near {1, 3} by a weak prior. Deterministic.
network::Calibration fit_calibration(const std::vector<CalibrationSample>& samples);

// Decodes every step of the episodes with a model file and compares with what the person pursued. Only for
// models with a sentence encoding of their own.
Expected<std::vector<CalibrationSample>> calibration_samples(const SafeTensors& file,
                                                             const std::vector<Episode>& episodes,
                                                             bool with_grounding);

}  // namespace goalnet::inference::training
