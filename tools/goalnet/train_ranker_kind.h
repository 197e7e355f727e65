#pragma once

#include "tools/goalnet/train_kinds.h"

namespace goalnet::tools {

// Trains the feature-sharing ranker (components/goalnet/ranker/train.h). Needs no libtorch. It takes about
// a minute, so an interrupted training simply begins again; the weights come out the same to the bit.
Expected<void> train_ranker_kind(const TrainRequest& request);

}  // namespace goalnet::tools
