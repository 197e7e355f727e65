// The planner as a ROS 2 node.
//
// In:  goal_predicates (goalnet_msgs/GoalPredicates), world_state (goalnet_msgs/WorldState, latched).
// Out: plan (goalnet_msgs/Plan): one for every goal that is not complete, from the newest world state; with
// an outcome
//      other than 0 and a message where there is no plan.
// A goal that comes before any world state waits for the first one. The same goal sent again is planned
// again.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <vector>

#include "components/planner/planner.h"
#include "components/ros/node.h"
#include "goalnet_msgs/msg/GoalPredicates.h"
#include "goalnet_msgs/msg/Plan.h"
#include "goalnet_msgs/msg/WorldState.h"

namespace goalnet::planner {

// Belongs to the thread of the node's event loop, but for interrupt().
class PlannerNode : public ros::Component {
 public:
  // Parameters: domain (PDDL file), node_limit (states; deterministic), time_limit (seconds of wall clock; a
  // far safety net). Fails with kInvalidRequest where one is wrong or the domain cannot be read.
  static Expected<std::unique_ptr<PlannerNode>> create(ros::Node& node);

  // From any thread: ends a search that runs, with kCancelled.
  void interrupt();

 private:
  PlannerNode(ros::Node& node, std::unique_ptr<const Domain> domain, const SolveOptions& options);
  void open_topics();
  void on_goal(const goalnet_msgs::msg::GoalPredicates& message);
  void on_world(const goalnet_msgs::msg::WorldState& message);
  void answer(const goalnet_msgs::msg::GoalPredicates& message);
  Expected<Plan> plan_for(const Goal& goal);

  ros::Node& node_;
  std::unique_ptr<const Domain> domain_;
  Planner planner_;
  SolveOptions options_;
  std::mutex stop_mutex_;  // guards stop_
  std::stop_source stop_;
  std::optional<WorldState> world_;
  std::optional<goalnet_msgs::msg::GoalPredicates> waiting_;
  std::shared_ptr<ros::Publisher<goalnet_msgs::msg::Plan>> plan_;
  std::shared_ptr<ros::Subscription<goalnet_msgs::msg::GoalPredicates>> goal_;
  std::shared_ptr<ros::Subscription<goalnet_msgs::msg::WorldState>> world_state_;
};

}  // namespace goalnet::planner
