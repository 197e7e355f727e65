// Managed nodes and diagnostics.
#include "components/ros/lifecycle.h"

#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>

#include <cmath>

#include "components/ros/diagnostics.h"
#include "components/ros/log_limit.h"
#include "components/ros/service.h"
#include "lifecycle_msgs/msg/TransitionEvent.h"
#include "lifecycle_msgs/srv/ChangeState_service.h"
#include "lifecycle_msgs/srv/GetAvailableStates_service.h"
#include "lifecycle_msgs/srv/GetAvailableTransitions_service.h"
#include "lifecycle_msgs/srv/GetState_service.h"
#include "rcl_interfaces/msg/Log.h"
#include "tests/unit/ros/support.h"

namespace goalnet::ros {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using State = LifecycleState;
using Result = TransitionResult;

struct LifecycleTest : testing::Test {
  std::unique_ptr<Context> context = make_context(own_domain());
  EventLoop loop;
  Node node{*context, loop, plain("planner")};
};

TEST_F(LifecycleTest, EveryStateAnswersEveryTransition) {
  // What rcl_lifecycle allows: state -> ids.
  const std::map<State, std::vector<int>> expected = {{State::kUnconfigured, {1, 5}},
                                                      {State::kInactive, {2, 3, 6}},
                                                      {State::kActive, {4, 7}},
                                                      {State::kFinalized, {}}};
  for (const auto& [state, ids] : expected) {
    std::vector<int> possible;
    for (int id = 0; id < 100; ++id) {
      if (find_transition(state, static_cast<std::uint8_t>(id), "")) possible.push_back(id);
    }
    EXPECT_EQ(possible, ids) << label(state);
  }
  EXPECT_EQ(find_transition(State::kActive, 0, "shutdown")->id, 7) << "the label wins";
  EXPECT_FALSE(find_transition(State::kActive, 4, "nonsense"));
  for (const State state : {State::kConfiguring, State::kCleaningUp, State::kShuttingDown, State::kActivating,
                            State::kDeactivating}) {
    EXPECT_EQ(after(state, Result::kError), State::kErrorProcessing) << label(state);
  }
  EXPECT_EQ(after(State::kDeactivating, Result::kFailure), State::kActive);
  EXPECT_EQ(after(State::kShuttingDown, Result::kFailure), State::kFinalized);
  EXPECT_EQ(after(State::kErrorProcessing, Result::kSuccess), State::kUnconfigured);
}

TEST_F(LifecycleTest, OverServicesWithEvents) {
  std::vector<std::string> work;
  Lifecycle lifecycle(node, {.on_configure =
                                 [&] {
                                   work.push_back("configure");
                                   return Result::kSuccess;
                                 },
                             .on_activate =
                                 [&] {
                                   work.push_back("activate");
                                   return Result::kSuccess;
                                 },
                             .on_deactivate = {},
                             .on_cleanup = {},
                             .on_shutdown =
                                 [&](State from) {
                                   work.push_back("shutdown from " + std::string(label(from)));
                                   return Result::kSuccess;
                                 },
                             .on_error = {}});
  Node tool(*context, loop, plain("tool"));
  std::vector<std::string> events;
  auto in = tool.subscribe<lifecycle_msgs::msg::TransitionEvent>(
      "/planner/transition_event", Qos::standard(), [&](const auto& m) {
        events.push_back(m.start_state().label() + ">" + m.goal_state().label());
        EXPECT_EQ(m.timestamp(), 0u);
        EXPECT_EQ(m.transition().id(), 0);
      });
  Client<lifecycle_msgs::srv::ChangeState> change(tool, "/planner/change_state");
  Client<lifecycle_msgs::srv::GetState> get(tool, "/planner/get_state");
  Client<lifecycle_msgs::srv::GetAvailableStates> states(tool, "/planner/get_available_states");
  Client<lifecycle_msgs::srv::GetAvailableTransitions> possible(tool, "/planner/get_available_transitions");
  Client<lifecycle_msgs::srv::GetAvailableTransitions> graph(tool, "/planner/get_transition_graph");
  const auto ask = [&](int id, const std::string& name) {
    lifecycle_msgs::srv::ChangeState::Request request;
    request.transition().id(static_cast<std::uint8_t>(id));
    request.transition().label(name);
    return change.call_and_run(request, 2s)->success();
  };
  EXPECT_FALSE(ask(3, "")) << "cannot activate what is not configured";
  EXPECT_TRUE(ask(1, "configure"));
  EXPECT_EQ(get.call_and_run({}, 2s)->current_state().label(), "inactive");
  EXPECT_TRUE(ask(3, ""));
  EXPECT_TRUE(lifecycle.active());
  std::vector<std::string> labels;
  const auto now_possible = possible.call_and_run({}, 2s);
  ASSERT_TRUE(now_possible);
  for (const auto& one : now_possible->available_transitions()) {
    labels.push_back(one.transition().label() + ">" + one.goal_state().label());
  }
  EXPECT_THAT(labels, ElementsAre("deactivate>deactivating", "shutdown>shuttingdown"));
  EXPECT_FALSE(ask(1, ""));
  EXPECT_TRUE(ask(0, "shutdown"));
  EXPECT_EQ(lifecycle.state(), State::kFinalized);
  EXPECT_FALSE(ask(0, "shutdown"));
  EXPECT_EQ(states.call_and_run({}, 2s)->available_states().size(), 11u);
  EXPECT_EQ(graph.call_and_run({}, 2s)->available_transitions().size(), 25u);
  EXPECT_THAT(work, ElementsAre("configure", "activate", "shutdown from active"));
  EXPECT_THAT(events, ElementsAre("unconfigured>configuring", "configuring>inactive", "inactive>activating",
                                  "activating>active", "active>shuttingdown", "shuttingdown>finalized"));
}

TEST_F(LifecycleTest, AFloodOfIllegalRequestsIsAnsweredButNotWrittenDown) {
  Lifecycle lifecycle(node, {});
  Node tool(*context, loop, plain("tool"));
  int lines = 0;
  auto log = tool.subscribe<rcl_interfaces::msg::Log>("/rosout", Qos::rosout(), [&](const auto& record) {
    lines += record.msg().find("is not possible") != std::string::npos ? 1 : 0;
  });
  Client<lifecycle_msgs::srv::ChangeState> change(tool, "/planner/change_state");
  lifecycle_msgs::srv::ChangeState::Request activate;
  activate.transition().id(3);
  const auto start = std::chrono::steady_clock::now();
  constexpr int kRequests = 300;
  for (int i = 0; i < kRequests; ++i) {
    const auto response = change.call_and_run(activate, 5s);
    ASSERT_TRUE(response) << response.error().message;
    EXPECT_FALSE(response->success());
  }
  loop.run_for(50ms);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  EXPECT_GE(lines, 1);
  EXPECT_LE(lines, LogLimit::kLines * (1 + static_cast<int>(seconds) + 1));
  EXPECT_LT(lines, kRequests / 2);
}

TEST_F(LifecycleTest, FailuresAndErrors) {
  Result configure = Result::kFailure;
  Result recover = Result::kSuccess;
  Lifecycle lifecycle(node, {.on_configure = [&]() -> Result {
                               if (configure == Result::kError) throw std::runtime_error("no such model");
                               return configure;
                             },
                             .on_activate = {},
                             .on_deactivate = {},
                             .on_cleanup = {},
                             .on_shutdown = {},
                             .on_error = [&](State) { return recover; }});
  EXPECT_FALSE(lifecycle.configure());
  EXPECT_EQ(lifecycle.state(), State::kUnconfigured);
  configure = Result::kError;
  EXPECT_FALSE(lifecycle.configure());
  EXPECT_EQ(lifecycle.state(), State::kUnconfigured) << "error processing succeeded";
  recover = Result::kFailure;
  EXPECT_FALSE(lifecycle.configure());
  EXPECT_EQ(lifecycle.state(), State::kFinalized);
}

TEST_F(LifecycleTest, Diagnostics) {
  Diagnostics diagnostics(node);
  double lateness = 10;
  diagnostics.add("control loop",
                  [&](DiagnosticReport& report) { report.threshold("lateness", lateness, 100, 1000, "us"); });
  std::vector<diagnostic_msgs::msg::DiagnosticStatus> seen;
  auto in = node.subscribe<diagnostic_msgs::msg::DiagnosticArray>("/diagnostics", Qos::standard(),
                                                                  [&](const auto& m) { seen = m.status(); });
  const auto publish = [&](double value) {
    lateness = value;
    diagnostics.publish();
    loop.run_pending();
    return seen.at(0);
  };
  EXPECT_EQ(publish(10).level(), 0);
  EXPECT_EQ(seen[0].name(), "planner: control loop");
  EXPECT_EQ(seen[0].values().at(0).value(), "10 us");
  EXPECT_EQ(publish(200).level(), 1);
  EXPECT_EQ(publish(2000).level(), 2);
  EXPECT_EQ(publish(std::nan("")).level(), 2);
  seen.clear();
  EXPECT_TRUE(loop.run_for(1500ms, [&] { return !seen.empty(); })) << "once a second by itself";
}

}  // namespace
}  // namespace goalnet::ros
