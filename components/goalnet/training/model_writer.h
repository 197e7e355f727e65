// A trained network as a model file.
#pragma once

#include <map>
#include <string>

#include <torch/torch.h>

#include "components/goalnet/network/model_parts.h"
#include "components/goalnet/safetensors.h"
#include "components/goalnet/training/vocabulary.h"

namespace goalnet::inference::training {

// All tensors and the metadata that loading needs, "goalnet.kind" = "network" among them.
Expected<SafeTensorsWriter> make_model_file(const network::NetworkConfig& config,
                                            const Vocabulary& vocabulary,
                                            const std::map<std::string, torch::Tensor>& tensors,
                                            const network::Calibration& calibration);

}  // namespace goalnet::inference::training
