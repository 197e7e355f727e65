#include <cstdlib>

#include "components/ros/detail/participant.h"

namespace goalnet::ros {

Expected<Distro> parse_distro(std::string_view name) {
  if (name == "humble") return Distro::kHumble;
  if (name == "jazzy") return Distro::kJazzy;
  return fail(Outcome::kInvalidRequest,
              "unknown ROS distribution '" + std::string(name) + "'; known: humble, jazzy");
}

std::string_view to_string(Distro distro) { return distro == Distro::kHumble ? "humble" : "jazzy"; }

namespace detail {
namespace {

constexpr int kHighestDomain = 232;  // above it the UDP ports of RTPS run out

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

Expected<int> parse_domain(const std::string& text) {
  char* end = nullptr;
  const long value = std::strtol(text.c_str(), &end, 10);
  if (text.empty() || *end != '\0' || value < 0 || value > kHighestDomain) {
    return fail(Outcome::kInvalidRequest,
                "ROS_DOMAIN_ID is '" + text + "'; it must be a number from 0 to 232");
  }
  return static_cast<int>(value);
}

Expected<ParticipantSettings::Range> parse_range(const std::string& text) {
  if (text == "OFF") return ParticipantSettings::Range::kOff;
  if (text == "LOCALHOST") return ParticipantSettings::Range::kLocalhost;
  if (text == "SUBNET" || text.empty()) return ParticipantSettings::Range::kSubnet;
  if (text == "SYSTEM_DEFAULT") return ParticipantSettings::Range::kSystemDefault;
  return fail(Outcome::kInvalidRequest, "ROS_AUTOMATIC_DISCOVERY_RANGE is '" + text +
                                            "'; it must be OFF, LOCALHOST, SUBNET or SYSTEM_DEFAULT");
}

}  // namespace

Expected<ParticipantSettings> read_settings(const ContextOptions& options) {
  ParticipantSettings settings;
  settings.enclave = options.enclave;
  settings.process_only = options.process_only;
  settings.domain_id = options.domain_id;
  if (options.domain_id > kHighestDomain) {
    return fail(Outcome::kInvalidRequest, "domain id " + std::to_string(options.domain_id) + " is above 232");
  }
  if (options.domain_id < 0) {
    const std::string text = environment("ROS_DOMAIN_ID");
    auto domain = text.empty() ? Expected<int>(0) : parse_domain(text);
    if (!domain) return tl::unexpected(domain.error());
    settings.domain_id = *domain;
  }
  if (options.distro) {
    settings.distro = *options.distro;
  } else if (const std::string name = environment("GOALNET_ROS_DISTRO"); !name.empty()) {
    auto distro = parse_distro(name);
    if (!distro) return fail(Outcome::kInvalidRequest, "GOALNET_ROS_DISTRO: " + distro.error().message);
    settings.distro = *distro;
  } else if (environment("ROS_DISTRO") == "humble") {
    // What a shell with ROS 2 in it says; the layout changed after Humble.
    settings.distro = Distro::kHumble;
  }
  auto range = parse_range(environment("ROS_AUTOMATIC_DISCOVERY_RANGE"));
  if (!range) return tl::unexpected(range.error());
  settings.range = *range;
  // The older variable wins where it is set.
  const std::string localhost_only = environment("ROS_LOCALHOST_ONLY");
  if (localhost_only == "1") {
    // Humble's participants announce addresses of the loopback interface only and take no other's.
    settings.range = settings.distro == Distro::kHumble ? ParticipantSettings::Range::kLoopback
                                                        : ParticipantSettings::Range::kLocalhost;
  } else if (!localhost_only.empty() && localhost_only != "0") {
    return fail(Outcome::kInvalidRequest,
                "ROS_LOCALHOST_ONLY is '" + localhost_only + "'; it must be 0 or 1");
  }
  // Whoever asks for encryption must not get a robot that anybody may order about.
  if (environment("ROS_SECURITY_ENABLE") == "true" && environment("ROS_SECURITY_STRATEGY") == "Enforce") {
    return fail(
        Outcome::kInvalidRequest,
        "ROS_SECURITY_ENABLE is true and ROS_SECURITY_STRATEGY is Enforce, but this program cannot encrypt; "
        "unset them, or keep it on a network of its own");
  }
  settings.shared_memory = environment("GOALNET_SHARED_MEMORY") == "1";
  settings.static_peers = environment("ROS_STATIC_PEERS");
  settings.discovery_server = environment("ROS_DISCOVERY_SERVER");
  return settings;
}

}  // namespace detail
}  // namespace goalnet::ros
