#include "components/world_model/world_model_node.h"

#include <utility>

#include "components/world_model/world_model_parameters.h"

namespace goalnet::world_model {

Expected<std::unique_ptr<WorldModelNode>> WorldModelNode::create(ros::Node& node) {
  return ros::started(std::unique_ptr<WorldModelNode>(new WorldModelNode(node)));
}

WorldModelNode::WorldModelNode(ros::Node& node) : ManagedComponent(node) { describe(parameters_, params_); }

Expected<void> WorldModelNode::on_configure() {
  if (auto ok = check_thresholds(params_.session.core); !ok) return ok;
  auto scene = scene::load_scene(params_.scene);
  if (!scene) return tl::unexpected<Error>(std::move(scene.error()));
  auto robot = robot::load_robot(params_.robot.empty() ? "default" : params_.robot);
  if (!robot) return tl::unexpected<Error>(std::move(robot.error()));
  scene_.emplace(std::move(*scene));
  robot_.emplace(std::move(*robot));
  return {};
}

Expected<void> WorldModelNode::on_activate() {
  session_ = std::make_unique<WorldModelSession>(node_, *scene_, *robot_, params_.session);
  return {};
}

Expected<void> WorldModelNode::on_deactivate() {
  session_.reset();
  return {};
}

Expected<void> WorldModelNode::on_cleanup() {
  robot_.reset();
  scene_.reset();
  return {};
}

}  // namespace goalnet::world_model
