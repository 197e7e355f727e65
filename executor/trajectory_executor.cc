#include "executor/trajectory_executor.h"

#include <cmath>
#include <set>
#include <utility>

#include "executor/control_loop.h"
#include "executor/loop_exchange.h"

namespace goalnet::executor {
namespace {

std::string rounded(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", value);
  return text;
}

Outcome outcome_of(LoopReason reason) {
  switch (reason) {
    case LoopReason::kDone:
      return Outcome::kDone;
    case LoopReason::kStopped:
      return Outcome::kCancelled;
    case LoopReason::kStartMismatch:
      return Outcome::kInvalidRequest;
    case LoopReason::kNotReady:
      return Outcome::kBusy;
    case LoopReason::kTracking:
    case LoopReason::kGoalMissed:
      return Outcome::kMotionFailed;
    case LoopReason::kNoMeasurement:
      return Outcome::kWorldStale;
    case LoopReason::kEmergencyStop:
      return Outcome::kEmergencyStop;
  }
  return Outcome::kInternal;
}

std::string describe(const LoopVerdict& verdict, const ExecutorParams& params) {
  const std::string joint = "joint '" + params.joints[verdict.joint].name + "'";
  switch (verdict.reason) {
    case LoopReason::kDone:
      return "";
    case LoopReason::kStopped:
      return "stopped on request";
    case LoopReason::kStartMismatch:
      return "the trajectory starts " + rounded(verdict.value) + " away from the command of " + joint +
             "; plan from the current joint state, or leave time to get there";
    case LoopReason::kNotReady:
      return "the robot is stopping, in fault or not yet measured; wait until it is idle (after a fault: "
             "reset)";
    case LoopReason::kTracking:
      return joint + " was " + rounded(verdict.value) + " away from its command; is it blocked?";
    case LoopReason::kGoalMissed:
      return joint + " ended " + rounded(verdict.value) + " away from its goal; is it blocked?";
    case LoopReason::kNoMeasurement:
      return "no valid joint measurement for " + rounded(verdict.value) +
             " s; check joint_states, then send \"reset\" on the topic executor_command";
    case LoopReason::kEmergencyStop:
      return "emergency stop; when it is safe, send \"reset\" on the topic executor_command";
  }
  return "";
}

bool positive(double value) { return std::isfinite(value) && value > 0.0; }

Expected<void> check(const ExecutorParams& params) {
  const auto invalid = [](const std::string& what) {
    return fail(Outcome::kInvalidRequest, "executor: " + what);
  };
  if (params.joints.empty()) return invalid("the robot has no joints");
  if (params.joints.size() > kMaxJoints)
    return invalid(std::to_string(params.joints.size()) + " joints; at most " + std::to_string(kMaxJoints) +
                   " are supported (kMaxJoints)");
  if (!positive(params.period) || params.period > 1.0 || params.period < 1e-6)
    return invalid("the period must lie between a microsecond and a second");
  if (!std::isfinite(params.measurement_timeout) || !std::isfinite(params.settle_time))
    return invalid("the timeouts must be finite");
  std::set<std::string> names;
  for (const JointLimits& joint : params.joints) {
    const std::string where = "joint '" + joint.name + "': ";
    if (joint.name.empty() || !names.insert(joint.name).second)
      return invalid(where + "needs a name of its own");
    if (!(joint.position_min <= joint.position_max))
      return invalid(where + "position_min exceeds position_max");
    if (!positive(joint.velocity) || !positive(joint.acceleration))
      return invalid(where + "limits of velocity and acceleration must be positive and finite");
    if (!positive(joint.start_tolerance)) return invalid(where + "start_tolerance must be positive");
    if (!(joint.tracking_tolerance >= 0.0) || !(joint.goal_tolerance >= 0.0))
      return invalid(where + "tolerances must not be negative");
  }
  return {};
}

}  // namespace

struct TrajectoryExecutor::Impl {
  explicit Impl(ExecutorParams given) : params(std::move(given)), loop(params, exchange) {}

