// The weights of a BERT-shaped sentence encoder (for example MiniLM) as Hugging Face's safetensors files name
// them.
#pragma once

#include <string>
#include <vector>

#include "components/core/outcome.h"
#include "components/goalnet/network/tensors.h"
#include "components/goalnet/safetensors.h"

namespace goalnet::inference {

// y = W x + b, applied to rows.
struct DenseLayer {
  network::Matrix weight;  // out x in
  network::Vector bias;
};
struct NormLayer {
  network::Vector scale, shift;
};
struct BertLayer {
  DenseLayer query, key, value, attention_out;
  NormLayer attention_norm;
  DenseLayer inner, outer;
  NormLayer norm;
};

struct BertWeights {
  int heads = 12;                    // attention heads; divides the hidden size
  float epsilon = 1e-12F;            // of the layer norms
  network::Matrix words, positions;  // vocabulary x hidden; positions x hidden
  network::Vector segment;           // the embedding of the first sentence: there is only one
  NormLayer norm;
  std::vector<BertLayer> layers;

  int hidden() const { return static_cast<int>(words.cols()); }
};

// Sizes follow from the tensors; `config` is the model's config.json (num_attention_heads, layer_norm_eps).
// Names may start with "bert.". Errors: kInvalidRequest naming the tensor or key.
Expected<BertWeights> load_bert_weights(const SafeTensors& file, const std::string& config);

}  // namespace goalnet::inference
