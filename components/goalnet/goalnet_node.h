// The goal model as a ROS 2 node.
//
// In:  step_request (goalnet_msgs/StepRequest), world_state (goalnet_msgs/WorldState, latched).
// Out: goal_predicates (goalnet_msgs/GoalPredicates): one answer to every request; complete where nothing is
// left to do,
//      an outcome other than 0 and a message where the sentence means nothing here.
//      object_poses (goalnet_msgs/ObjectPoses), joint_states (sensor_msgs/JointState; base_x and base_y):
//      optional; with them the nearest of several equal things is taken, measured when the instruction comes.
// A request waits for a world state that is not older than its stamp. The same request sent again gets the
// same answer. Step 0, or another instruction id, begins a new history.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "components/goalnet/goal_model.h"
#include "components/ros/log_limit.h"
#include "components/ros/managed_component.h"
#include "goalnet_msgs/msg/GoalPredicates.h"
#include "goalnet_msgs/msg/ObjectPoses.h"
#include "goalnet_msgs/msg/StepRequest.h"
#include "goalnet_msgs/msg/WorldState.h"
#include "sensor_msgs/msg/JointState.h"

namespace goalnet::inference {

// Belongs to the thread of the node's event loop.
class GoalnetNode : public ros::ManagedComponent {
 public:
  struct Params {
    std::string model = "goalnet";
  };
  static void describe(ros::ParameterSet& set, Params& params);

  // As managed_component.h: active already where autostart says so. Fails with kInvalidRequest where the
  // model cannot be loaded.
  static Expected<std::unique_ptr<GoalnetNode>> create(ros::Node& node);

 private:
  explicit GoalnetNode(ros::Node& node);
  Expected<void> on_configure() override;
  Expected<void> on_activate() override;
  Expected<void> on_deactivate() override;
  Expected<void> on_cleanup() override;
  void on_request(const goalnet_msgs::msg::StepRequest& message);
  void on_world(const goalnet_msgs::msg::WorldState& message);
  void on_poses(const goalnet_msgs::msg::ObjectPoses& message);
  void on_joints(const sensor_msgs::msg::JointState& message);
  std::map<std::string, double> distances() const;
  bool world_is_new_enough(const goalnet_msgs::msg::StepRequest& message) const;
  void answer(const goalnet_msgs::msg::StepRequest& message);

  Params params_;
  std::unique_ptr<GoalModel> model_;  // from configure on

  // While active.
  std::optional<WorldState> world_;
  std::int64_t world_stamp_ = 0;  // [ns]
  std::optional<goalnet_msgs::msg::StepRequest> waiting_;
  std::optional<goalnet_msgs::msg::GoalPredicates> last_answer_;

  // Of the instruction under way: the worlds seen and the goals inferred, one each a step.
  std::vector<WorldState> states_;
  std::vector<Goal> goals_;
  std::map<std::string, double> distances_;  // when it came [m]; empty: unknown

  std::map<std::string, std::array<double, 2>> positions_;  // of things in the map [m]
  std::optional<double> base_x_, base_y_;                   // of the robot in the map [m]
  ros::LogLimit bad_worlds_;

  std::shared_ptr<ros::Publisher<goalnet_msgs::msg::GoalPredicates>> goal_predicates_;
  std::shared_ptr<ros::Subscription<goalnet_msgs::msg::StepRequest>> request_;
  std::shared_ptr<ros::Subscription<goalnet_msgs::msg::WorldState>> world_state_;
  std::shared_ptr<ros::Subscription<goalnet_msgs::msg::ObjectPoses>> object_poses_;
  std::shared_ptr<ros::Subscription<sensor_msgs::msg::JointState>> joint_states_;
};

}  // namespace goalnet::inference
