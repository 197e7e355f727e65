#include "components/manipulation/manipulation_node.h"

#include <utility>

#include "components/setting/setting.h"

namespace goalnet::manipulation {

void ManipulationNode::describe(ros::ParameterSet& set, Params& params) {
  set.text("scene", params.scene, "room to move in", "a name in config/scenes or a file");
  set.text("robot", params.robot, "robot that moves", "a name in config/robots or a file");
  set.number("speed", params.core.speed, "part of the joints' velocity limits that is used", 0.05, 1.0);
  set.number("acceleration", params.core.acceleration, "the same of their acceleration limits", 0.05, 1.0);
  set.number("margin", params.core.margin, "distance kept from obstacles in free motion [m]", 0.0, 0.1);
  set.whole("attempts", params.core.attempts, "different ways tried before an action fails", 1, 100);
}

Expected<std::unique_ptr<ManipulationNode>> ManipulationNode::create(ros::Node& node) {
  return ros::started(std::unique_ptr<ManipulationNode>(new ManipulationNode(node)));
}

ManipulationNode::ManipulationNode(ros::Node& node) : ManagedComponent(node) {
  describe(parameters_, params_);
}

void ManipulationNode::interrupt() {
  const std::lock_guard lock(session_mutex_);
  if (session_) session_->interrupt();
}

Expected<void> ManipulationNode::on_configure() {
  auto setting = load_setting(params_.scene, params_.robot);
  if (!setting) return tl::unexpected<Error>(std::move(setting.error()));
  auto bench = Workbench::create(std::move(setting->robot), std::move(setting->scene), params_.core);
  if (!bench) return tl::unexpected<Error>(std::move(bench.error()));
  bench_ = std::move(*bench);
  return {};
}

Expected<void> ManipulationNode::on_activate() {
  auto session = std::make_unique<ManipulationSession>(node_, *bench_);
  const std::lock_guard lock(session_mutex_);
  session_ = std::move(session);
  return {};
}

Expected<void> ManipulationNode::on_deactivate() {
  if (session_) session_->leave();
  std::unique_ptr<ManipulationSession> gone;
  const std::lock_guard lock(session_mutex_);
  gone = std::move(session_);
  return {};
}

Expected<void> ManipulationNode::on_cleanup() {
  bench_.reset();
  return {};
}

}  // namespace goalnet::manipulation
