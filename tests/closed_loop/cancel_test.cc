// `goalnet run`'s loop, cancelled through the action by another process's means: all components share one
// thread there, and the cancel must get through whatever that thread is busy with.
#include <gmock/gmock-matchers.h>

#include <atomic>
#include <cstdlib>
#include <thread>

#include "components/ros/action_client.h"
#include "goalnet_msgs/action/FollowInstruction_action.h"
#include "goalnet_msgs/msg/InstructionStatus.h"
#include "sim/world.h"
#include "tests/support/slowdown.h"
#include "tools/goalnet/lockstep_loop.h"

namespace goalnet::tools {
namespace {

using namespace std::chrono_literals;
using FollowAction = goalnet_msgs::action::FollowInstruction;

constexpr const char* kDomain = "88";

TEST(Cancel, GetsThroughWithinATenthOfASecondWheneverItComes) {
  setenv("ROS_DOMAIN_ID", kDomain, 1);
  std::atomic<bool> ready{false};
  std::atomic<double> speed{0.0};  // of the fastest joint
  std::jthread robot([&](const std::stop_token& stop) {
    auto loop = LockstepLoop::create({}, {});
    ASSERT_TRUE(loop) << loop.error().message;
    ASSERT_TRUE((*loop)->settle());
    ready = true;
    while (!stop.stop_requested()) {
      (*loop)->step();
      double fastest = 0.0;
      for (std::size_t j = 0; j < (*loop)->world().robot_joint_count(); ++j)
        fastest = std::max(fastest, std::abs((*loop)->world().robot_joint(j).velocity));
      speed = fastest;
      std::this_thread::sleep_for(2ms);  // at most five times real time, so that motions last a while
    }
  });
  ros::EventLoop loop;
  const auto context = ros::Context::create().value();
  ros::NodeOptions options;
  options.name = "person";
  const auto node = ros::Node::create(*context, loop, std::move(options)).value();
  ros::ActionClient<FollowAction> client(*node, "/follow_instruction");
  goalnet_msgs::msg::InstructionStatus last;
  const auto status = node->subscribe<goalnet_msgs::msg::InstructionStatus>(
      "/instruction_status", ros::Qos::latched().keep_last(1000),
      [&](const auto& message) { last = message; });
  ASSERT_TRUE(client.wait_for_server(30s));
  ASSERT_TRUE(loop.run_for(30s, [&] { return ready.load(); }));

  bool cancelled_in_motion = false;
  // After the start of acting: in planning of a stand and a path, and in motion.
  for (const auto delay : {0ms, 3ms, 10ms, 30ms, 100ms, 400ms}) {
    last = {};
    std::optional<ros::GoalState> ended;
    FollowAction::Result result;
    FollowAction::Goal goal;
    goal.instruction("turn on the tap");
    const ros::GoalId id =
        client.send(goal, {.on_response = {}, .on_feedback = {}, .on_result = [&](const auto& outcome) {
                             ended = outcome->first;
                             result = outcome->second;
                           }});
    ASSERT_TRUE(loop.run_for(30s, [&] { return last.stage() == "acting"; })) << last.stage();
    loop.run_for(delay);
    cancelled_in_motion = cancelled_in_motion || speed > 0.1;
    testing_support::Slowdown watch;
    client.cancel(id);
    ASSERT_TRUE(loop.run_for(10s, [&] { return last.stage() == "stopping" || last.finished(); }));
    EXPECT_LT(watch.undisturbed(), 100ms) << delay.count() << " ms after the start of acting";
    ASSERT_TRUE(loop.run_for(30s, [&] { return ended.has_value(); }));
    EXPECT_EQ(*ended, ros::GoalState::kCanceled) << result.message();
    EXPECT_EQ(result.outcome(), 22);
    EXPECT_TRUE(loop.run_for(10s, [&] { return speed < 1e-3; })) << "the robot stands";
  }
  EXPECT_TRUE(cancelled_in_motion);
}

}  // namespace
}  // namespace goalnet::tools
