#include "components/goalnet/network/network_config.h"

#include <array>
#include <utility>

#include <nlohmann/json.hpp>

namespace goalnet::inference::network {
namespace {

using Json = nlohmann::json;

constexpr std::array<std::pair<const char*, int NetworkConfig::*>, 7> kSizes = {
    {{"word", &NetworkConfig::word},
     {"sentence", &NetworkConfig::sentence},
     {"object", &NetworkConfig::object},
     {"history", &NetworkConfig::history},
     {"decoder", &NetworkConfig::decoder},
     {"external", &NetworkConfig::external},
     {"max_predicates", &NetworkConfig::max_predicates}}};

constexpr std::array<std::pair<const char*, bool NetworkConfig::*>, 7> kParts = {
    {{"relations", &NetworkConfig::relations},
     {"instance_grounding", &NetworkConfig::instance_grounding},
     {"instruction_attention", &NetworkConfig::instruction_attention},
     {"goal_object_attention", &NetworkConfig::goal_object_attention},
     {"positive", &NetworkConfig::positive},
     {"negative", &NetworkConfig::negative},
     {"grammar_mask", &NetworkConfig::grammar_mask}}};

constexpr std::array<const char*, 4> kTemporal = {"none", "positive", "both", "state"};
constexpr std::array<const char*, 3> kEncodings = {"recurrent", "word_mean", "external"};

template <std::size_t n>
int position(const std::array<const char*, n>& names, const Json& value) {
  for (std::size_t i = 0; i < n; ++i) {
    if (value == names[i]) return static_cast<int>(i);
  }
  return -1;
}

}  // namespace

std::string to_json(const NetworkConfig& config) {
  Json json;
  for (const auto& [name, member] : kSizes) json[name] = config.*member;
  for (const auto& [name, member] : kParts) json[name] = config.*member;
  json["temporal"] = kTemporal[static_cast<std::size_t>(config.temporal)];
  json["encoding"] = kEncodings[static_cast<std::size_t>(config.encoding)];
  return json.dump();
}

Expected<NetworkConfig> parse_network_config(const std::string& text) {
  const auto refuse = [](const std::string& why) {
    return fail(Outcome::kInvalidRequest, "the network's configuration " + why);
  };
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) return refuse("is no JSON object");
  NetworkConfig config;
  for (const auto& [key, value] : json.items()) {
    bool known = false;
    for (const auto& [name, member] : kSizes) {
      if (key != name) continue;
      known = true;
      const bool whole = value.is_number_integer();
      const long long size = whole ? value.get<long long>() : -1;
      if (!whole || size > 1024 || size < (key == "external" ? 0 : 1))
        return refuse("has no usable size \"" + key + "\"");
      config.*member = static_cast<int>(size);
    }
    for (const auto& [name, member] : kParts) {
      if (key != name) continue;
      known = true;
      if (!value.is_boolean()) return refuse("has no true or false as \"" + key + "\"");
      config.*member = value.get<bool>();
    }
    if (key == "temporal" || key == "encoding") {
      known = true;
      const int place = key == "temporal" ? position(kTemporal, value) : position(kEncodings, value);
      if (place < 0) return refuse("has the unknown " + key + " " + value.dump().substr(0, 40));
      if (key == "temporal") config.temporal = static_cast<TemporalContext>(place);
      if (key == "encoding") config.encoding = static_cast<SentenceEncoding>(place);
    }
    if (!known) return refuse("has the unknown key \"" + key.substr(0, 40) + "\"");
  }
  if (config.encoding == SentenceEncoding::kExternal && config.external == 0)
    return refuse("names no external size");
  return config;
}

}  // namespace goalnet::inference::network
