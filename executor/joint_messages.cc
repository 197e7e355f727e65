#include "executor/joint_messages.h"

#include <algorithm>
#include <cmath>

#include "components/messages/conversions.h"

namespace goalnet::executor {

JointTrajectory from_message(const trajectory_msgs::msg::JointTrajectory& message) {
  JointTrajectory trajectory;
  trajectory.stamp_ns = messages::to_nanoseconds(message.header().stamp());
  trajectory.joints = message.joint_names();
  trajectory.points.reserve(message.points().size());
  for (const auto& point : message.points()) {
    const std::int64_t time_ns =
        std::int64_t{point.time_from_start().sec()} * 1'000'000'000 + point.time_from_start().nanosec();
    trajectory.points.push_back({time_ns, point.positions(), point.velocities()});
  }
  return trajectory;
}

JointStateReader::JointStateReader(const std::vector<JointLimits>& joints) : heard_(joints.size(), 0) {
  for (std::size_t i = 0; i < joints.size(); ++i) indices_[joints[i].name] = i;
}

Expected<void> JointStateReader::read(const sensor_msgs::msg::JointState& message, std::int64_t time_ns) {
  const auto& names = message.name();
  const auto& positions = message.position();
  const auto& velocities = message.velocity();
  if (positions.size() != names.size() || (!velocities.empty() && velocities.size() != names.size()))
    return fail(Outcome::kInvalidRequest, "joint state refused: " + std::to_string(names.size()) +
                                              " names, " + std::to_string(positions.size()) + " positions, " +
                                              std::to_string(velocities.size()) + " velocities");
  JointSample sample = sample_;
  std::vector<std::size_t> updated;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto found = indices_.find(names[i]);
    if (found == indices_.end()) continue;
    const double velocity = velocities.empty() ? 0.0 : velocities[i];
    if (!std::isfinite(positions[i]) || !std::isfinite(velocity))
      return fail(Outcome::kInvalidRequest, "joint state refused: '" + names[i] + "' is not a number");
    sample.position[found->second] = positions[i];
    sample.velocity[found->second] = velocity;
    updated.push_back(found->second);
  }
  sample_ = sample;
  for (const std::size_t joint : updated) {
    seen_ += heard_[joint] == 0 ? 1 : 0;
    heard_[joint] = time_ns;
  }
  sample_.time_ns = heard_.empty() ? time_ns : *std::min_element(heard_.begin(), heard_.end());
  return {};
}

sensor_msgs::msg::JointState to_message(const JointSample& sample, const std::vector<JointLimits>& joints) {
  sensor_msgs::msg::JointState message;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    message.name().push_back(joints[i].name);
    message.position().push_back(sample.position[i]);
    message.velocity().push_back(sample.velocity[i]);
  }
  return message;
}

goalnet_msgs::msg::ExecutorStatus to_message(const ExecutorStatus& status) {
  goalnet_msgs::msg::ExecutorStatus message;
  message.state(static_cast<std::uint8_t>(status.state));
  message.trajectory_id(status.trajectory_id);
  message.trajectory_stamp(messages::to_stamp(status.trajectory_stamp_ns));
  message.progress(status.progress);
  message.tracking_error(status.tracking_error);
  message.cycles(status.cycles);
  message.overruns(status.overruns);
  message.outcome(static_cast<std::int32_t>(status.outcome));
  message.message(status.message);
  return message;
}

}  // namespace goalnet::executor