  // Frees what the loop has handed back. Other thread only.
  void collect() {
    PreparedTrajectory* finished = nullptr;
    while (exchange.finished.pop(finished)) {
      delete finished;
      --alive;
    }
  }

  bool request(LoopRequest::Kind kind, PreparedTrajectory* trajectory = nullptr) {
    return exchange.requests.push({kind, trajectory});
  }

  const ExecutorParams params;
  LoopExchange exchange;
  ControlLoop loop;
  // Other thread only:
  std::uint64_t last_id = 0;
  std::uint32_t alive = 0;  // trajectories handed to the loop and not yet freed
  LoopStatus last_status;
};

TrajectoryExecutor::TrajectoryExecutor(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

// The loop must have stopped calling cycle() by now; then this thread owns both sides.
TrajectoryExecutor::~TrajectoryExecutor() {
  LoopRequest request;
  while (impl_->exchange.requests.pop(request)) delete request.trajectory;
  delete impl_->loop.current();
  impl_->collect();
}

Expected<std::unique_ptr<TrajectoryExecutor>> TrajectoryExecutor::create(ExecutorParams params) {
  if (auto ok = check(params); !ok) return tl::unexpected(ok.error());
  return std::unique_ptr<TrajectoryExecutor>(
      new TrajectoryExecutor(std::make_unique<Impl>(std::move(params))));
}

void TrajectoryExecutor::cycle(std::int64_t time_ns, const JointSample& measured,
                               JointSample& command) noexcept {
  impl_->loop.cycle(time_ns, measured, command);
}

Expected<std::uint64_t> TrajectoryExecutor::submit(const JointTrajectory& trajectory) {
  auto prepared = PreparedTrajectory::prepare(trajectory, impl_->params);
  if (!prepared) return tl::unexpected(prepared.error());
  impl_->collect();
  (*prepared)->id = impl_->last_id + 1;
  if (impl_->alive >= LoopExchange::kRequests || !impl_->request(LoopRequest::Kind::kFollow, prepared->get()))
    return fail(Outcome::kBusy, "the executor takes no more trajectories; is its loop running?");
  ++impl_->alive;
  prepared->release();
  return ++impl_->last_id;
}

void TrajectoryExecutor::stop() {
  // With a full ring the loop is dead or drowned in requests; then the emergency stop is the one that surely
  // arrives.
  if (!impl_->request(LoopRequest::Kind::kStop)) emergency_stop();
}

void TrajectoryExecutor::emergency_stop() noexcept {
  impl_->exchange.emergency_stops.fetch_add(1, std::memory_order_relaxed);
}

void TrajectoryExecutor::reset() { impl_->request(LoopRequest::Kind::kReset); }

ExecutorStatus TrajectoryExecutor::status() {
  impl_->collect();
  impl_->exchange.status.read(impl_->last_status);
  const LoopStatus& loop = impl_->last_status;
  ExecutorStatus status;
  status.state = loop.state;
  status.trajectory_id = loop.trajectory_id;
  status.trajectory_stamp_ns = loop.trajectory_stamp_ns;
  status.progress = loop.progress;
  status.tracking_error = loop.tracking_error;
  status.tracking_joint = impl_->params.joints[loop.tracking_joint].name;
  status.cycles = loop.cycles;
  status.overruns = loop.overruns;
  status.guarded_cycles = loop.guarded_cycles;
  status.outcome = outcome_of(loop.verdict.reason);
  status.message = describe(loop.verdict, impl_->params);
  status.rejections = loop.rejections;
  status.rejected_stamp_ns = loop.rejected_stamp_ns;
  status.rejected_outcome = outcome_of(loop.rejected.reason);
  if (loop.rejections > 0) status.rejected_message = describe(loop.rejected, impl_->params);
  return status;
}

const ExecutorParams& TrajectoryExecutor::params() const { return impl_->params; }

}  // namespace goalnet::executor
