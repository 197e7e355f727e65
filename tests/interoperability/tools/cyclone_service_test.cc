// Services with Cyclone DDS on the other side, in the format of rmw_cyclonedds.
#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <thread>

#include "components/ros/service.h"
#include "example_interfaces/srv/AddTwoInts_service.h"
#include "tests/support/process.h"
#include "tests/support/slowdown.h"
#include "tests/unit/ros/support.h"

namespace goalnet::ros {
namespace {

using namespace std::chrono_literals;
using example_interfaces::srv::AddTwoInts;
using testing_support::Process;

const int kDomain = own_domain();

std::unique_ptr<Process> cyclone(const std::string& mode, const std::string& argument) {
  return std::make_unique<Process>(std::vector<std::string>{testing_support::program("cyclone_services"),
                                                            mode, std::to_string(kDomain), argument},
                                   std::map<std::string, std::string>{});
}

AddTwoInts::Request sum_of(int a, int b) {
  AddTwoInts::Request request;
  request.a(a);
  request.b(b);
  return request;
}

std::string sums(int count) {
  std::string text;
  for (int i = 1; i <= count; ++i) text += "sum " + std::to_string(1000 + i) + "\n";
  return text;
}

struct CycloneService : testing::Test {
  std::unique_ptr<Context> context = make_context(kDomain);
  EventLoop loop;
  Node node{*context, loop, plain("robot")};

  // Runs the loop until the process has printed all of `expected`, or a minute.
  void expect_output(const Process& process, const std::string& expected) {
    loop.run_for(60s, [&] { return process.out().size() >= expected.size(); });
    EXPECT_EQ(process.out(), expected) << process.err();
  }
};

// A tool asks as soon as it has found the service, when we may not have found its reply reader yet.
TEST_F(CycloneService, EveryShortLivedToolGetsItsAnswer) {
  int calls = 0;
  Server<AddTwoInts> server(node, "/add", [&](const auto& request, auto& response) {
    ++calls;
    response.sum(request.a() + request.b());
  });
  testing_support::Slowdown slowdown;
  std::vector<int> times;  // [ms] from a tool's start until it sees the service
  for (int i = 0; i < 15; ++i) {
    const auto tool = cyclone("call", "1");
    expect_output(*tool, sums(1));
    const std::string err = tool->err();
    ASSERT_EQ(err.find("found "), 0u) << err;
    times.push_back(std::stoi(err.substr(6)));
  }
  EXPECT_EQ(calls, 15) << "each executed once";
  // Fast DDS alone is seen after a second; ROS 2's tools look for half a second.
  std::sort(times.begin(), times.end());
  EXPECT_LT(times[times.size() / 2] / slowdown.stop(), 500);
  std::printf("found after %d to %d ms, median %d\n", times.front(), times.back(), times[times.size() / 2]);
}

TEST_F(CycloneService, ClientsOfBothKindsAtOnceGetTheirOwnAnswers) {
  auto elsewhere = make_context(kDomain);
  Node other(*elsewhere, loop, plain("other"));
  Client<AddTwoInts> client(other, "/add");
  Server<AddTwoInts> server(
      node, "/add", [](const auto& request, auto& response) { response.sum(request.a() + request.b()); });
  ASSERT_TRUE(client.wait_for_service(5s));
  int right = 0, wrong = 0;
  std::function<void()> next = [&] {
    const int asked = right;
    client.call(sum_of(asked, 7), [&, asked](auto response) {
      ++(response && (*response)->sum() == asked + 7 ? right : wrong);
      next();
    });
  };
  next();
  const auto tool = cyclone("call", "300");
  expect_output(*tool, sums(300));
  EXPECT_GT(right, 100);
  EXPECT_EQ(wrong, 0);
}

TEST_F(CycloneService, ServersOfRmwCycloneddsAnswerUs) {
  const auto server = cyclone("serve", "20");
  Client<AddTwoInts> client(node, "/add");
  ASSERT_TRUE(client.wait_for_service(5s));
  // It finds us about when we find it; before that it hears nothing.
  ASSERT_TRUE(server->wait_for_text("met a client", 5s));
  for (int i = 0; i < 100; ++i) {
    const auto response = client.call_and_run(sum_of(i, 5), 2s);
    ASSERT_TRUE(response) << i << ": " << response.error().message;
    ASSERT_EQ(response->sum(), i + 5);
  }
}

// What rmw_cyclonedds adds to Cyclone's configuration where everybody is to stay on this host, in Humble and
// in Jazzy. Either way it uses no multicast.
struct OneHost {
  const char *variable, *value, *configuration;
  Distro distro;
};
const OneHost kOneHost[] = {
    {"ROS_LOCALHOST_ONLY", "1",
     "<CycloneDDS><Domain><General><NetworkInterfaceAddress>127.0.0.1</NetworkInterfaceAddress></General>"
     "</Domain></CycloneDDS>",
     Distro::kHumble},
    {"ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST",
     "<CycloneDDS><Domain><General><AllowMulticast>false</AllowMulticast></General><Discovery>"
     "<ParticipantIndex>auto</ParticipantIndex><MaxAutoParticipantIndex>32</MaxAutoParticipantIndex>"
     "<Peers><Peer address=\"localhost\"/></Peers></Discovery></Domain></CycloneDDS>",
     Distro::kJazzy}};

// A daemon that was there first (it announces itself again after seconds only), and tools that come later.
TEST(CycloneOnOneHost, FindsUsAtOnce) {
  for (const OneHost& kind : kOneHost) {
    const std::string domain = std::to_string(kDomain);
    const std::map<std::string, std::string> environment = {{"CYCLONEDDS_URI", kind.configuration}};
    Process daemon(
        {testing_support::program("cyclone_graph"), domain, "20", std::string(to_string(kind.distro))},
        environment);
    ASSERT_TRUE(daemon.wait_for_text("ready", 5s)) << daemon.err();
    std::this_thread::sleep_for(2s);
    ASSERT_EQ(daemon.out().find("\nnode "), std::string::npos) << "somebody else is on this domain";
    setenv(kind.variable, kind.value, 1);
    auto context = make_context(kDomain, kind.distro);
    unsetenv(kind.variable);
    EventLoop loop;
    Node node(*context, loop, plain("robot"));
    Server<AddTwoInts> server(
        node, "/add", [](const auto& request, auto& response) { response.sum(request.a() + request.b()); });
    EXPECT_TRUE(daemon.wait_for_text(" / robot ", 1500ms)) << kind.variable;
    Process tool({testing_support::program("cyclone_services"), "call", domain, "2"}, environment);
    loop.run_for(10s, [&] { return tool.out().size() >= sums(2).size(); });
    EXPECT_EQ(tool.out(), sums(2)) << kind.variable << tool.err();
  }
}

}  // namespace
}  // namespace goalnet::ros
