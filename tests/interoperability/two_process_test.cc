// Services and actions between two processes: nothing lost, nothing doubled, nothing stuck; also while the
// other process is killed and started again.
#include <gtest/gtest.h>
#include <signal.h>

#include <random>

#include "components/ros/action_client.h"
#include "components/ros/service.h"
#include "example_interfaces/action/Fibonacci_action.h"
#include "example_interfaces/srv/AddTwoInts_service.h"
#include "tests/support/process.h"
#include "tests/unit/ros/support.h"

namespace goalnet::ros {
namespace {

using namespace std::chrono_literals;
using example_interfaces::action::Fibonacci;
using example_interfaces::srv::AddTwoInts;
using testing_support::Process;

const int kDomain = test_domain(128);

std::unique_ptr<Process> start_peer() {
  const std::map<std::string, std::string> none;
  return std::make_unique<Process>(
      std::vector<std::string>{testing_support::program("ros_peer"), std::to_string(kDomain)}, none);
}

struct TwoProcesses : testing::Test {
  std::unique_ptr<Context> context = make_context(kDomain);
  EventLoop loop;
  Node node{*context, loop, plain("client")};
  Client<AddTwoInts> add{node, "/add"};
  ActionClient<Fibonacci> fib{node, "/fib"};
  std::mt19937 random{5};

  static Fibonacci::Goal order(int n) {
    Fibonacci::Goal goal;
    goal.order(n);
    return goal;
  }
};

TEST_F(TwoProcesses, AThousandCallsAndTwoHundredGoals) {
  auto peer = start_peer();
  ASSERT_TRUE(add.wait_for_service(5s));
  ASSERT_TRUE(fib.wait_for_server(5s));
  int answered = 0;
  int wrong = 0;
  for (int i = 0; i < 1000; ++i) {
    AddTwoInts::Request request;
    request.a(i);
    request.b(1);
    add.call(request, [&, i](Expected<std::shared_ptr<AddTwoInts::Response>> response) {
      ++answered;
      if (!response || (*response)->sum() != i + 1) ++wrong;
    });
    if (i % 10 == 0) loop.run_pending();
  }
  EXPECT_TRUE(loop.run_for(10s, [&] { return answered == 1000; })) << answered;
  std::map<GoalState, int> ends;
  int results = 0;
  for (int i = 0; i < 200; ++i) {
    const GoalId id = fib.send(order(1 + static_cast<int>(random() % 20)),
                               {.on_response = {}, .on_feedback = {}, .on_result = [&](auto result) {
                                  ++results;
                                  if (result) ++ends[result->first];
                                }});
    loop.run_for(std::chrono::microseconds(random() % 3000));
    if (random() % 2 == 0) fib.cancel(id);
  }
  EXPECT_TRUE(loop.run_for(10s, [&] { return results == 200; })) << results;
  loop.run_for(100ms);
  EXPECT_EQ(answered, 1000) << "no answer twice";
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(results, 200) << "no result twice";
  EXPECT_EQ(ends[GoalState::kSucceeded] + ends[GoalState::kCanceled], 200);
}

TEST_F(TwoProcesses, KilledAndRestartedTenTimes) {
  int sent = 0;
  int ended = 0;
  int good = 0;
  for (int round = 0; round < 10; ++round) {
    auto peer = start_peer();
    // The endpoints of killed predecessors stay until their lease ends: ask until the new one answers.
    bool up = false;
    for (int tries = 0; tries < 100 && !up; ++tries) up = add.call_and_run({}, 100ms).has_value();
    ASSERT_TRUE(up) << "round " << round;
    for (int i = 0; i < 50; ++i) {
      ++sent;
      AddTwoInts::Request request;
      request.a(i);
      add.call(
          request,
          [&, i](Expected<std::shared_ptr<AddTwoInts::Response>> response) {
            ++ended;
            if (response) good += (*response)->sum() == i;
          },
          1s);
      if (i % 5 == 0) {
        ++sent;
        fib.send(order(3), {.on_response = {}, .on_feedback = {}, .on_result = [&](auto) { ++ended; }}, 1s,
                 1s);
      }
      loop.run_for(std::chrono::microseconds(random() % 1500));
      if (i == 40) peer->signal(SIGKILL);
    }
  }
  loop.run_for(3s, [&] { return ended >= sent; });
  loop.run_for(200ms);
  // Every call ends exactly once: with an answer, or with a time limit where the peer was killed.
  EXPECT_GE(ended, sent - 100) << "goals whose request was refused end without a result";
  EXPECT_LE(ended, sent);
  EXPECT_GE(good, 10 * 35);
}

}  // namespace
}  // namespace goalnet::ros
