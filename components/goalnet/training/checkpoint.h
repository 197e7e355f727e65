// The state of a training after an epoch, in a safetensors file: weights, moments, counters, the curve so
// far.
#pragma once

#include <string>

#include "components/goalnet/training/adam.h"
#include "components/goalnet/training/trainer.h"

namespace goalnet::inference::training {

// `identity` says which training this is (data and options): another one is not resumed.
Expected<void> write_checkpoint(const std::string& path, const std::string& identity,
                                const Adam::Parameters& parameters, const Adam& adam,
                                const std::vector<EpochReport>& curve);
// Restores into `parameters`, `adam` and `curve`. Returns false when there is no such file.
Expected<bool> read_checkpoint(const std::string& path, const std::string& identity,
                               Adam::Parameters& parameters, Adam& adam, std::vector<EpochReport>& curve);

}  // namespace goalnet::inference::training
