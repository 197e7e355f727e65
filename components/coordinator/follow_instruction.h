// The action follow_instruction: goals become instructions, reports become feedback and results.
//
// A second goal while one runs is rejected, or waits, by the coordinator's parameter when_busy. An invalid
// instruction is rejected. Why is told on /instruction_status and /rosout, because a rejection carries no
// words. Ends: SUCCEEDED for outcome 0, CANCELED for 22, ABORTED for all else; the result holds outcome and
// message.
#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <mutex>

#include "components/coordinator/coordinator.h"
#include "components/ros/action_server.h"
#include "goalnet_msgs/action/FollowInstruction_action.h"

namespace goalnet::coordinator {

// Thread role: the node's event loop thread.
class FollowInstruction {
 public:
  // `node` and `coordinator` must outlive it. `interrupt` is called from a thread of DDS as soon as a cancel
  // request for an instruction arrives: the loop may be busy with a search for that very instruction.
  FollowInstruction(ros::Node& node, Coordinator& coordinator,
                    std::function<void(std::uint64_t id)> interrupt);

  // To be told of every report of the coordinator.
  void on_report(const Report& report);

  bool wait_for_acknowledgments(std::chrono::nanoseconds timeout) {
    return server_.wait_for_acknowledgments(timeout);
  }

 private:
  using Action = goalnet_msgs::action::FollowInstruction;
  using Handle = ros::GoalHandle<Action>;

  ros::GoalResponse on_goal(const ros::GoalId& goal_id, const Action::Goal& goal);
  bool on_cancel(const Handle& handle);
  void on_cancel_arrived(const ros::GoalId& id, ros::Time stamp);

  ros::Node& node_;
  Coordinator& coordinator_;
  const std::function<void(std::uint64_t id)> interrupt_;
  std::mutex mutex_;                                   // guards instructions_ where a thread of DDS reads it
  std::map<ros::GoalId, std::uint64_t> instructions_;  // of goals just taken or running
  std::map<std::uint64_t, std::shared_ptr<Handle>> handles_;    // by instruction
  std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);  // for what waits in the loop's queue
  ros::ActionServer<Action> server_;
};

}  // namespace goalnet::coordinator
