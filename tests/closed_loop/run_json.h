// `goalnet run --json --private` and what it printed: other runs on this machine do not matter.
#pragma once

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/process.h"

namespace goalnet {

constexpr int kRunDomain = 84;  // ROS_DOMAIN_ID, though nobody hears of it

struct RunResult {
  int exit_code = -1;
  nlohmann::json json;

  // "not (…)": the fact is absent.
  bool holds(const std::string& fact) const {
    if (fact.starts_with("not ")) return !holds(fact.substr(4));
    const auto& facts = json["facts"];
    return std::find(facts.begin(), facts.end(), fact) != facts.end();
  }
  std::vector<std::string> actions() const {
    std::vector<std::string> all;
    for (const auto& step : json["steps"]) {
      for (const auto& action : step["actions"]) all.push_back(action);
    }
    return all;
  }
};

inline RunResult run_json(const std::vector<std::string>& arguments) {
  std::vector<std::string> all = {"run", "--json", "--private"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  const auto result = testing_support::run_goalnet(all, kRunDomain);
  auto json = nlohmann::json::parse(result.out, nullptr, false);
  if (!json.is_object())
    json = {{"message", "no JSON: " + result.err},
            {"facts", nlohmann::json::array()},
            {"steps", nlohmann::json::array()},
            {"outcome", ""},
            {"sim_time_s", 0.0},
            {"wall_time_s", 1.0}};
  return {result.exit_code, json};
}

}  // namespace goalnet
