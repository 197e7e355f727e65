// The network of components/goalnet/network/network.h in libtorch, for training: batched and differentiable.
// Same tensors, same formulas; a test compares the two.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include <torch/torch.h>

#include "components/goalnet/network/weights.h"
#include "components/goalnet/training/batch.h"

namespace goalnet::inference::training {

struct LossReport {
  torch::Tensor loss;  // mean over the decoded steps
  int steps = 0;       // steps decoded
  int right = 0;       // of them, with every choice the most probable one (unmasked)
};

// Scores at each decision of one step, for comparing with the Eigen network.
struct DecisionScores {
  std::vector<std::vector<float>> scores;  // token, main, (second | value) of each target in turn
};

class TorchNetwork {
 public:
  // Random weights (Xavier), vectors as given. `seed` fixes them.
  TorchNetwork(const network::NetworkConfig& config, const Vocabulary& vocabulary, std::uint64_t seed);

  // Names and tensors that are trained, in a fixed order.
  std::vector<std::pair<std::string, torch::Tensor>>& parameters() { return parameters_; }
  const torch::Tensor& tensor(const std::string& name) const { return tensors_.at(name); }
  // "words.vectors" and all parameters.
  const std::map<std::string, torch::Tensor>& tensors() const { return tensors_; }

  // Teacher-forced loss. `dropout` of the inputs of words and of the decoder's start; 0 when not training.
  // Its masks come from torch's generator.
  LossReport loss(std::span<const EncodedEpisode* const> episodes, const network::NameTable& names,
                  double dropout) const;
  // The same computation for one episode without dropout, with every score kept.
  std::vector<DecisionScores> scores(const EncodedEpisode& episode, const network::NameTable& names) const;

 private:
  struct Forward;
  LossReport run(std::span<const EncodedEpisode* const> episodes, const network::NameTable& names,
                 double dropout, std::vector<DecisionScores>* record) const;

  const network::NetworkConfig& config_;
  network::NetworkSizes sizes_;
  std::vector<std::pair<std::string, torch::Tensor>> parameters_;
  std::map<std::string, torch::Tensor> tensors_;
};

}  // namespace goalnet::inference::training
