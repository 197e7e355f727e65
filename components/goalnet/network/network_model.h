// The paper's GoalNet as a GoalModel: Eigen only, deterministic, without allocation once warm.
#pragma once

#include <memory>

#include "components/goalnet/encoder/sentence_encoder.h"
#include "components/goalnet/goal_model.h"
#include "components/goalnet/safetensors.h"

namespace goalnet::inference {

// Makes the model of a file whose metadata "goalnet.kind" is "network". A model trained with an external
// sentence encoder needs the same one again: as `encoder`, or in the folder that the environment variable
// GOALNET_SENTENCE_ENCODER names (bert_encoder.h). Others must not be given one. Errors:
// kInvalidRequest, one message that names the file.
Expected<std::unique_ptr<GoalModel>> make_network_model(const SafeTensors& file,
                                                        std::unique_ptr<SentenceEncoder> encoder = nullptr);

}  // namespace goalnet::inference
