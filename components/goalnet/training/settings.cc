#include "components/goalnet/training/settings.h"

#include <array>
#include <utility>

#include <nlohmann/json.hpp>

#include "components/goalnet/training/planner_feeding.h"

namespace goalnet::inference::training {
namespace {

constexpr std::array<std::pair<const char*, double TrainOptions::*>, 6> kNumbers = {
    {{"learning_rate", &TrainOptions::learning_rate},
     {"weight_decay", &TrainOptions::weight_decay},
     {"dropout", &TrainOptions::dropout},
     {"without_grounding", &TrainOptions::without_grounding},
     {"state_feeding", &TrainOptions::state_feeding},
     {"replacement", &TrainOptions::replacement}}};
constexpr std::array<std::pair<const char*, int TrainOptions::*>, 3> kCounts = {
    {{"epochs", &TrainOptions::epochs},
     {"batch", &TrainOptions::batch},
     {"feeding_from", &TrainOptions::feeding_from}}};
constexpr std::array<std::pair<const char*, bool TrainOptions::*>, 2> kSwitches = {
    {{"compress", &TrainOptions::compress}, {"perturbed", &TrainOptions::perturbed}}};

}  // namespace

Expected<void> apply_settings(const std::map<std::string, std::string>& settings, TrainOptions& options) {
  auto config = nlohmann::json::parse(network::to_json(options.config));
  for (const auto& [name, text] : settings) {
    const auto refuse = [&, &key = name, &shown = text] {
      return fail(Outcome::kInvalidRequest,
                  "the setting " + key + "=" + shown + " is unknown or has no such value");
    };
    auto value = nlohmann::json::parse(text, nullptr, false);
    if (value.is_discarded()) value = text;
    bool known = false;
    for (const auto& [key, member] : kNumbers) {
      if (name != key) continue;
      if (!value.is_number() || value.get<double>() < 0 || value.get<double>() > 1) return refuse();
      options.*member = value.get<double>();
      known = true;
    }
    for (const auto& [key, member] : kCounts) {
      if (name != key) continue;
      if (!value.is_number_integer() || value.get<long long>() < 1 || value.get<long long>() > 100000)
        return refuse();
      options.*member = value.get<int>();
      known = true;
    }
    for (const auto& [key, member] : kSwitches) {
      if (name != key) continue;
      if (!value.is_boolean()) return refuse();
      options.*member = value.get<bool>();
      known = true;
    }
    if (name == "simulator") {
      if (text != "symsim" && text != "planner") return refuse();
      options.with_planner = text == "planner";
      known = true;
    }
    if (known) continue;
    if (!config.contains(name)) return refuse();
    config[name] = value;
  }
  auto parsed = network::parse_network_config(config.dump());
  if (!parsed) return tl::unexpected(parsed.error());
  options.config = *parsed;
  return {};
}

}  // namespace goalnet::inference::training
