#include "components/visualization/visualization_node.h"

#include <utility>

namespace goalnet::visualization {

void VisualizationNode::describe(ros::ParameterSet& set, Params& params) {
  set.text("scene", params.scene, "room that is drawn", "a name in config/scenes or a file");
  set.text("robot", params.robot, "robot whose path is drawn", "a name in config/robots or a file");
  set.number("rate", params.rate, "how often markers are published at most [Hz]", 0.1, 100.0);
}

Expected<std::unique_ptr<VisualizationNode>> VisualizationNode::create(ros::Node& node) {
  return ros::started(std::unique_ptr<VisualizationNode>(new VisualizationNode(node)));
}

VisualizationNode::VisualizationNode(ros::Node& node) : ManagedComponent(node) {
  describe(parameters_, params_);
}

Expected<void> VisualizationNode::on_configure() {
  auto setting = load_setting(params_.scene, params_.robot);
  if (!setting) return tl::unexpected<Error>(std::move(setting.error()));
  setting_.emplace(std::move(*setting));
  return {};
}

Expected<void> VisualizationNode::on_activate() {
  session_ = std::make_unique<VisualizationSession>(node_, setting_->scene, setting_->robot, params_.rate);
  return {};
}

Expected<void> VisualizationNode::on_deactivate() {
  session_.reset();
  return {};
}

Expected<void> VisualizationNode::on_cleanup() {
  setting_.reset();
  return {};
}

}  // namespace goalnet::visualization
