// The action follow_instruction: goals become instructions, reports become feedback and results.
//
// A second goal while one runs is rejected, or waits, by the coordinator's parameter when_busy. An invalid instruction
// is rejected. Why is told on /instruction_status and /rosout, because a rejection carries no words.
// Ends: SUCCEEDED for outcome 0, CANCELED for 22, ABORTED for all else; the result holds outcome and message.
#pragma once

#include <functional>
#include <map>
#include <memory>

#include "components/coordinator/coordinator.h"
#include "components/ros/action_server.h"
#include "goalnet_msgs/action/FollowInstruction_action.h"

namespace goalnet::coordinator {

// Thread role: the node's event loop thread.
class FollowInstruction {
 public:
  // `node` and `coordinator` must outlive it.
  FollowInstruction(ros::Node& node, Coordinator& coordinator);

  // To be told of every report of the coordinator.
  void on_report(const Report& report);

 private:
  using Action = goalnet_msgs::action::FollowInstruction;
  using Handle = ros::GoalHandle<Action>;

  ros::GoalResponse on_goal(const ros::GoalId& goal_id, const Action::Goal& goal);
  bool on_cancel(const Handle& handle);

  ros::Node& node_;
  Coordinator& coordinator_;
  std::map<ros::GoalId, std::uint64_t> instructions_;          // of goals just taken or running
  std::map<std::uint64_t, std::shared_ptr<Handle>> handles_;   // by instruction
  std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);  // for what waits in the loop's queue
  ros::ActionServer<Action> server_;
};

}  // namespace goalnet::coordinator
