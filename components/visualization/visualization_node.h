// Visualization as a managed ROS 2 node. What it hears and says: visualization_session.h.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "components/ros/managed_component.h"
#include "components/setting/setting.h"
#include "components/visualization/visualization_session.h"

namespace goalnet::visualization {

// Belongs to the thread of the node's event loop.
class VisualizationNode : public ros::ManagedComponent {
 public:
  struct Params {
    std::string scene = "kitchen";
    std::string robot = "default";
    double rate = 10.0;  // [Hz]
  };
  static void describe(ros::ParameterSet& set, Params& params);

  // As managed_component.h: active already where autostart says so. Fails with kInvalidRequest where a
  // parameter is wrong or a file cannot be loaded.
  static Expected<std::unique_ptr<VisualizationNode>> create(ros::Node& node);

 private:
  explicit VisualizationNode(ros::Node& node);
  Expected<void> on_configure() override;
  Expected<void> on_activate() override;
  Expected<void> on_deactivate() override;
  Expected<void> on_cleanup() override;

  Params params_;
  // From configure on.
  std::optional<Setting> setting_;
  // While active.
  std::unique_ptr<VisualizationSession> session_;
};

}  // namespace goalnet::visualization
