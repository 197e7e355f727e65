#include "tools/goalnet/reset_executor.h"

#include <optional>

#include "executor/executor_status.h"
#include "goalnet_msgs/msg/ExecutorStatus.h"
#include "std_msgs/msg/String.h"
#include "tools/goalnet/stop_signal.h"

namespace goalnet::tools {

using namespace std::chrono_literals;
using goalnet_msgs::msg::ExecutorStatus;

namespace {

constexpr auto kFault = static_cast<std::uint8_t>(executor::ExecutorState::kFault);

}  // namespace

Expected<std::string> reset_executor(ros::Node& node, ros::EventLoop& loop,
                                     std::chrono::duration<double> wait) {
  constexpr auto kPatience = 5s;  // for the fault to end
  std::optional<ExecutorStatus> status;
  const auto in = node.subscribe<ExecutorStatus>("executor_status", ros::Qos::latched(),
                                                 [&](const ExecutorStatus& message) { status = message; });
  const auto out = node.advertise<std_msgs::msg::String>("executor_command", ros::Qos::standard());
  StopSignal stop([&] { loop.wake(); });
  const auto limit = std::chrono::duration_cast<std::chrono::nanoseconds>(wait);
  loop.run_for(limit, [&] { return (status && out->subscriber_count() > 0) || stop.requested(); });
  if (stop.requested()) return fail(Outcome::kCancelled, "interrupted before an executor was found");
  if (!status || out->subscriber_count() == 0) {
    return fail(Outcome::kComponentLost,
                "no executor is active here (" + node.resolve("executor_status") +
                    "): is the robot up, with this ROS_DOMAIN_ID, and is its namespace the one given with "
                    "--namespace?");
  }
  if (status->state() != kFault) return "the executor is in no fault";
  const std::string why = status->message();
  std_msgs::msg::String command;
  command.data("reset");
  // It takes no notice of one that comes while the robot still brakes or a joint is not heard of.
  const auto end = std::chrono::steady_clock::now() + kPatience;
  const auto over = [&] { return status->state() != kFault || stop.requested(); };
  do {
    out->publish(command);
  } while (!loop.run_for(500ms, over) && std::chrono::steady_clock::now() < end);
  if (status->state() == kFault) {
    return fail(Outcome::kInternal,
                "the executor stays in its fault; it leaves it where the robot stands and all joint_states "
                "arrive" +
                    (why.empty() ? "" : ": " + why));
  }
  return "the executor has left its fault" + (why.empty() ? "" : " (" + why + ")");
}

}  // namespace goalnet::tools
