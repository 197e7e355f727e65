// Reads the recorded demonstrations of the GoalNet benchmark (one JSON file each).
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "components/core/outcome.h"
#include "components/core/predicate.h"
#include "components/goalnet/goal_model.h"

namespace goalnet::inference {

// One person's way of doing what an instruction says. All names are in the spelling of the world states.
struct Demonstration {
  std::string id;          // the file name without ".json", for example "263_450"
  std::string scenario;    // what stands before '_': folds are grouped by it
  bool perturbed = false;  // an "a_*" file: actions were perturbed at random; never scored
  std::string sentence;
  Grounding grounding;               // names without parentheses; unknown ones stay (models ignore them)
  std::vector<WorldState> states;    // before each action, and the last one; at least one
  std::vector<Goal> steps;           // the facts added and removed by each action: states.size() - 1
  std::vector<std::string> actions;  // as spelled in the file, without the closing "noop"
};

// Reads one file. Fails with kInvalidRequest: file, key and what was expected there.
Expected<Demonstration> read_demonstration(const std::filesystem::path& path);

// The same from text; `name` stands in messages and gives the id. For tests and the fuzzer.
Expected<Demonstration> parse_demonstration(std::string_view json, const std::string& name);

// All *.json of a folder in the order of their names. Fails as above for the first bad file, and for a folder
// that is missing or holds none.
Expected<std::vector<Demonstration>> read_demonstrations(const std::filesystem::path& folder);

// A fingerprint (FNV-1a, 64 bit) of ids, sentences, groundings, states and actions: says which data a model
// saw.
std::uint64_t fingerprint(const std::vector<Demonstration>& demonstrations);

}  // namespace goalnet::inference
