// The recorded demonstrations in ../shared/data, for tests that need them; absent on most machines.
#pragma once

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "components/core/predicate.h"

namespace goalnet::planner {

struct Demonstration {
  std::string name;
  std::vector<WorldState> states;
  std::vector<std::string> actions;
};

inline std::filesystem::path demonstration_folder() {
  return std::filesystem::path(GOALNET_SOURCE_DIR) / ".." / "shared" / "data" / "goalnet";
}

inline std::vector<Demonstration> load_demonstrations() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(demonstration_folder() / "train")) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  const auto constants = nlohmann::json::parse(std::ifstream(demonstration_folder() / "constants.json"));
  const auto objects = constants["all_objects"].get<std::vector<std::string>>();
  std::vector<Demonstration> result;
  for (const auto& file : files) {
    const auto json = nlohmann::json::parse(std::ifstream(file));
    Demonstration demo{file.stem().string(), {}, json["action_seq"].get<std::vector<std::string>>()};
    for (const auto& state : json["initial_states"]) {
      std::vector<Predicate> facts;
      for (const auto& text : state) {
        if (auto fact = parse_predicate(text.get<std::string>())) facts.push_back(std::move(*fact));
      }
      demo.states.push_back({objects, FactSet(std::move(facts))});
    }
    result.push_back(std::move(demo));
  }
  return result;
}

}  // namespace goalnet::planner
