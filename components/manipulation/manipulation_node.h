// Manipulation as a managed ROS 2 node: symbolic actions become trajectories. What it hears and says:
// manipulation_session.h.
#pragma once

#include <memory>
#include <mutex>
#include <string>

#include "components/manipulation/manipulation_session.h"
#include "components/ros/managed_component.h"

namespace goalnet::manipulation {

// Belongs to the thread of the node's event loop, but for interrupt().
class ManipulationNode : public ros::ManagedComponent {
 public:
  struct Params {
    std::string scene = "kitchen";
    std::string robot = "default";
    ManipulationParams core;
  };
  static void describe(ros::ParameterSet& set, Params& params);

  // As managed_component.h: active already where autostart says so. Fails with kInvalidRequest where a
  // parameter is wrong or a file cannot be loaded.
  static Expected<std::unique_ptr<ManipulationNode>> create(ros::Node& node);

  // From any thread, while active: ends motion planning that runs, with kCancelled.
  void interrupt() override;

 private:
  explicit ManipulationNode(ros::Node& node);
  Expected<void> on_configure() override;
  Expected<void> on_activate() override;
  Expected<void> on_deactivate() override;
  Expected<void> on_cleanup() override;

  Params params_;
  std::unique_ptr<Workbench> bench_;              // from configure on
  std::mutex session_mutex_;                      // interrupt() may come while it is made or dropped
  std::unique_ptr<ManipulationSession> session_;  // while active
};

}  // namespace goalnet::manipulation
