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
  auto scene = scene::load_scene(params_.scene);
  if (!scene) return tl::unexpected<Error>(std::move(scene.error()));
  auto robot = robot::load_robot(params_.robot.empty() ? "default" : params_.robot);
  if (!robot) return tl::unexpected<Error>(std::move(robot.error()));
  scene_.emplace(std::move(*scene));
  robot_.emplace(std::move(*robot));
  return {};
}

Expected<void> VisualizationNode::on_activate() {
  session_ = std::make_unique<VisualizationSession>(node_, *scene_, *robot_, params_.rate);
  return {};
}

Expected<void> VisualizationNode::on_deactivate() {
  session_.reset();
  return {};
}

Expected<void> VisualizationNode::on_cleanup() {
  robot_.reset();
  scene_.reset();
  return {};
}

}  // namespace goalnet::visualization
