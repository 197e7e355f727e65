// What `goalnet ablate` trains and scores: the paper's model, its baseline, ablations and explorations, and
// the shipped model beside them.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "components/goalnet/training/trainer.h"

namespace goalnet::tools {

// SJI, IED, F1, GRR.
using PaperScores = std::array<double, 4>;

struct Variant {
  std::string_view name, title;
  enum class Group { kModel, kAblation, kExploration } group;
  enum class Kind { kNetwork, kBaseline, kShipped } kind;
  void (*change)(inference::training::TrainOptions&);  // of a network's training; else null
  std::optional<PaperScores> paper;                    // on the paper's test set, where we know its numbers
};

std::span<const Variant> variants();

}  // namespace goalnet::tools
