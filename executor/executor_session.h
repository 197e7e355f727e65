// The executor's topics and threads while it is active.
//
// In:  joint_trajectory (trajectory_msgs/JointTrajectory), executor_command (std_msgs/String: stop, reset,
//      emergency_stop), joint_states (sensor_msgs/JointState; on the wall clock only).
// Out: executor_status (goalnet_msgs/ExecutorStatus, latched; 50 Hz while moving, and on change),
// joint_commands
//      (sensor_msgs/JointState, depth 1).
// A trajectory that is refused is answered with one status that carries its stamp and an outcome other than
// 0; what runs goes on.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "components/core/outcome.h"
#include "components/ros/log_limit.h"
#include "components/ros/node.h"
#include "executor/executor_parameters.h"
#include "executor/joint_messages.h"
#include "executor/trajectory_executor.h"
#include "executor/wall_clock_loop.h"
#include "goalnet_msgs/msg/ExecutorStatus.h"
#include "sensor_msgs/msg/JointState.h"
#include "std_msgs/msg/String.h"
#include "trajectory_msgs/msg/JointTrajectory.h"

namespace goalnet::executor {

// Belongs to the thread of the node's event loop; that thread is also the executor's "other thread".
class ExecutorSession {
 public:
  // Opens the topics; on the wall clock, starts the control thread. All must outlive the session.
  ExecutorSession(ros::Node& node, const NodeParams& params, TrajectoryExecutor& executor);
  ~ExecutorSession();

  // Asks for a smooth stop and says so. On the wall clock it waits until the robot stands (8 s at most, then
  // it brakes hard); in lockstep the robot comes to rest while the simulator goes on.
  void leave();

 private:
  void open_topics();
  bool wait_for_standstill();
  void on_trajectory(const trajectory_msgs::msg::JointTrajectory& message);
  void on_command(const std_msgs::msg::String& message);
  void on_joint_states(const sensor_msgs::msg::JointState& message);
  void report();
  void refuse(std::int64_t stamp_ns, Outcome outcome, const std::string& message);
  void publish(ExecutorStatus status);

  ros::Node& node_;
  const NodeParams& params_;
  TrajectoryExecutor& executor_;
  JointStateReader reader_;
  std::shared_ptr<ros::Publisher<goalnet_msgs::msg::ExecutorStatus>> status_publisher_;
  std::shared_ptr<ros::Publisher<sensor_msgs::msg::JointState>> command_publisher_;
  std::shared_ptr<ros::Subscription<trajectory_msgs::msg::JointTrajectory>> trajectory_;
  std::shared_ptr<ros::Subscription<std_msgs::msg::String>> command_;
  std::shared_ptr<ros::Subscription<sensor_msgs::msg::JointState>> joint_states_;
  ros::Clock wall_clock_;
  std::shared_ptr<ros::Timer> timer_;
  std::optional<ExecutorStatus> reported_;
  bool refused_lately_ = false;
  std::int64_t last_stamp_ = 0;  // of the trajectory taken or refused last
  ros::LogLimit unknown_lines_, command_lines_, joint_state_lines_, refusal_lines_;
  std::unique_ptr<WallClockLoop> loop_;  // last: its threads end first
};

}  // namespace goalnet::executor
