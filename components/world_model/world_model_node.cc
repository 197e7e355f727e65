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
  auto setting = load_setting(params_.scene, params_.robot);
  if (!setting) return tl::unexpected<Error>(std::move(setting.error()));
  setting_.emplace(std::move(*setting));
  return {};
}

Expected<void> WorldModelNode::on_activate() {
  session_ = std::make_unique<WorldModelSession>(node_, setting_->scene, setting_->robot, params_.session);
  return {};
}

Expected<void> WorldModelNode::on_deactivate() {
  session_.reset();
  return {};
}

Expected<void> WorldModelNode::on_cleanup() {
  setting_.reset();
  return {};
}

}  // namespace goalnet::world_model
