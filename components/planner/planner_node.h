// The planner as a ROS 2 node.
//
// In:  goal_predicates (goalnet_msgs/GoalPredicates), world_state (goalnet_msgs/WorldState, latched),
// cancel_instruction
//      (goalnet_msgs/CancelInstruction: ends a search at once).
// Out: plan (goalnet_msgs/Plan): one for every goal that is not complete, from the newest world state; with
// an outcome
//      other than 0 and a message where there is no plan.
// A goal that comes before any world state waits for the first one. The same goal sent again is planned
// again. A newer goal ends the search for the one before it, which is answered with "cancelled"; not where
// both are for the same step of the same instruction, because that answer could be taken for the newer one's.
//
// A search has a thread of its own, so that the event loop goes on: parameters, lifecycle, newer worlds and
// goals. With the parameter lockstep it runs in the event loop instead, and simulated time stands still
// meanwhile (docs/design/001); then a cancel, a newer goal and interrupt() reach it from outside.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <tuple>
#include <vector>

#include "components/planner/planner.h"
#include "components/ros/log_limit.h"
#include "components/ros/managed_component.h"
#include "goalnet_msgs/msg/CancelInstruction.h"
#include "goalnet_msgs/msg/GoalPredicates.h"
#include "goalnet_msgs/msg/Plan.h"
#include "goalnet_msgs/msg/WorldState.h"

namespace goalnet::planner {

// Belongs to the thread of the node's event loop, but for interrupt(). While a search runs in its own thread,
// planner_ belongs to that.
class PlannerNode : public ros::ManagedComponent {
 public:
  struct Params {
    std::string domain = "household";
    std::int64_t node_limit = 100'000;  // states; deterministic
    double time_limit = 10.0;           // [s] of wall clock; a far safety net
    bool lockstep = false;              // search in the event loop
  };
  static void describe(ros::ParameterSet& set, Params& params);

  // As managed_component.h: active already where autostart says so. Fails with kInvalidRequest where a
  // parameter is wrong or the domain cannot be read.
  static Expected<std::unique_ptr<PlannerNode>> create(ros::Node& node);

  // From any thread: ends a search that runs, with kCancelled.
  void interrupt() override;

  ~PlannerNode() override;

 private:
  struct Search {
    goalnet_msgs::msg::GoalPredicates message;  // that asked for it
    Expected<Plan> plan = Plan{};               // once it is done
  };
  explicit PlannerNode(ros::Node& node);
  Expected<void> on_configure() override;
  Expected<void> on_activate() override;
  Expected<void> on_deactivate() override;
  Expected<void> on_cleanup() override;
  void on_cancel(const goalnet_msgs::msg::CancelInstruction& message);
  void on_newer(const goalnet_msgs::msg::GoalPredicates& message);
  void on_goal(const goalnet_msgs::msg::GoalPredicates& message);
  void on_world(const goalnet_msgs::msg::WorldState& message);
  void wait(const goalnet_msgs::msg::GoalPredicates& message);
  void start(const goalnet_msgs::msg::GoalPredicates& message);
  std::stop_token note_current(const goalnet_msgs::msg::GoalPredicates& message);
  Expected<Plan> plan_for(const goalnet_msgs::msg::GoalPredicates& message, WorldState state,
                          const SolveOptions& options);
  void finish(const Search& search);
  void stop_searching();

  Params params_;
  // From configure on.
  std::unique_ptr<const Domain> domain_;
  std::optional<Planner> planner_;
  // While active.
  // Which goal this is: instruction, step and when it was inferred.
  using GoalKey = std::tuple<std::uint64_t, std::uint32_t, std::int32_t, std::uint32_t>;
  static GoalKey key_of(const goalnet_msgs::msg::GoalPredicates& message);

  std::mutex stop_mutex_;  // guards the next six: cancels and newer goals come from a thread of DDS
  GoalKey newest_{};       // that has arrived; its turn in the loop may still come
  GoalKey current_{};      // that is planned for now
  std::stop_source stop_;
  std::uint64_t instruction_ = 0;             // that is planned for now
  std::array<std::uint64_t, 8> cancelled_{};  // the last ones that nobody wants a plan for any more
  std::size_t next_cancelled_ = 0;
  ros::LogLimit bad_worlds_;
  std::optional<WorldState> world_;
  std::optional<goalnet_msgs::msg::GoalPredicates> waiting_;  // for a world, or for the search to end
  std::shared_ptr<Search> search_;                            // that runs in thread_
  std::jthread thread_;
  std::shared_ptr<ros::Publisher<goalnet_msgs::msg::Plan>> plan_;
  std::shared_ptr<ros::Subscription<goalnet_msgs::msg::GoalPredicates>> goal_;
  std::shared_ptr<ros::Subscription<goalnet_msgs::msg::WorldState>> world_state_;
  std::shared_ptr<ros::Subscription<goalnet_msgs::msg::CancelInstruction>> cancel_;
};

}  // namespace goalnet::planner
