#include "executor/executor_node.h"

#include <algorithm>
#include <string>
#include <utility>

namespace goalnet::executor {

Expected<std::unique_ptr<ExecutorNode>> ExecutorNode::create(ros::Node& node) {
  return ros::started(std::unique_ptr<ExecutorNode>(new ExecutorNode(node)));
}

ExecutorNode::ExecutorNode(ros::Node& node) : ManagedComponent(node) { describe(parameters_, declared_); }

Expected<void> ExecutorNode::on_configure() {
  auto params = resolve(declared_);
  if (!params) return tl::unexpected<Error>(std::move(params.error()));
  // Limits that the core refuses are told now, not at activation.
  if (auto tried = TrajectoryExecutor::create(params->core); !tried)
    return tl::unexpected<Error>(tried.error());
  params_ = std::move(*params);
  return {};
}

Expected<void> ExecutorNode::on_activate() {
  auto executor = TrajectoryExecutor::create(params_->core);
  if (!executor) return tl::unexpected<Error>(executor.error());
  executor_ = std::move(*executor);
  session_ = std::make_unique<ExecutorSession>(node_, *params_, *executor_);
  return {};
}

Expected<void> ExecutorNode::on_deactivate() {
  if (session_) session_->leave();
  session_.reset();
  return {};
}

Expected<void> ExecutorNode::on_cleanup() {
  if (executor_ && params_ && params_->lockstep) {
    // In lockstep a stop goes on with the simulation.
    const ExecutorState state = executor_->status().state;
    if (state == ExecutorState::kStopping || state == ExecutorState::kExecuting)
      return fail(Outcome::kBusy, "the robot is still coming to rest; try again in a moment");
  }
  executor_.reset();
  params_.reset();
  return {};
}

void ExecutorNode::on_diagnose(ros::DiagnosticReport& report) {
  const ExecutorStatus status = executor_->status();
  // A few late cycles a second are an ordinary kernel; more and the motion is no longer as planned.
  const auto overruns = static_cast<double>(status.overruns - std::min(overruns_told_, status.overruns));
  overruns_told_ = status.overruns;
  report.threshold("late cycles a second", overruns, 10, 100, "");
  report.add("tracking error", std::to_string(status.tracking_error) + " (" + status.tracking_joint + ")");
  report.add("cycles", std::to_string(status.cycles));
  if (status.state == ExecutorState::kFault)
    report.summary(ros::DiagnosticLevel::kError, "fault: " + status.message);
}

ExecutorNode::Hook ExecutorNode::lockstep_hook() {
  return [this](std::int64_t time_ns, const JointSample& measured, JointSample& command) {
    if (executor_) return executor_->cycle(time_ns, measured, command);
    command.velocity = {};  // holds the last position
  };
}

}  // namespace goalnet::executor
