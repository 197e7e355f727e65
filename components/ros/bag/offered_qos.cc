#include "components/ros/bag/offered_qos.h"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>

namespace goalnet::ros {
namespace {

constexpr std::uint64_t kForeverSeconds = 9'223'372'036, kForeverNanoseconds = 854'775'807;

// rmw's numbers and words of one policy, in the order of the numbers.
using Words = std::array<const char*, 5>;
constexpr Words kHistory = {"system_default", "keep_last", "keep_all", "unknown", ""};
constexpr Words kReliability = {"system_default", "reliable", "best_effort", "unknown", "best_available"};
constexpr Words kDurability = {"system_default", "transient_local", "volatile", "unknown", "best_available"};
constexpr Words kLiveliness = {"system_default", "automatic", "manual_by_node", "manual_by_topic", "unknown"};

std::string policy(const Words& words, std::size_t number, Distro distro) {
  return distro == Distro::kJazzy ? words.at(number) : std::to_string(number);
}

std::size_t number_of(const Words& words, const YAML::Node& node) {
  const auto text = node.as<std::string>();
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (text == words[i] || text == std::to_string(i)) return i;
  }
  throw YAML::Exception(node.Mark(), "\"" + text.substr(0, 40) + "\" is no QoS policy");
}

std::string span_yaml(std::chrono::nanoseconds span) {
  const bool forever = span.count() <= 0;
  return fmt::format("    sec: {}\n    nsec: {}\n", forever ? kForeverSeconds : span.count() / 1'000'000'000,
                     forever ? kForeverNanoseconds : span.count() % 1'000'000'000);
}

// Infinite where it is too long to count; older distributions wrote other numbers for that.
std::chrono::nanoseconds span_of(const YAML::Node& node) {
  const auto seconds = node["sec"].as<std::uint64_t>(), nanoseconds = node["nsec"].as<std::uint64_t>();
  if (seconds >= 0x7fff'ffff || nanoseconds > 4'294'967'295) return std::chrono::nanoseconds(0);
  return std::chrono::seconds(seconds) + std::chrono::nanoseconds(nanoseconds);
}

OfferedQos profile_of(const YAML::Node& node) {
  OfferedQos out;
  const std::size_t history = number_of(kHistory, node["history"]);
  out.history_known = history == 1 || history == 2;
  out.qos.keep_all = history == 2;
  out.qos.depth =
      static_cast<std::uint32_t>(std::min<std::uint64_t>(node["depth"].as<std::uint64_t>(), 1'000'000));
  out.qos.reliable = number_of(kReliability, node["reliability"]) != 2;
  out.qos.transient_local = number_of(kDurability, node["durability"]) == 1;
  out.qos.deadline = span_of(node["deadline"]);
  out.qos.lifespan = span_of(node["lifespan"]);
  out.liveliness = static_cast<std::uint8_t>(number_of(kLiveliness, node["liveliness"]));
  out.liveliness_lease = span_of(node["liveliness_lease_duration"]);
  return out;
}

}  // namespace

std::string offered_qos_yaml(std::span<const OfferedQos> offered, Distro distro) {
  if (offered.empty()) return "[]";
  std::string out;
  for (const OfferedQos& one : offered) {
    const std::size_t history = !one.history_known ? 3 : one.qos.keep_all ? 2 : 1;
    out += fmt::format("- history: {}\n  depth: {}\n  reliability: {}\n  durability: {}\n",
                       policy(kHistory, history, distro), one.history_known ? one.qos.depth : 0,
                       policy(kReliability, one.qos.reliable ? 1 : 2, distro),
                       policy(kDurability, one.qos.transient_local ? 1 : 2, distro));
    out += "  deadline:\n" + span_yaml(one.qos.deadline) + "  lifespan:\n" + span_yaml(one.qos.lifespan);
    out += "  liveliness: " + policy(kLiveliness, std::min<std::size_t>(one.liveliness, 4), distro) + "\n";
    out += "  liveliness_lease_duration:\n" + span_yaml(one.liveliness_lease);
    out += "  avoid_ros_namespace_conventions: false\n";
  }
  out.pop_back();
  return out;
}

Expected<std::vector<OfferedQos>> parse_offered_qos(const std::string& yaml) {
  if (yaml.empty()) return std::vector<OfferedQos>();
  try {
    const YAML::Node list = YAML::Load(yaml);
    if (!list.IsSequence()) return fail(Outcome::kInvalidRequest, "offered_qos_profiles is no list");
    std::vector<OfferedQos> out;
    for (const YAML::Node& node : list) out.push_back(profile_of(node));
    return out;
  } catch (const YAML::Exception& error) {
    return fail(Outcome::kInvalidRequest, std::string("offered_qos_profiles: ") + error.what());
  }
}

Qos request_for(std::span<const OfferedQos> offered) {
  Qos qos = Qos::standard();
  qos.reliable =
      std::all_of(offered.begin(), offered.end(), [](const auto& one) { return one.qos.reliable; });
  qos.transient_local = !offered.empty() && std::all_of(offered.begin(), offered.end(), [](const auto& one) {
    return one.qos.transient_local;
  });
  return qos;
}

Qos offer_in_place_of(std::span<const OfferedQos> offered) {
  Qos qos = Qos::standard();
  if (offered.empty()) return qos;
  const OfferedQos& first = offered.front();
  const bool agreed = std::all_of(offered.begin(), offered.end(), [&](const OfferedQos& one) {
    return one.qos.reliable == first.qos.reliable && one.qos.transient_local == first.qos.transient_local &&
           one.qos.deadline == first.qos.deadline;
  });
  if (!agreed) return qos;
  qos.reliable = first.qos.reliable;
  qos.transient_local = first.qos.transient_local;
  qos.deadline = first.qos.deadline;
  qos.lifespan = first.qos.lifespan;
  std::uint32_t deepest = 0;
  for (const OfferedQos& one : offered) {
    if (!one.history_known) continue;
    deepest = std::max(deepest, one.qos.depth);
    qos.keep_all = qos.keep_all || one.qos.keep_all;
  }
  if (deepest > 0) qos.depth = deepest;
  return qos;
}

}  // namespace goalnet::ros
