// Services and actions between two processes: nothing lost, nothing executed twice, nothing stuck; also while
// the other process is killed and started again. The server notes each request it executes in a file, so that
// the count survives its death.
#include <gtest/gtest.h>
#include <signal.h>

#include <filesystem>
#include <fstream>
#include <random>

#include "components/ros/action_client.h"
#include "components/ros/service.h"
#include "example_interfaces/action/Fibonacci_action.h"
#include "example_interfaces/srv/AddTwoInts_service.h"
#include "tests/interoperability/goal_id_text.h"
#include "tests/support/process.h"
#include "tests/unit/ros/support.h"

namespace goalnet::ros {
namespace {

using namespace std::chrono_literals;
using example_interfaces::action::Fibonacci;
using example_interfaces::srv::AddTwoInts;
using testing_support::Process;

const int kDomain = own_domain();

struct TwoProcesses : testing::Test {
  std::string log =
      (std::filesystem::temp_directory_path() / ("goalnet_peer_" + std::to_string(getpid()))).string();
  std::unique_ptr<Context> context = make_context(kDomain);
  EventLoop loop;
  Node node{*context, loop, plain("client")};
  Client<AddTwoInts> add{node, "/add"};
  ActionClient<Fibonacci> fib{node, "/fib"};
  std::mt19937 random{5};

  void SetUp() override { std::filesystem::remove(log); }
  void TearDown() override { std::filesystem::remove(log); }

  std::unique_ptr<Process> start(const std::string& mode) const {
    const std::map<std::string, std::string> none;
    return std::make_unique<Process>(
        std::vector<std::string>{testing_support::program("ros_peer"), mode, std::to_string(kDomain), log},
        none);
  }
  // How often the server executed each request: "add 17" -> 1.
  std::map<std::string, int> executions() const {
    std::map<std::string, int> counts;
    std::ifstream file(log);
    for (std::string line; std::getline(file, line);) ++counts[line];
    return counts;
  }
  static Fibonacci::Goal order(int n) {
    Fibonacci::Goal goal;
    goal.order(n);
    return goal;
  }

  // What became of everything that was asked.
  struct Call {
    int answers = 0, timeouts = 0, other = 0;
    bool right = false;
  };
  struct Goal {
    int responses = 0, results = 0;
    bool accepted = false;
    std::optional<Outcome> error;
    GoalState end = GoalState::kUnknown;
    bool ended() const { return results > 0 || (responses > 0 && !accepted && !error); }
  };
  std::vector<Call> calls;
  std::map<GoalId, std::shared_ptr<Goal>> goals;

