// Manipulation while it is active: one symbolic action at a time becomes trajectories.
//
// In:  action_request (goalnet_msgs/ActionRequest), executor_status (goalnet_msgs/ExecutorStatus, latched),
// joint_states,
//      object_poses, world_state, cancel_instruction (goalnet_msgs/CancelInstruction: ends planning at once).
// Out: action_status (goalnet_msgs/ActionStatus: RUNNING on every new stage and at 10 Hz, FINISHED once),
//      joint_trajectory (trajectory_msgs/JointTrajectory; header.stamp names it), executor_command ("stop").
// A request sent again while it runs changes nothing; after its end it is answered again. Another request
// stops the action under way first. A request waits until the world has been perceived.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>

#include "components/manipulation/action_runner.h"
#include "components/manipulation/perception.h"
#include "components/ros/log_limit.h"
#include "components/ros/node.h"
#include "goalnet_msgs/msg/ActionRequest.h"
#include "goalnet_msgs/msg/ActionStatus.h"
#include "goalnet_msgs/msg/CancelInstruction.h"
#include "goalnet_msgs/msg/ExecutorStatus.h"
#include "std_msgs/msg/String.h"
#include "trajectory_msgs/msg/JointTrajectory.h"

namespace goalnet::manipulation {

// Belongs to the thread of the node's event loop, but for interrupt().
class ManipulationSession {
 public:
  // Opens the topics. `bench` must outlive the session.
  ManipulationSession(ros::Node& node, Workbench& bench);
  ~ManipulationSession();

  // Ends what runs as kCancelled and tells the executor to stop; waits a moment until both have been told.
  void leave();

  // From any thread: ends motion planning that runs, with kCancelled.
  void interrupt() { interrupted_.store(true); }

 private:
  void open_topics();
  void on_request(const goalnet_msgs::msg::ActionRequest& message);
  void on_cancel(const goalnet_msgs::msg::ActionRequest& message);
  void on_executor_status(const goalnet_msgs::msg::ExecutorStatus& message);
  template <class Message>
  void perceive(const char* topic, const Message& message);
  void update();
  bool moving() const;  // as the executor said last
  void send_stop();
  void start_waiting();
  void end_in_fault();
  void report();
  void publish_status(const goalnet_msgs::msg::ActionRequest& request, bool finished, const Error& result);

  ros::Node& node_;
  Workbench& bench_;
  ActionRunner runner_;
  Perception perception_;
  executor::ExecutorStatus executor_;
  bool abandoned_ = false;  // nobody is there any more who could want current_ done
  Error fault_;             // why the executor is in its state FAULT
  std::atomic<bool> interrupted_{false};
  std::atomic<std::uint64_t> instruction_{0};  // that current_ belongs to
  std::uint32_t step_ = 0;                     // of it

  std::optional<goalnet_msgs::msg::ActionRequest> current_;       // runs
  std::optional<goalnet_msgs::msg::ActionRequest> waiting_;       // for the world, or for the end of current_
  std::optional<goalnet_msgs::msg::ActionRequest> stopping_for_;  // a cancel, answered when the robot stands
  std::optional<goalnet_msgs::msg::ActionStatus> last_;           // how the last one ended
  std::string reported_stage_;
  ros::Time reported_at_;
  ros::LogLimit bad_messages_;

  std::shared_ptr<ros::Publisher<goalnet_msgs::msg::ActionStatus>> status_;
  std::shared_ptr<ros::Publisher<trajectory_msgs::msg::JointTrajectory>> trajectory_;
  std::shared_ptr<ros::Publisher<std_msgs::msg::String>> command_;
  std::shared_ptr<ros::Subscription<goalnet_msgs::msg::ActionRequest>> request_;
  std::shared_ptr<ros::Subscription<goalnet_msgs::msg::CancelInstruction>> instruction_cancelled_;
  std::shared_ptr<ros::Subscription<goalnet_msgs::msg::ExecutorStatus>> executor_status_;
  std::shared_ptr<ros::Subscription<sensor_msgs::msg::JointState>> joint_states_;
  std::shared_ptr<ros::Subscription<goalnet_msgs::msg::ObjectPoses>> object_poses_;
  std::shared_ptr<ros::Subscription<goalnet_msgs::msg::WorldState>> world_state_;
  std::shared_ptr<ros::Timer> timer_;
};

}  // namespace goalnet::manipulation
