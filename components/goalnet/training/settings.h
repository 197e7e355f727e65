// Training options by name, for the command line.
#pragma once

#include <map>
#include <string>

#include "components/goalnet/training/trainer.h"

namespace goalnet::inference::training {

// Names: those of NetworkConfig's JSON and those of TrainOptions; simulator is "symsim" or "planner". Errors:
// kInvalidRequest for an unknown name or a value that does not fit.
Expected<void> apply_settings(const std::map<std::string, std::string>& settings, TrainOptions& options);

}  // namespace goalnet::inference::training
