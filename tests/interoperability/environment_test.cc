// The variables that say who finds whom, each between hosts: network namespaces joined by a cable (veth), as
// root. Every case has a counterpart in which the same two are (not) found, so that no case can pass by
// itself.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <tuple>
#include <vector>

#include "tests/support/process.h"
#include "tests/unit/ros/support.h"

namespace goalnet::ros {
namespace {

using namespace std::chrono_literals;
using testing_support::Process;
using Variables = std::map<std::string, std::string>;

constexpr int kDomain = 7;  // the hosts are nobody else's
constexpr const char* kIp = "/usr/sbin/ip";
constexpr auto kFound = 10s;
constexpr auto kNotFound = 1500ms;  // discovery takes a fraction of it

bool run(const std::string& command) { return std::system((command + " >/dev/null 2>&1").c_str()) == 0; }

struct Hosts : testing::Test {
  const std::string id = std::to_string(getpid() % 10'000);
  const std::string a = "gn" + id + "a", b = "gn" + id + "b", router = "gn" + id + "r";
  std::vector<std::unique_ptr<Process>> processes;

  void SetUp() override {
    if (geteuid() != 0 || access(kIp, X_OK) != 0 || !run(std::string(kIp) + " netns add " + a)) {
      GTEST_SKIP() << "needs root, " << kIp
                   << " (package iproute2) and permission to make network namespaces";
    }
    ip("netns add " + b);
  }
  void TearDown() override {
    processes.clear();
    for (const auto& host : {a, b, router}) run(std::string(kIp) + " netns del " + host);
  }
  static void ip(const std::string& words) {
    ASSERT_TRUE(run(std::string(kIp) + " " + words)) << "ip " << words;
  }
  // A cable between two hosts: the first is 10.77.N.1 on it, the other 10.77.N.2.
  static void cable(const std::string& one, const std::string& other, int network) {
    const std::string left = "v" + std::to_string(network) + "l", right = "v" + std::to_string(network) + "r";
    ip("link add " + left + " netns " + one + " type veth peer name " + right + " netns " + other);
    const std::string net = "10.77." + std::to_string(network) + ".";
    for (const auto& [host, end, address] :
         {std::tuple(one, left, net + "1"), std::tuple(other, right, net + "2")}) {
      ip("-n " + host + " link set lo up");
      ip("-n " + host + " addr add " + address + "/24 dev " + end);
      ip("-n " + host + " link set " + end + " up");
    }
  }
  // Both on one network: 10.77.1.1 and 10.77.1.2.
  void connect() const {
    cable(a, b, 1);
    ip("-n " + a + " route add default dev v1l");
    ip("-n " + b + " route add default dev v1r");
  }
  // Each on a network of its own, 10.77.1.1 and 10.77.2.1: a router forwards between them, but no multicast.
  void connect_through_router() const {
    ip("netns add " + router);
    cable(a, router, 1);
    cable(b, router, 2);
    ip("-n " + a + " route add default via 10.77.1.2");
    ip("-n " + b + " route add default via 10.77.2.2");
    ip("netns exec " + router + " sh -c 'echo 1 > /proc/sys/net/ipv4/ip_forward'");
  }
  Process& start(const std::string& host, const std::vector<std::string>& words, Variables variables = {}) {
    variables.emplace("ROS_DOMAIN_ID", "");
    std::vector<std::string> all = {kIp, "netns", "exec", host, testing_support::program("ros_peer")};
    all.insert(all.end(), words.begin(), words.end());
    processes.push_back(std::make_unique<Process>(all, variables));
    return *processes.back();
  }
  Process& node(const std::string& host, const std::string& name, const Variables& variables = {}) {
    return start(host, {"list", std::to_string(kDomain), name}, variables);
  }
  static bool finds(const Process& one, const std::string& other) {
    return one.wait_for_text("/" + other, kFound);
  }
  static bool never_finds(const Process& one, const std::string& other) {
    return !one.wait_for_text("/" + other, kNotFound);
  }
};

TEST_F(Hosts, SubnetIsTheDefault) {
  connect();
  auto& left = node(a, "left");
  auto& right = node(b, "right");
  EXPECT_TRUE(finds(left, "right")) << left.err();
  EXPECT_TRUE(finds(right, "left"));
}

TEST_F(Hosts, LocalhostOnlyStaysOnItsHost) {
  connect();
  for (const auto& [name, value] :
       {std::pair("ROS_LOCALHOST_ONLY", "1"), std::pair("ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST")}) {
    const Variables local = {{name, value}};
    auto& left = node(a, "left", local);
    auto& neighbour = node(a, "neighbour", local);
    auto& right = node(b, "right");
    EXPECT_TRUE(finds(left, "neighbour")) << name << left.err();
    EXPECT_TRUE(finds(neighbour, "left")) << name;
    EXPECT_TRUE(never_finds(left, "right")) << name;
    EXPECT_TRUE(never_finds(right, "left")) << name;
    processes.clear();
  }
}

TEST_F(Hosts, OffFindsNobody) {
  connect();
  const Variables off = {{"ROS_AUTOMATIC_DISCOVERY_RANGE", "OFF"}};
  auto& left = node(a, "left", off);
  auto& neighbour = node(a, "neighbour", off);
  auto& right = node(b, "right");
  EXPECT_TRUE(never_finds(left, "neighbour"));
  EXPECT_TRUE(never_finds(left, "right"));
  EXPECT_TRUE(never_finds(right, "left"));
  EXPECT_TRUE(never_finds(neighbour, "left"));
}

TEST_F(Hosts, StaticPeersAreFoundWithoutMulticast) {
  connect_through_router();
  ASSERT_FALSE(HasFatalFailure());
  {
    auto& left = node(a, "left");
    auto& right = node(b, "right");
    EXPECT_TRUE(never_finds(left, "right")) << "multicast gets through: this test would prove nothing";
    EXPECT_TRUE(never_finds(right, "left"));
    processes.clear();
  }
  for (const char* range : {"SUBNET", "LOCALHOST"}) {
    // Several peers between semicolons, one of them nobody.
    auto& left = node(
        a, "left", {{"ROS_STATIC_PEERS", "10.77.1.9;10.77.2.1"}, {"ROS_AUTOMATIC_DISCOVERY_RANGE", range}});
    auto& right = node(b, "right");
    EXPECT_TRUE(finds(left, "right")) << range << left.err();
    EXPECT_TRUE(finds(right, "left")) << range;
    processes.clear();
  }
}

// Fast DDS's file of profiles, as users of rmw_fastrtps write it; under the name of either distribution.
TEST_F(Hosts, ProfilesOfFastDdsAreObeyed) {
  connect_through_router();
  ASSERT_FALSE(HasFatalFailure());
  const std::string file = testing::TempDir() + id + "_profiles.xml";
  std::ofstream(file) << R"(<?xml version="1.0" encoding="UTF-8"?>
<profiles xmlns="http://www.eprosima.com/XMLSchemas/fastRTPS_Profiles">
  <transport_descriptors><transport_descriptor>
    <transport_id>udp</transport_id><type>UDPv4</type><maxInitialPeersRange>8</maxInitialPeersRange>
  </transport_descriptor></transport_descriptors>
  <participant profile_name="user" is_default_profile="true"><rtps>
    <builtin><initialPeersList><locator><udpv4><address>10.77.2.1</address></udpv4></locator></initialPeersList></builtin>
    <userTransports><transport_id>udp</transport_id></userTransports>
    <useBuiltinTransports>false</useBuiltinTransports>
  </rtps></participant>
</profiles>)";
  for (const char* variable : {"FASTRTPS_DEFAULT_PROFILES_FILE", "FASTDDS_DEFAULT_PROFILES_FILE"}) {
    auto& left = node(a, "left", {{variable, file}});
    auto& right = node(b, "right");
    EXPECT_TRUE(finds(left, "right")) << variable << left.err();
    EXPECT_TRUE(finds(right, "left")) << variable;
    processes.clear();
  }
  std::filesystem::remove(file);
}

TEST_F(Hosts, DiscoveryServerIntroducesItsClients) {
  connect_through_router();
  ASSERT_FALSE(HasFatalFailure());
  auto& server = start(a, {"discovery", std::to_string(kDomain)});
  ASSERT_TRUE(server.wait_for_text("serving", 5s)) << server.err();
  auto& left = node(a, "left", {{"ROS_DISCOVERY_SERVER", "10.77.1.1:11811"}});
  auto& right = node(b, "right", {{"ROS_DISCOVERY_SERVER", "10.77.1.1:11811"}});
  EXPECT_TRUE(finds(left, "right")) << left.err();
  EXPECT_TRUE(finds(right, "left")) << right.err();
}

// A node that is killed cannot say good-bye: it leaves the others' graphs when its lease of 20 s ends, not
// before half of it.
TEST_F(Hosts, AKilledNodeLeavesWithinItsLease) {
  connect();
  auto& left = node(a, "left");
  auto& right = node(b, "right");
  ASSERT_TRUE(finds(left, "right"));
  const auto killed = std::chrono::steady_clock::now();
  right.signal(SIGKILL);
  // Whether it told of an empty graph first depends on who was found sooner.
  ASSERT_TRUE(left.wait_for_text("nodes: /right.\nnodes:.\n", 30s)) << left.out();
  const auto after = std::chrono::steady_clock::now() - killed;
  EXPECT_LT(after, 25s);
  EXPECT_GT(after, 10s) << "it was taken off before its lease ended";
}

}  // namespace
}  // namespace goalnet::ros
