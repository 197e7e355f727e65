// The encoding half of the training network: sentences, worlds and history of a batch of episodes.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include <torch/torch.h>

#include "components/goalnet/training/batch.h"

namespace goalnet::inference::training {

// GRUCell with libtorch's gate order. gates_in: rows x 3 n.
torch::Tensor gru(const torch::Tensor& gates_in, const torch::Tensor& hidden,
                  const torch::Tensor& hidden_bias, const torch::Tensor& state);

// Runs everything before the decoder when constructed. Steps of all episodes follow one another.
class TorchEncoding {
 public:
  using Tensors = std::map<std::string, torch::Tensor>;
  TorchEncoding(const network::NetworkConfig& config, const Tensors& tensors, const network::NameTable& names,
                std::span<const EncodedEpisode* const> episodes, double dropout);

  const std::vector<const StepExample*>& steps() const { return steps_; }
  std::int64_t max_objects() const { return objects_; }
  const torch::Tensor& objects() const { return encoded_; }   // steps x max_objects x object
  const torch::Tensor& object_mask() const { return mask_; }  // steps x max_objects, bool
  const torch::Tensor& start() const { return start_; }       // steps x decoder

 private:
  const torch::Tensor& w(const char* name) const { return tensors_.at(name); }
  torch::Tensor drop(const torch::Tensor& tensor) const;
  void encode_names(const network::NameTable& names);
  void encode_sentences();
  torch::Tensor read_direction(const torch::Tensor& inputs, const torch::Tensor& known, bool forward) const;
  void encode_objects();
  torch::Tensor attend(const torch::Tensor& weights, const torch::Tensor& mask) const;
  void encode_history();

  const network::NetworkConfig& config_;
  const Tensors& tensors_;
  std::span<const EncodedEpisode* const> episodes_;
  double dropout_;
  std::vector<const StepExample*> steps_;
  std::vector<std::int64_t> episode_of_;  // by step
  std::int64_t objects_ = 0, words_ = 0, longest_ = 0;
  torch::Tensor name_vectors_;  // slots x word
  torch::Tensor tokens_, token_mask_,
      sentence_;                 // episodes x words x 2 sentence; episodes x words; episodes x 2 sentence
  torch::Tensor step_sentence_;  // steps x 2 sentence
  torch::Tensor raw_, encoded_, mask_, mentioned_, context_, goal_objects_, history_, start_;
};

}  // namespace goalnet::inference::training
