#include "components/coordinator/coordinator_node.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "components/core/config_path.h"

namespace goalnet::coordinator {
namespace {

// Milliseconds since 1970: higher than any number of an instruction before a restart.
std::uint64_t number_from_the_clock() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::milliseconds>(now).count());
}

}  // namespace

Expected<std::unique_ptr<CoordinatorNode>> CoordinatorNode::create(ros::Node& node) {
  return ros::started(std::unique_ptr<CoordinatorNode>(new CoordinatorNode(node)));
}

CoordinatorNode::CoordinatorNode(ros::Node& node) : ManagedComponent(node) { describe(parameters_, params_); }

Expected<void> CoordinatorNode::on_configure() {
  auto domain = planner::load_domain(config_file("domains", params_.domain, ".pddl"));
  if (!domain) return tl::unexpected<Error>(std::move(domain.error()));
  params_.core.when_busy = params_.when_busy == "queue" ? WhenBusy::kQueue : WhenBusy::kRefuse;
  model_.emplace(std::move(*domain));
  return {};
}

Expected<void> CoordinatorNode::on_activate() {
  const std::uint64_t wanted = params_.first_id > 0 ? params_.first_id : number_from_the_clock();
  const std::uint64_t first = std::max(wanted, last_id_ + 1);
  session_ = std::make_unique<CoordinatorSession>(node_, params_.core, *model_, first);
  return {};
}

Expected<void> CoordinatorNode::on_deactivate() {
  if (session_) {
    session_->leave();
    last_id_ = session_->last_id();
  }
  session_.reset();
  return {};
}

Expected<void> CoordinatorNode::on_cleanup() {
  model_.reset();
  return {};
}

}  // namespace goalnet::coordinator
