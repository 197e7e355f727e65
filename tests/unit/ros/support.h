// What the tests of components/ros share. Every test program has a DDS domain of its own, so that tests can
// run at the same time.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include "components/ros/node.h"

namespace goalnet::ros {

// Differs between users' parallel runs of the suite as well.
inline int test_domain(int base) { return base + static_cast<int>(getpid() % 4) * 12; }

// The same for whole programs elsewhere, which take four numbers from `first` on: 60 (discovery), 64 (tools
// graph), 68 (tools), 74 (abort), 78 (leases), 97 (hostile), 101 and 105 (up and down), 109 (replay).
inline int program_domain(int first) { return first + static_cast<int>(getpid() % 4); }

inline const int kPubSubDomain = test_domain(120);
inline const int kNodeDomain = test_domain(121);
inline const int kServiceDomain = test_domain(122);
inline const int kActionDomain = test_domain(123);
inline const int kLifecycleDomain = test_domain(124);
inline const int kGraphDomain = test_domain(125);
inline const int kBagDomain = test_domain(126);

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
