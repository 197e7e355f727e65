// Between the executor's plain structs and ROS 2 messages.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "components/core/outcome.h"
#include "executor/executor_params.h"
#include "executor/executor_status.h"
#include "executor/joint_sample.h"
#include "executor/joint_trajectory.h"
#include "goalnet_msgs/msg/ExecutorStatus.h"
#include "sensor_msgs/msg/JointState.h"
#include "trajectory_msgs/msg/JointTrajectory.h"

namespace goalnet::executor {

JointTrajectory from_message(const trajectory_msgs::msg::JointTrajectory& message);

// Collects joint states that may come in parts: each message updates the joints that it names; others, such
// as those of doors, are left out.
class JointStateReader {
 public:
  explicit JointStateReader(const std::vector<JointLimits>& joints);
  // `time_ns` is the moment of arrival. Fails with kInvalidRequest, changing nothing, if sizes differ or a
  // number is not finite.
  Expected<void> read(const sensor_msgs::msg::JointState& message, std::int64_t time_ns);
  bool complete() const { return seen_ == indices_.size(); }  // every joint has been seen
  // As old as the joint that was heard of longest ago: a driver that has died is noticed although others, of
  // doors or of other joints, still talk.
  const JointSample& sample() const { return sample_; }

 private:
  std::map<std::string, std::size_t> indices_;
  std::vector<std::int64_t> heard_;  // [ns] when, of each joint; 0: never
  std::size_t seen_ = 0;
  JointSample sample_;
};

sensor_msgs::msg::JointState to_message(const JointSample& sample, const std::vector<JointLimits>& joints);
goalnet_msgs::msg::ExecutorStatus to_message(const ExecutorStatus& status);

}  // namespace goalnet::executor
