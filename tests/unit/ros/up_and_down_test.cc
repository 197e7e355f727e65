// A thousand times up and down: context, node, topics, service and action, each round used once and
// destroyed. GOALNET_UP_AND_DOWN_ROUNDS sets another number of rounds.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "components/ros/action_client.h"
#include "components/ros/action_server.h"
#include "components/ros/service.h"
#include "example_interfaces/action/Fibonacci_action.h"
#include "std_msgs/msg/String.h"
#include "std_srvs/srv/Trigger_service.h"
#include "tests/support/process.h"
#include "tests/unit/ros/support.h"

namespace goalnet::ros {
namespace {

using namespace std::chrono_literals;
using example_interfaces::action::Fibonacci;
using std_srvs::srv::Trigger;

constexpr int kWarmUp = 20;  // pools of Fast DDS and of the allocator fill at first

struct Holdings {
  std::size_t files = 0, threads = 0;
  double resident_mib = 0;
};

std::size_t entries(const char* folder) {
  return static_cast<std::size_t>(
      std::distance(std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator()));
}

Holdings now() {
  Holdings held{entries("/proc/self/fd"), entries("/proc/self/task"), 0};
  std::ifstream status("/proc/self/statm");
  std::size_t total = 0, resident = 0;
  status >> total >> resident;
  held.resident_mib = static_cast<double>(resident) * 4096 / (1 << 20);
  return held;
}

void one_round(int domain) {
  auto context = make_context(domain);
  EventLoop loop;
  Node node(*context, loop, plain("robot"));
  int heard = 0;
  auto out = node.advertise<std_msgs::msg::String>("/chatter");
  auto in = node.subscribe<std_msgs::msg::String>("/chatter", Qos::standard(), [&](const auto&) { ++heard; });
  Server<Trigger> server(node, "/do_it", [](const auto&, auto& response) { response.success(true); });
  Client<Trigger> client(node, "/do_it");
  ActionServer<Fibonacci> action(
      node, "/fib",
      {.on_goal = [](const GoalId&, const auto&) { return GoalResponse::kExecute; },
       .on_accepted = [](auto goal) { goal->succeed({}); },
       .on_cancel = {}});
  ActionClient<Fibonacci> asker(node, "/fib");
  out->publish({});
  bool done = false;
  asker.send({}, {.on_response = {}, .on_feedback = {}, .on_result = [&](auto result) {
                    done = result.has_value();
                  }});
  ASSERT_TRUE(client.call_and_run({}, 5s)->success());
  ASSERT_TRUE(loop.run_for(5s, [&] { return done && heard == 1; }));
}

// The transport that is off by default has files in /dev/shm: they must go with their participant.
TEST(UpAndDown, SharedMemoryLeavesNoFile) {
  setenv("GOALNET_SHARED_MEMORY", "1", 1);
  const int domain = own_domain();
  {
    auto context = make_context(domain);
    EXPECT_GT(testing_support::shared_memory_of_domain(domain).size(), 0u);
  }
  for (int i = 0; i < 10 && !HasFatalFailure(); ++i) one_round(domain);
  unsetenv("GOALNET_SHARED_MEMORY");
  EXPECT_EQ(testing_support::shared_memory_of(getpid()).size(), 0u);
  EXPECT_EQ(testing_support::shared_memory_of_domain(domain).size(), 0u);
}

TEST(UpAndDown, LeavesNothingBehind) {
  const char* text = std::getenv("GOALNET_UP_AND_DOWN_ROUNDS");
  const int rounds = text == nullptr ? 1000 : std::atoi(text);
  const int domain = own_domain();
  for (int i = 0; i < kWarmUp; ++i) one_round(domain);
  const Holdings before = now();
  for (int i = 0; i < rounds && !HasFatalFailure(); ++i) one_round(domain);
  const Holdings after = now();
  EXPECT_EQ(after.files, before.files);
  EXPECT_EQ(after.threads, before.threads);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  // A leak of 20 KiB a round would show. (The sanitizers keep what was freed, and look for leaks themselves.)
  EXPECT_LT(after.resident_mib, before.resident_mib + 4 + rounds * 20.0 / 1024)
      << "from " << before.resident_mib << " MiB";
#endif
  EXPECT_EQ(testing_support::shared_memory_of(getpid()).size(), 0u);
  EXPECT_EQ(testing_support::shared_memory_of_domain(domain).size(), 0u);
  RecordProperty("rounds", rounds);
  std::printf("%d rounds: %zu -> %zu open files, %zu -> %zu threads, %.1f -> %.1f MiB\n", rounds,
              before.files, after.files, before.threads, after.threads, before.resident_mib,
              after.resident_mib);
}

}  // namespace
}  // namespace goalnet::ros
