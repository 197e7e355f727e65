// The coordinator as a managed ROS 2 node. What it hears and says: coordinator_session.h.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "components/coordinator/coordinator_parameters.h"
#include "components/coordinator/coordinator_session.h"
#include "components/coordinator/planner_action_model.h"
#include "components/ros/managed_component.h"

namespace goalnet::coordinator {

// Thread role: created and used in the node's event loop thread.
class CoordinatorNode : public ros::ManagedComponent {
 public:
  using Params = DeclaredParams;
  static void describe(ros::ParameterSet& set, Params& params);  // coordinator_parameters.cc

  // As managed_component.h: active already where autostart says so. Errors: kInvalidRequest for parameters or
  // a domain file that make no sense.
  static Expected<std::unique_ptr<CoordinatorNode>> create(ros::Node& node);

  // Stops what runs, as if asked through DDS.
  void cancel(const std::string& reason) {
    if (session_) session_->cancel(reason);
  }
  // As CoordinatorSession's; false while not active.
  bool connected() const { return session_ && session_->connected(); }

 private:
  explicit CoordinatorNode(ros::Node& node);
  Expected<void> on_configure() override;
  Expected<void> on_activate() override;
  Expected<void> on_deactivate() override;
  Expected<void> on_cleanup() override;

  Params params_;
  std::uint64_t last_id_ = 0;                    // of earlier sessions
  std::optional<PlannerActionModel> model_;      // from configure on
  std::unique_ptr<CoordinatorSession> session_;  // while active
};

}  // namespace goalnet::coordinator
