// Cancelling an instruction in each of its stages, by the action, by the topic, and by deactivating the
// coordinator.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <optional>
#include <thread>

#include "goalnet_msgs/msg/CancelInstruction.h"
#include "tests/support/slowdown.h"
#include "tests/unit/coordinator/node_fixture.h"

namespace goalnet::coordinator {
namespace {

using namespace std::chrono_literals;
using goalnet_msgs::msg::CancelInstruction;
using testing::Contains;
using testing::HasSubstr;

struct Stopped {
  const char* stage;
  bool goalnet_is_silent, planner_is_silent, hands_are_stuck;
};
void PrintTo(const Stopped& one, std::ostream* out) { *out << one.stage; }

class CancelTest : public NodeTest, public testing::WithParamInterface<Stopped> {
 protected:
  // An instruction by the action that has come as far as the stage of this test.
  void begin(Follower& follower) {
    cancels = others->subscribe<CancelInstruction>(
        "/cancel_instruction", ros::Qos::standard(),
        [this](const auto& m) { forgotten.push_back(m.instruction_id()); });
    goalnet_is_silent = GetParam().goalnet_is_silent;
    planner_is_silent = GetParam().planner_is_silent;
    hands_are_stuck = GetParam().hands_are_stuck;
    id = follower.send("take the mug");
    ASSERT_TRUE(loop.run_for(5s, [&] {
      return follower.accepted && !reports.empty() &&
             to_string(reports.back().stage) == std::string(GetParam().stage);
    }));
    hands_are_stuck = false;  // they hear the cancel
    watch.emplace();
  }
  void expect_cancelled_at_once(const Follower& follower) {
    ASSERT_TRUE(loop.run_for(5s, [&] { return follower.state.has_value(); }));
    EXPECT_LT(watch->undisturbed(), 100ms);
    EXPECT_EQ(*follower.state, ros::GoalState::kCanceled);
    EXPECT_EQ(follower.result.outcome(), 22);
    EXPECT_EQ(reports.back().outcome, Outcome::kCancelled);
  }

