// The world model as a managed ROS 2 node. What it hears and says: world_model_session.h.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "components/ros/managed_component.h"
#include "components/setting/setting.h"
#include "components/world_model/world_model_session.h"

namespace goalnet::world_model {

// Belongs to the thread of the node's event loop.
class WorldModelNode : public ros::ManagedComponent {
 public:
  struct Params {
    std::string scene = "kitchen";
    std::string robot = "default";
    SessionParams session;
  };
  static void describe(ros::ParameterSet& set, Params& params);  // world_model_parameters.cc

  // As managed_component.h: active already where autostart says so. Fails with kInvalidRequest where a
  // parameter is wrong or the scene or robot cannot be loaded.
  static Expected<std::unique_ptr<WorldModelNode>> create(ros::Node& node);

 private:
  explicit WorldModelNode(ros::Node& node);
  Expected<void> on_configure() override;
  Expected<void> on_activate() override;
  Expected<void> on_deactivate() override;
  Expected<void> on_cleanup() override;
  void on_diagnose(ros::DiagnosticReport& report) override { session_->diagnose(report); }

  Params params_;
  // From configure on.
  std::optional<Setting> setting_;
  // While active.
  std::unique_ptr<WorldModelSession> session_;
};

}  // namespace goalnet::world_model
