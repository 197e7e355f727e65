// One DDS participant, shared by the nodes of a process.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "components/core/outcome.h"

namespace goalnet::ros {

namespace detail {
class Participant;
}

// Whose conventions on the wire are followed where ROS 2 distributions differ.
enum class Distro { kHumble, kJazzy };

// "humble" or "jazzy"; kInvalidRequest for anything else.
Expected<Distro> parse_distro(std::string_view name);
std::string_view to_string(Distro distro);

// What is not given here comes from the environment: ROS_DOMAIN_ID, GOALNET_ROS_DISTRO, ROS_DISTRO,
// ROS_LOCALHOST_ONLY, ROS_AUTOMATIC_DISCOVERY_RANGE, ROS_STATIC_PEERS, ROS_DISCOVERY_SERVER,
// GOALNET_SHARED_MEMORY.
struct ContextOptions {
  int domain_id = -1;         // 0..232; -1: ROS_DOMAIN_ID, or 0
  std::string enclave = "/";  // where SROS2 looks for keys; also the participant's name
  std::optional<Distro> distro =
      std::nullopt;  // empty: GOALNET_ROS_DISTRO; Humble if ROS_DISTRO says so; Jazzy
  // Only talk inside this process: for tests and for a closed loop that nobody is to disturb.
  bool process_only = false;
};

// May serve several nodes. Endpoints keep what they need of it alive; destroy nodes first all the same.
class Context {
 public:
  // Fails with kInvalidRequest for bad options or environment, kInternal where DDS refuses.
  static Expected<std::unique_ptr<Context>> create(const ContextOptions& options = {});
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  int domain_id() const;
  Distro distro() const;
  const std::string& enclave() const;
  // Full names of the nodes that other participants of the domain have now, sorted.
  std::vector<std::string> other_nodes() const;

  const std::shared_ptr<detail::Participant>& participant() const {
    return participant_;
  }  // for components/ros only

 private:
  explicit Context(std::shared_ptr<detail::Participant> participant);
  std::shared_ptr<detail::Participant> participant_;
};

}  // namespace goalnet::ros
