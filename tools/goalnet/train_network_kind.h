#pragma once

#include "tools/goalnet/train_kinds.h"

namespace goalnet::tools {

// The paper's network, by libtorch. Settings: the names of NetworkConfig's JSON (relations=false,
// temporal=both, …) and epochs, batch, learning_rate, weight_decay, dropout, without_grounding,
// state_feeding, replacement, compress, perturbed, simulator (symsim or planner),
// encoder (a folder with SentenceBERT's weights; see components/goalnet/network/README.md).
Expected<void> train_network_kind(const TrainRequest& request);

}  // namespace goalnet::tools
