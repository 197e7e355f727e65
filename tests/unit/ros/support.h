// What the tests of components/ros share.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include "components/ros/node.h"
#include "tests/support/domain.h"

namespace goalnet::ros {

using testing_support::own_domain;

// Cyclone DDS with a port for discovery and another for data, as it has on interfaces without multicast: what
// provokes an abort of Fast DDS 2.9 (tests/interoperability/abort_test.cc).
inline constexpr const char* kCycloneWithSeparatePorts =
    "<CycloneDDS><Domain><Discovery><ParticipantIndex>auto</ParticipantIndex>"
    "<MaxAutoParticipantIndex>60</MaxAutoParticipantIndex></Discovery></Domain></CycloneDDS>";

// A node that logs to /rosout only.
inline NodeOptions plain(std::string name) {
  NodeOptions options;
  options.name = std::move(name);
  options.arguments.console = false;
  return options;
}

inline std::unique_ptr<Context> make_context(int domain, Distro distro = Distro::kJazzy) {
  auto context = Context::create({.domain_id = domain, .distro = distro});
  if (!context) throw std::runtime_error(context.error().message);
  return std::move(*context);
}

}  // namespace goalnet::ros
