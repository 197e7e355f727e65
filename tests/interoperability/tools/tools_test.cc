// Short-lived tools with the configuration of rmw_fastrtps against a node of ours: whatever they do in the
// moment in which both sides find each other must not be lost, and starting must not take seconds now and
// then.
#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "components/ros/service.h"
#include "example_interfaces/srv/AddTwoInts_service.h"
#include "std_msgs/msg/String.h"
#include "tests/support/process.h"
#include "tests/unit/ros/support.h"

namespace goalnet::ros {
namespace {

using namespace std::chrono_literals;
using example_interfaces::srv::AddTwoInts;
using std_msgs::msg::String;
using testing_support::Process;

const int kDomain = own_domain();
constexpr int kRuns = 10;

// Runs one tool to its end while the loop works. Its exit code, output and time to the first result.
testing_support::ProcessResult run_tool(EventLoop& loop, std::vector<std::string> words) {
  words.insert(words.begin(), testing_support::program("rmw_tool"));
  words.insert(words.begin() + 2, std::to_string(kDomain));
  Process tool(words, {});
  std::optional<testing_support::ProcessResult> result;
  std::thread waiting([&] { result = tool.wait(15s); });
  loop.run_for(20s, [&] { return tool.out().find('\n') != std::string::npos; });
  loop.run_for(50ms);
  waiting.join();
  return *result;
}

struct Tools : testing::Test {
  testing_support::ProcessResult run(const std::vector<std::string>& words) { return run_tool(loop, words); }
  static double milliseconds(const testing_support::ProcessResult& result) {
    return std::atof(result.out.substr(std::string("FIRST ").size()).c_str());
  }

  std::unique_ptr<Context> context = make_context(kDomain);
  EventLoop loop;
  Node node{*context, loop, plain("robot")};
  std::vector<double> times;
  ~Tools() override {
    std::sort(times.begin(), times.end());
    if (!times.empty())
      std::printf("start to result: median %.0f ms, longest %.0f ms\n", times[times.size() / 2],
                  times.back());
  }
};

TEST_F(Tools, PublishOnceIsNeverLost) {
  std::multiset<std::string> seen;
  auto in = node.subscribe<String>("/instruction", Qos::standard(),
                                   [&](const String& m) { seen.insert(m.data()); });
  for (int i = 0; i < kRuns; ++i) {
    const auto result = run({"pub", "/instruction", "order " + std::to_string(i)});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    times.push_back(milliseconds(result));
    loop.run_for(2s, [&] { return seen.size() > static_cast<std::size_t>(i); });
    ASSERT_EQ(seen.count("order " + std::to_string(i)), 1u) << "run " << i;
  }
}

TEST_F(Tools, ServiceCallsAreAnswered) {
  Server<AddTwoInts> server(
      node, "/add", [](const auto& request, auto& response) { response.sum(request.a() + request.b()); });
  for (int i = 0; i < kRuns; ++i) {
    const auto result = run({"call", "/add", std::to_string(i), "100"});
    ASSERT_EQ(result.exit_code, 0) << "run " << i << " " << result.err;
    EXPECT_THAT(result.out, testing::HasSubstr("\n" + std::to_string(100 + i) + "\n"));
    times.push_back(milliseconds(result));
  }
}

TEST_F(Tools, LatchedMessagesReachALateEcho) {
  auto out = node.advertise<String>("/robot_description", Qos::latched());
  String message;
  message.data("<robot/>");
  out->publish(message);
  for (int i = 0; i < kRuns; ++i) {
    const auto result = run({"echo", "/robot_description"});
    ASSERT_EQ(result.exit_code, 0) << "run " << i;
    EXPECT_THAT(result.out, testing::HasSubstr("\n<robot/>\n"));
    times.push_back(milliseconds(result));
  }
}

// More than a datagram, and more than a socket keeps: fragments are lost and asked for again.
TEST_F(Tools, LargeLatchedMessagesReachALateEcho) {
  auto out = node.advertise<String>("/robot_description", Qos::latched());
  String message;
  for (int i = 0; i < 300'000; ++i) message.data().push_back(static_cast<char>('a' + i % 26));
  out->publish(message);
  for (int i = 0; i < kRuns; ++i) {
    const auto result = run({"echo", "/robot_description"});
    ASSERT_EQ(result.exit_code, 0) << "run " << i;
    EXPECT_NE(result.out.find("\n" + message.data() + "\n"), std::string::npos);
    times.push_back(milliseconds(result));
  }
}

TEST_F(Tools, NodeListFindsUs) {
  for (int i = 0; i < kRuns; ++i) {
    const auto result = run({"nodes", "5", "/robot"});
    ASSERT_EQ(result.exit_code, 0) << "run " << i;
    times.push_back(milliseconds(result));
  }
}

// A shell in which both a robot and its tools are told to stay on this host, each distribution's way.
TEST(OneHost, ToolsFindUs) {
  const std::tuple<const char*, const char*, Distro> kinds[] = {
      {"ROS_LOCALHOST_ONLY", "1", Distro::kHumble},
      {"ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST", Distro::kJazzy}};
  for (const auto& [variable, value, distro] : kinds) {
    setenv(variable, value, 1);
    auto context = make_context(kDomain, distro);
    EventLoop loop;
    Node node(*context, loop, plain("robot"));
    Server<AddTwoInts> server(
        node, "/add", [](const auto& request, auto& response) { response.sum(request.a() + request.b()); });
    for (int i = 0; i < 3; ++i) {
      const auto result = run_tool(loop, {"call", "/add", std::to_string(i), "100"});
      EXPECT_EQ(result.exit_code, 0) << variable << " run " << i << " " << result.err;
      EXPECT_THAT(result.out, testing::HasSubstr("\n" + std::to_string(100 + i) + "\n"));
    }
    unsetenv(variable);
  }
}

}  // namespace
}  // namespace goalnet::ros
