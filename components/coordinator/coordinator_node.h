// The coordinator on DDS: topics in, topics out, and a timer for what does not come. Logic: coordinator.h.
#pragma once

#include <memory>
#include <string>

#include "components/coordinator/coordinator.h"
#include "components/coordinator/follow_instruction.h"
#include "components/coordinator/planner_action_model.h"
#include "components/ros/node.h"
#include "goalnet_msgs/msg/ActionRequest.h"
#include "goalnet_msgs/msg/ActionStatus.h"
#include "goalnet_msgs/msg/GoalPredicates.h"
#include "goalnet_msgs/msg/InstructionStatus.h"
#include "goalnet_msgs/msg/Plan.h"
#include "goalnet_msgs/msg/StepRequest.h"
#include "goalnet_msgs/msg/WorldState.h"
#include "std_msgs/msg/String.h"

namespace goalnet::coordinator {

// Thread role: created and used in the node's event loop thread.
class CoordinatorNode : public ros::Component, private Port {
 public:
  // Reads its parameters (README.md). Errors: kInvalidRequest for parameters or a domain file that make no
  // sense.
  static Expected<std::unique_ptr<CoordinatorNode>> create(ros::Node& node);

  // Stops what runs, as if asked through DDS.
  void cancel(const std::string& reason);

  // Readers this node waits for answers from; for a launcher that wants all in place before it gives an
  // instruction.
  bool connected() const;

 private:
  CoordinatorNode(ros::Node& node, const CoordinatorParams& params, planner::Domain domain);
  void open_topics();

  void request_goal(std::uint64_t id, std::uint32_t step, const std::string& instruction,
                    TimeNs world_stamp) override;
  void request_plan(std::uint64_t id, std::uint32_t step, const std::string& instruction,
                    const Goal& goal) override;
  void execute(const ActionOrder& order) override;
  void cancel(const ActionOrder& order) override;
  void report(const Report& report) override;

  void on_instruction(const std_msgs::msg::String& message);
  void on_given_goal(const goalnet_msgs::msg::GoalPredicates& message);
  void on_goal_predicates(const goalnet_msgs::msg::GoalPredicates& message);
  void on_plan(const goalnet_msgs::msg::Plan& message);
  void on_action_status(const goalnet_msgs::msg::ActionStatus& message);
  void on_world_state(const goalnet_msgs::msg::WorldState& message);
  void send_order(const ActionOrder& order, std::uint8_t command);
  TimeNs now() const { return node_.now().nanoseconds; }

  ros::Node& node_;
  PlannerActionModel model_;
  Coordinator coordinator_;
  std::uint64_t finished_id_ = 0;  // the last instruction whose end was logged

  std::shared_ptr<ros::Publisher<goalnet_msgs::msg::StepRequest>> step_request_;
  std::shared_ptr<ros::Publisher<goalnet_msgs::msg::GoalPredicates>> goal_predicates_;
  std::shared_ptr<ros::Publisher<goalnet_msgs::msg::ActionRequest>> action_request_;
  std::shared_ptr<ros::Publisher<goalnet_msgs::msg::InstructionStatus>> status_;
  std::shared_ptr<ros::Subscription<std_msgs::msg::String>> instruction_;
  std::shared_ptr<ros::Subscription<goalnet_msgs::msg::GoalPredicates>> goal_;
  std::shared_ptr<ros::Subscription<goalnet_msgs::msg::GoalPredicates>> inferred_;
  std::shared_ptr<ros::Subscription<goalnet_msgs::msg::Plan>> plan_;
  std::shared_ptr<ros::Subscription<goalnet_msgs::msg::ActionStatus>> action_status_;
  std::shared_ptr<ros::Subscription<goalnet_msgs::msg::WorldState>> world_state_;
  std::shared_ptr<ros::Timer> timer_;
  std::unique_ptr<FollowInstruction> action_;
};

}  // namespace goalnet::coordinator
