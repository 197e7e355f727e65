// The kinds of models that `goalnet train` can learn. Which of them a build has follows from what it links.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>

#include "components/core/outcome.h"

namespace goalnet::tools {

struct TrainRequest {
  std::filesystem::path data;  // a folder of demonstrations
  std::filesystem::path out;   // the model file to write
  std::uint64_t seed = 1;
  bool fresh = false;                           // forget a checkpoint instead of going on from it
  std::map<std::string, std::string> settings;  // --set name=value; each kind knows its own
  std::string command;                          // as typed, for the model's metadata
  // Called now and then from the training thread: share done (0..1) and a short line of what is measured.
  std::function<void(double done, const std::string& measured)> progress;
};

struct TrainKind {
  std::string_view name;  // --model NAME
  std::string_view summary;
  // Trains and writes the model. Errors: kInvalidRequest for data, settings or files.
  Expected<void> (*train)(const TrainRequest& request);
};

// At least one; the first is the default.
std::span<const TrainKind> train_kinds();

}  // namespace goalnet::tools
