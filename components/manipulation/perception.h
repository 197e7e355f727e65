// Collects what is heard of the world into one WorldView.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "components/core/outcome.h"
#include "components/manipulation/world_view.h"
#include "components/robot/robot_model.h"
#include "goalnet_msgs/msg/ObjectPoses.h"
#include "goalnet_msgs/msg/WorldState.h"
#include "sensor_msgs/msg/JointState.h"

namespace goalnet::manipulation {

// One thread. Messages that make no sense change nothing and are told.
class Perception {
 public:
  explicit Perception(const robot::RobotModel& model);

  Expected<void> take(const sensor_msgs::msg::JointState& message);
  Expected<void> take(const goalnet_msgs::msg::ObjectPoses& message);
  Expected<void> take(const goalnet_msgs::msg::WorldState& message);

  // Whether every joint of the robot, the objects and the facts have been heard of.
  bool complete() const { return robot_seen_ == view_.robot.size() && poses_seen_ && facts_seen_; }
  // As of now; `time_ns` is the reader's clock.
  const WorldView& view(std::int64_t time_ns) {
    view_.time_ns = time_ns;
    return view_;
  }

 private:
  std::map<std::string, std::size_t> robot_joints_;
  std::vector<bool> seen_;
  std::size_t robot_seen_ = 0;
  bool poses_seen_ = false;
  bool facts_seen_ = false;
  WorldView view_;
};

}  // namespace goalnet::manipulation
