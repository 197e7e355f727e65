// Trains the network: teacher forcing, state feeding, augmentation; resumable and repeatable to the bit.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "components/goalnet/demonstration.h"
#include "components/goalnet/encoder/sentence_encoder.h"
#include "components/goalnet/network/network_config.h"
#include "components/goalnet/safetensors.h"
#include "components/goalnet/training/state_feeding.h"
#include "components/goalnet/training/vocabulary.h"

namespace goalnet::inference::training {

struct TrainOptions {
  network::NetworkConfig config;
  std::uint64_t seed = 1;
  int epochs = 40;
  int batch = 32;               // episodes
  double learning_rate = 3e-3;  // at its highest; falls to nothing along a cosine
  double weight_decay = 0.03;
  double dropout = 0.25;
  double without_grounding = 0.5;            // share of episodes shown as a deployed robot sees them
  double state_feeding = 0.2;                // the paper's p; 0 for plain teacher forcing
  int feeding_from = 4;                      // first epoch with state feeding: before, choices are noise
  double replacement = 0.3;                  // share of episodes with objects replaced by similar ones
  bool compress = true;                      // labels compressed (episodes.h)
  bool perturbed = false;                    // also learn from the randomly perturbed demonstrations
  bool with_planner = false;                 // state feeding with plans instead of the paper's SymSim
  std::shared_ptr<SentenceEncoder> encoder;  // for SentenceEncoding::kExternal
  std::string checkpoint;                    // a file written after each epoch and resumed from; empty: none
  std::string command;                       // how this training was started, for the model file
  std::string constants;                     // constants.json, may be missing
};

struct EpochReport {
  int epoch = 0, epochs = 0;
  double loss = 0, accuracy = 0;                    // training steps, with dropout
  double held_out_loss = 0, held_out_accuracy = 0;  // 0 without held-out demonstrations
  double seconds = 0, seconds_left = 0;
};
using Progress = std::function<void(const EpochReport&)>;

struct TrainedNetwork {
  SafeTensorsWriter file;
  std::vector<EpochReport> curve;
};

// `held_out` is only measured, never learned from. `things` completes the objects of each state. One thread.
// Errors: kInvalidRequest (no usable demonstration, a checkpoint of another training).
Expected<TrainedNetwork> train_network(const std::vector<Demonstration>& demonstrations,
                                       const std::vector<Demonstration>& held_out, const Lexicon& things,
                                       const WordVectors& vectors, const TrainOptions& options,
                                       const Progress& progress);

}  // namespace goalnet::inference::training
