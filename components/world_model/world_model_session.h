// The world model while it is active.
//
// In:  object_poses (goalnet_msgs/ObjectPoses), joint_states (sensor_msgs/JointState, robot and fixtures),
//      object_states (goalnet_msgs/ObjectStates, latched).
// Out: world_state (goalnet_msgs/WorldState, latched), on change and at 10 Hz. header.stamp is the moment
// observed. When observations stop coming, nothing is published: an old world is never passed off as a new
// one, and the log says what is missing.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "components/core/outcome.h"
#include "components/robot/robot_model.h"
#include "components/ros/diagnostics.h"
#include "components/ros/log_limit.h"
#include "components/ros/node.h"
#include "components/scene/scene.h"
#include "components/world_model/world_model.h"
#include "goalnet_msgs/msg/ObjectPoses.h"
#include "goalnet_msgs/msg/ObjectStates.h"
#include "goalnet_msgs/msg/WorldState.h"
#include "sensor_msgs/msg/JointState.h"

namespace goalnet::world_model {

struct SessionParams {
  Params core;
  double rate = 20.0;        // [Hz] how often facts are computed at most
  double stale_after = 0.5;  // [s] age of an observation that counts as lost
};

// Belongs to the thread of the node's event loop.
class WorldModelSession {
 public:
  // Opens the topics. All must outlive the session.
  WorldModelSession(ros::Node& node, const scene::Scene& scene, const robot::RobotModel& robot,
                    const SessionParams& params);

  // Whether the world is known, and how old what was seen is.
  void diagnose(ros::DiagnosticReport& report) const;

 private:
  void open_topics();
  void on_poses(const goalnet_msgs::msg::ObjectPoses& message);
  void on_joints(const sensor_msgs::msg::JointState& message);
  void on_states(const goalnet_msgs::msg::ObjectStates& message);
  void update();
  void publish_regularly();
  void publish();
  void watch_for_silence();
  void start_over_if_time_jumped_back(std::int64_t last_ns, std::int64_t time_ns);
  void report_ignored(const char* topic, std::size_t count);

  ros::Node& node_;
  const scene::Scene& scene_;
  const robot::RobotModel& robot_;
  const SessionParams& params_;
  std::unique_ptr<WorldModel> model_;
  std::vector<ObservedState> states_;  // the last, for a model that starts over
  std::int64_t opened_ns_ = 0;         // when this session began
  std::int64_t poses_ns_ = 0, joints_ns_ = 0;
  std::optional<std::int64_t> computed_ns_;
  std::optional<WorldState> published_;
  std::int64_t published_ns_ = 0;  // stamp of what was published last
  std::optional<std::int64_t> stale_reported_ns_;
  std::uint64_t ignored_reports_ = 0;
  ros::LogLimit jumps_;
  std::uint64_t observations_ = 0, observations_before_ = 0;  // counted by watch_for_silence()
  bool silence_reported_ = false;

  std::shared_ptr<ros::Publisher<goalnet_msgs::msg::WorldState>> publisher_;
  std::shared_ptr<ros::Subscription<goalnet_msgs::msg::ObjectPoses>> poses_;
  std::shared_ptr<ros::Subscription<sensor_msgs::msg::JointState>> joints_;
  std::shared_ptr<ros::Subscription<goalnet_msgs::msg::ObjectStates>> object_states_;
  ros::Clock wall_clock_;
  std::shared_ptr<ros::Timer> timer_, silence_timer_;
};

}  // namespace goalnet::world_model
