// The coordinator on DDS while it is active: topics in, topics out, and a timer for what does not come.
// Logic: coordinator.h.
#pragma once

#include <memory>
#include <string>

#include "components/coordinator/coordinator.h"
#include "components/coordinator/follow_instruction.h"
#include "components/ros/log_limit.h"
#include "components/ros/node.h"
#include "goalnet_msgs/msg/ActionRequest.h"
#include "goalnet_msgs/msg/ActionStatus.h"
#include "goalnet_msgs/msg/CancelInstruction.h"
#include "goalnet_msgs/msg/GoalPredicates.h"
#include "goalnet_msgs/msg/InstructionStatus.h"
#include "goalnet_msgs/msg/Plan.h"
#include "goalnet_msgs/msg/StepRequest.h"
#include "goalnet_msgs/msg/WorldState.h"
#include "std_msgs/msg/String.h"

namespace goalnet::coordinator {

// Thread role: created and used in the node's event loop thread.
class CoordinatorSession : private Port {
 public:
  // Opens the topics and serves the action. All must outlive the session.
  CoordinatorSession(ros::Node& node, const CoordinatorParams& params, const ActionModel& model,
                     std::uint64_t first_id);

  // Stops what runs, as if asked through DDS.
  void cancel(const std::string& reason);

  // Stops what runs and ends it at once, without waiting until manipulation says that the robot stands; then
  // waits a moment until all have been told.
  void leave();

  // Whether all whose answers are needed are there; for a launcher that wants them in place before it gives
  // an instruction.
  bool connected() const;

  std::uint64_t last_id() const { return coordinator_.last_id(); }

 private:
  void open_topics();
  void watch_time();

  void request_goal(std::uint64_t id, std::uint32_t step, const std::string& instruction,
                    TimeNs world_stamp) override;
  void request_plan(std::uint64_t id, std::uint32_t step, const std::string& instruction,
                    const Goal& goal) override;
  void execute(const ActionOrder& order) override;
  void cancel(const ActionOrder& order) override;
  void forget_request(std::uint64_t id) override;
  void report(const Report& report) override;

  void on_instruction(const std_msgs::msg::String& message);
  void complain(const char* topic, const std::string& what);
  void on_given_goal(const goalnet_msgs::msg::GoalPredicates& message);
  void on_goal_predicates(const goalnet_msgs::msg::GoalPredicates& message);
  void on_plan(const goalnet_msgs::msg::Plan& message);
  void on_action_status(const goalnet_msgs::msg::ActionStatus& message);
  void on_world_state(const goalnet_msgs::msg::WorldState& message);
  void on_cancel(const goalnet_msgs::msg::CancelInstruction& message);
  void send_order(const ActionOrder& order, std::uint8_t command);
  TimeNs now() const { return node_.now().nanoseconds; }

  ros::Node& node_;
  Coordinator coordinator_;
  ros::LogLimit bad_messages_, end_lines_;
  std::uint64_t finished_id_ = 0;  // the last instruction whose end was logged

  std::shared_ptr<ros::Publisher<goalnet_msgs::msg::StepRequest>> step_request_;
  std::shared_ptr<ros::Publisher<goalnet_msgs::msg::GoalPredicates>> goal_predicates_;
  std::shared_ptr<ros::Publisher<goalnet_msgs::msg::ActionRequest>> action_request_;
  std::shared_ptr<ros::Publisher<goalnet_msgs::msg::InstructionStatus>> status_;
  std::shared_ptr<ros::Publisher<goalnet_msgs::msg::CancelInstruction>> cancel_;
  std::shared_ptr<ros::Subscription<goalnet_msgs::msg::CancelInstruction>> cancel_asked_;
  std::shared_ptr<ros::Subscription<std_msgs::msg::String>> instruction_;
  std::shared_ptr<ros::Subscription<goalnet_msgs::msg::GoalPredicates>> goal_;
  std::shared_ptr<ros::Subscription<goalnet_msgs::msg::GoalPredicates>> inferred_;
  std::shared_ptr<ros::Subscription<goalnet_msgs::msg::Plan>> plan_;
  std::shared_ptr<ros::Subscription<goalnet_msgs::msg::ActionStatus>> action_status_;
  std::shared_ptr<ros::Subscription<goalnet_msgs::msg::WorldState>> world_state_;
  std::shared_ptr<ros::Timer> timer_;
  ros::Clock wall_clock_;
  std::shared_ptr<ros::Timer> wall_timer_;
  TimeNs last_time_ = 0;  // of the node's clock, seen by wall_timer_
  const double standstill_timeout_;
  int seconds_still_ = 0;  // for which that has not moved
  std::unique_ptr<FollowInstruction> action_;
};

}  // namespace goalnet::coordinator