  std::shared_ptr<ros::Subscription<CancelInstruction>> cancels;
  std::vector<std::uint64_t> forgotten;
  ros::GoalId id{};
  std::optional<testing_support::Slowdown> watch;  // since it was asked
};

TEST_P(CancelTest, ByTheAction) {
  start();
  const auto coordinator = CoordinatorNode::create(*node).value();
  play_the_others();
  Follower follower(*others);
  begin(follower);
  follower.client.cancel(id);
  expect_cancelled_at_once(follower);
  EXPECT_THAT(forgotten, Contains(reports.back().id)) << "whoever searches for it is told";
}

TEST_P(CancelTest, ByTheTopic) {
  start();
  const auto coordinator = CoordinatorNode::create(*node).value();
  play_the_others();
  const auto cancel = others->advertise<CancelInstruction>("/cancel_instruction");
  Follower follower(*others);
  begin(follower);
  CancelInstruction another;
  another.instruction_id(reports.back().id + 1);
  cancel->publish(another);
  loop.run_for(20ms);
  EXPECT_FALSE(follower.state) << "another instruction was meant";
  watch.emplace();
  cancel->publish(CancelInstruction{});  // 0: whatever runs
  expect_cancelled_at_once(follower);
}

TEST_P(CancelTest, ByDeactivatingTheCoordinator) {
  start();
  const auto coordinator = CoordinatorNode::create(*node).value();
  play_the_others();
  Follower follower(*others);
  begin(follower);
  const std::uint64_t number = reports.back().id;
  ASSERT_TRUE(coordinator->deactivate());
  ASSERT_TRUE(loop.run_for(5s, [&] { return follower.state.has_value(); }))
      << "the result comes before the silence";
  EXPECT_EQ(follower.result.outcome(), 22);
  EXPECT_THAT(follower.result.message(), HasSubstr("deactivated"));
  // Afterwards it works again, and never gives the same number twice.
  ASSERT_TRUE(coordinator->activate());
  goalnet_is_silent = planner_is_silent = false;
  reports.clear();
  say("take the mug");
  ASSERT_TRUE(wait_for_end());
  EXPECT_EQ(reports.back().outcome, Outcome::kDone) << reports.back().message;
  EXPECT_GT(reports.back().id, number);
}

INSTANTIATE_TEST_SUITE_P(Stages, CancelTest,
                         testing::Values(Stopped{"inferring", true, false, false},
                                         Stopped{"planning", false, true, false},
                                         Stopped{"acting", false, false, true}),
                         [](const auto& one) { return std::string(one.param.stage); });

// As in `goalnet run`, where a search keeps the one loop of all components busy.
TEST_F(NodeTest, ACancelRequestReachesSearchesWhileTheLoopIsBusy) {
  start();
  const auto coordinator = CoordinatorNode::create(*node).value();
  play_the_others();
  planner_is_silent = true;
  ros::EventLoop client_loop;
  ros::NodeOptions options;
  options.name = "client";
  const auto client = ros::Node::create(*context, client_loop, std::move(options)).value();
  Follower follower(*client);
  std::atomic<std::uint64_t> told{0};
  const auto search = others->subscribe<CancelInstruction>("/cancel_instruction", ros::Qos::standard(),
                                                           [&](const auto& m) { told = m.instruction_id(); },
                                                           {.immediate = true});
  std::jthread robot([this] { loop.run(); });
  const ros::GoalId id = follower.send("take the mug");
  ASSERT_TRUE(client_loop.run_for(5s, [&] {
    return std::find(follower.stages.begin(), follower.stages.end(), "planning") != follower.stages.end();
  }));
  std::atomic<bool> busy{false};
  loop.post([&] {
    busy = true;
    const auto end = std::chrono::steady_clock::now() + 5s;
    while (told == 0 && std::chrono::steady_clock::now() < end) std::this_thread::sleep_for(1ms);
  });
  while (!busy) std::this_thread::sleep_for(1ms);
  testing_support::Slowdown watch;
  follower.client.cancel(id);
  ASSERT_TRUE(client_loop.run_for(10s, [&] { return follower.state.has_value(); }));
  EXPECT_LT(watch.undisturbed(), 100ms);
  EXPECT_EQ(*follower.state, ros::GoalState::kCanceled);
  loop.stop();
  robot.join();
  EXPECT_EQ(told, reports.back().id);
}

TEST_F(NodeTest, WithWhenBusyQueueTheSecondGoalWaitsForTheFirst) {
  start({"--ros-args", "-p", "when_busy:=queue"});
  const auto coordinator = CoordinatorNode::create(*node).value();
  play_the_others();
  planner_is_silent = true;
  Follower first(*others), second(*others);
  const ros::GoalId id = first.send("take the mug");
  ASSERT_TRUE(loop.run_for(5s, [&] { return first.accepted.has_value() && !reports.empty(); }));
  second.send("take the mug");
  ASSERT_TRUE(loop.run_for(5s, [&] { return second.accepted.has_value(); }));
  EXPECT_TRUE(*second.accepted);
  planner_is_silent = false;
  first.client.cancel(id);
  ASSERT_TRUE(loop.run_for(5s, [&] { return second.state.has_value(); }));
  EXPECT_EQ(*first.state, ros::GoalState::kCanceled);
  EXPECT_EQ(*second.state, ros::GoalState::kSucceeded) << second.result.message();
}

TEST_F(NodeTest, TimeThatStandsStillEndsTheInstruction) {
  start({"--ros-args", "-p", "use_sim_time:=true", "-p", "standstill_timeout:=2.0"});
  const auto coordinator = CoordinatorNode::create(*node).value();
  play_the_others();
  hands_are_stuck = true;
  Follower follower(*others);
  follower.send("take the mug");  // no /clock ever comes
  ASSERT_TRUE(loop.run_for(20s, [&] { return follower.state.has_value(); }));
  EXPECT_EQ(follower.result.outcome(), 31);
  EXPECT_THAT(follower.result.message(), HasSubstr("simulated time stands still"));
}

}  // namespace
}  // namespace goalnet::coordinator