  void call(std::chrono::milliseconds timeout) {
    const std::size_t i = calls.size();
    calls.emplace_back();
    AddTwoInts::Request request;
    request.a(static_cast<std::int64_t>(i));
    request.b(1);
    add.call(
        request,
        [this, i](Expected<std::shared_ptr<AddTwoInts::Response>> response) {
          Call& mine = calls[i];
          if (response) {
            ++mine.answers;
            mine.right = (*response)->sum() == static_cast<std::int64_t>(i) + 1;
          } else {
            ++(response.error().outcome == Outcome::kTimeLimit ? mine.timeouts : mine.other);
          }
        },
        timeout);
  }
  GoalId send(int n, std::chrono::milliseconds timeout) {
    auto goal = std::make_shared<Goal>();
    const GoalId id = fib.send(order(n),
                               {.on_response =
                                    [goal](bool yes) {
                                      ++goal->responses;
                                      goal->accepted = yes;
                                    },
                                .on_feedback = {},
                                .on_result =
                                    [goal](auto result) {
                                      ++goal->results;
                                      if (result) {
                                        goal->end = result->first;
                                      } else {
                                        goal->error = result.error().outcome;
                                      }
                                    }},
                               timeout, timeout);
    goals[id] = goal;
    return id;
  }
  bool all_ended() const {
    return std::all_of(calls.begin(), calls.end(),
                       [](const Call& c) { return c.answers + c.timeouts + c.other > 0; }) &&
           std::all_of(goals.begin(), goals.end(), [](const auto& g) { return g.second->ended(); });
  }
  // Each call and goal ended exactly once, and was executed at most once: exactly once where an answer came.
  void expect_once_each() const {
    const auto executed = executions();
    for (const auto& [what, count] : executed) EXPECT_EQ(count, 1) << what << " was executed twice";
    for (std::size_t i = 0; i < calls.size(); ++i) {
      const Call& one = calls[i];
      EXPECT_EQ(one.answers + one.timeouts, 1) << "call " << i;
      EXPECT_EQ(one.other, 0) << "call " << i;
      if (one.answers == 0) continue;
      EXPECT_TRUE(one.right) << "call " << i;
      EXPECT_EQ(executed.count("add " + std::to_string(i)), 1u) << "call " << i;
    }
    for (const auto& [id, goal] : goals) {
      EXPECT_EQ(goal->responses, 1);
      EXPECT_LE(goal->results, 1);
      EXPECT_TRUE(goal->ended());
      EXPECT_EQ(goal->error.value_or(Outcome::kTimeLimit), Outcome::kTimeLimit);
      EXPECT_TRUE(!goal->accepted || executed.contains("goal " + to_hex(id)));
    }
  }
};

TEST_F(TwoProcesses, AThousandCallsAndTwoHundredGoals) {
  auto peer = start("serve");
  ASSERT_TRUE(add.wait_for_service(5s));
  ASSERT_TRUE(fib.wait_for_server(5s));
  for (int i = 0; i < 1000; ++i) {
    call(20s);
    if (i % 10 == 0) loop.run_pending();
  }
  for (int i = 0; i < 200; ++i) {
    const GoalId id = send(1 + static_cast<int>(random() % 20), 20s);
    loop.run_for(std::chrono::microseconds(random() % 3000));
    if (random() % 2 == 0) fib.cancel(id);
  }
  EXPECT_TRUE(loop.run_for(20s, [&] { return all_ended(); }));
  loop.run_for(100ms);  // what would come twice
  expect_once_each();
  EXPECT_EQ(executions().size(), 1200u) << "each exactly once";
  std::map<GoalState, int> ends;
  for (const auto& [id, goal] : goals) ++ends[goal->end];
  EXPECT_EQ(ends[GoalState::kSucceeded] + ends[GoalState::kCanceled], 200);
  EXPECT_GT(ends[GoalState::kCanceled], 20);
  EXPECT_GT(ends[GoalState::kSucceeded], 20);
}

TEST_F(TwoProcesses, TheServerIsKilledAndRestartedTenTimes) {
  int good = 0;
  for (int round = 0; round < 10; ++round) {
    auto peer = start("serve");
    // The endpoints of killed predecessors stay until their lease ends: ask until the new one answers.
    for (int tries = 0; tries < 100; ++tries) {
      call(100ms);
      loop.run_for(1s, [&] { return calls.back().answers + calls.back().timeouts > 0; });
      if (calls.back().answers > 0) break;
    }
    ASSERT_EQ(calls.back().answers, 1) << "round " << round;
    for (int i = 0; i < 100; ++i) {
      call(1s);
      if (i % 5 == 0) {
        const GoalId id = send(3, 1s);
        if (random() % 2 == 0) fib.cancel(id);
      }
      loop.run_for(std::chrono::microseconds(random() % 1500));
      if (i == 80) peer->signal(SIGKILL);
    }
  }
  EXPECT_TRUE(loop.run_for(5s, [&] { return all_ended(); }));
  loop.run_for(200ms);
  expect_once_each();
  for (const Call& one : calls) good += one.answers;
  EXPECT_GE(good, 10 * 60) << "between the kills the server serves";
  EXPECT_LT(good, static_cast<int>(calls.size())) << "the kills hit calls in flight";
}

TEST_F(TwoProcesses, ClientsAreKilledTenTimesAndOthersAreServedOn) {
  int executed = 0;
  Server<AddTwoInts> server(node, "/add", [&](const auto& request, auto& response) {
    ++executed;
    response.sum(request.a() + request.b());
  });
  ASSERT_TRUE(add.wait_for_service(5s));
  for (int round = 0; round < 10; ++round) {
    auto caller = start("call");
    const int before = executed;
    ASSERT_TRUE(loop.run_for(10s, [&] { return executed >= before + 200; })) << "round " << round;
    caller->signal(SIGKILL);
    for (int i = 0; i < 20; ++i) call(2s);
    ASSERT_TRUE(loop.run_for(3s, [&] { return all_ended(); })) << "round " << round;
  }
  for (const Call& one : calls) EXPECT_EQ(one.answers, 1);
}

}  // namespace
}  // namespace goalnet::ros
