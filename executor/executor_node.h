// The executor as a managed ROS 2 node. What it hears and says: executor_session.h.
//
// Deactivating stops the robot smoothly; activating starts from where the joints are measured to be, whatever
// happened meanwhile, and out of any fault.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "components/ros/managed_component.h"
#include "executor/executor_parameters.h"
#include "executor/executor_session.h"
#include "executor/trajectory_executor.h"

namespace goalnet::executor {

// Belongs to the thread of the node's event loop; that thread is also the executor's "other thread".
class ExecutorNode : public ros::ManagedComponent {
 public:
  using Params = DeclaredParams;
  static void describe(ros::ParameterSet& set, Params& params);  // executor_parameters.cc

  // As managed_component.h: active already where autostart says so. Fails with kInvalidRequest where a
  // parameter is wrong or the robot cannot be loaded.
  static Expected<std::unique_ptr<ExecutorNode>> create(ros::Node& node);

  // What the simulator calls for every millisecond of simulated time; with the parameter lockstep only. Valid
  // as long as the node: while it is not active, the robot comes to rest and holds.
  using Hook = std::function<void(std::int64_t time_ns, const JointSample& measured, JointSample& command)>;
  Hook lockstep_hook();

 private:
  explicit ExecutorNode(ros::Node& node);
  Expected<void> on_configure() override;
  Expected<void> on_activate() override;
  Expected<void> on_deactivate() override;
  Expected<void> on_cleanup() override;
  void on_diagnose(ros::DiagnosticReport& report) override;

  Params declared_;
  std::optional<NodeParams> params_;  // from configure on
  std::unique_ptr<TrajectoryExecutor>
      executor_;  // from the first activation on: in lockstep it still brakes and holds
  std::unique_ptr<ExecutorSession> session_;  // while active
  std::uint64_t overruns_told_ = 0;           // by on_diagnose()
};

}  // namespace goalnet::executor
