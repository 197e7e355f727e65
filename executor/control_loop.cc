#include "executor/control_loop.h"

#include <algorithm>
#include <cmath>

namespace goalnet::executor {
namespace {

// After a stall the motion goes on where it was instead of jumping ahead: at most this many periods count.
constexpr std::int64_t kLongestStep = 4;

}  // namespace

ControlLoop::ControlLoop(const ExecutorParams& params, LoopExchange& exchange)
    : params_(params),
      exchange_(exchange),
      period_ns_(std::llround(1e9 * params.period)),
      guard_(params.joints),
      motion_(params.joints) {}

void ControlLoop::cycle(std::int64_t time_ns, const JointSample& measured, JointSample& command) noexcept {
  const std::int64_t dt_ns = elapsed_since_last(time_ns);
  take_measurement(time_ns, measured);
  if (!started_) {
    take_requests();
    exchange_.status.write(status_);
    return;
  }
  check_emergency_stop();
  take_requests();
  check_measurement(time_ns);
  check_tracking();
  move(dt_ns);
  check_arrival(dt_ns);
  command.position = guard_.command().position;
  command.velocity = guard_.command().velocity;
  command.time_ns = time_ns;
  exchange_.status.write(status_);
}

std::int64_t ControlLoop::elapsed_since_last(std::int64_t time_ns) noexcept {
  const bool first = status_.cycles++ == 0;
  const std::int64_t elapsed = first ? period_ns_ : std::max<std::int64_t>(0, time_ns - last_time_ns_);
  if (elapsed > period_ns_ + period_ns_ / 2) ++status_.overruns;
  last_time_ns_ = first ? time_ns : std::max(time_ns, last_time_ns_);
  return std::min(elapsed, kLongestStep * period_ns_);
}

void ControlLoop::take_measurement(std::int64_t time_ns, const JointSample& measured) noexcept {
  measured_now_ = true;
  for (std::size_t j = 0; j < params_.joints.size(); ++j)
    measured_now_ =
        measured_now_ && std::isfinite(measured.position[j]) && std::isfinite(measured.velocity[j]);
  if (!measured_now_) return;
  measured_ = measured;
  last_measured_ns_ = measured.time_ns == 0 ? time_ns : measured.time_ns;
  if (started_) return;
  started_ = true;
  hold_.position = measured.position;
  guard_.reset(measured);
}

void ControlLoop::take_requests() noexcept {
  LoopRequest request;
  while (exchange_.requests.pop(request)) {
    switch (request.kind) {
      case LoopRequest::Kind::kFollow:
        follow(request.trajectory);
        break;
      case LoopRequest::Kind::kStop:
        if (status_.state == ExecutorState::kExecuting)
          begin_stop({LoopReason::kStopped, 0, 0.0}, ExecutorState::kIdle);
        break;
      case LoopRequest::Kind::kReset:
        reset();
        break;
    }
  }
}

void ControlLoop::follow(PreparedTrajectory* trajectory) noexcept {
  const bool ready =
      started_ && (status_.state == ExecutorState::kIdle || status_.state == ExecutorState::kExecuting);
  if (!ready) return reject(trajectory, {LoopReason::kNotReady, 0, 0.0});
  const StartMismatch start = motion_.begin(*trajectory, guard_.command());
  if (start.mismatch)
    return reject(trajectory,
                  {LoopReason::kStartMismatch, static_cast<std::uint32_t>(start.joint), start.distance});
  if (trajectory_ != nullptr) hand_back(trajectory_);
  trajectory_ = trajectory;
  motion_ns_ = settling_ns_ = 0;
  guard_.rebase_target();
  status_.state = ExecutorState::kExecuting;
  status_.trajectory_id = trajectory->id;
  status_.trajectory_stamp_ns = trajectory->stamp_ns();
  status_.progress = 0.0;
  status_.verdict = {};
}

void ControlLoop::reject(PreparedTrajectory* trajectory, LoopVerdict verdict) noexcept {
  ++status_.rejections;
  status_.rejected_stamp_ns = trajectory->stamp_ns();
  status_.rejected = verdict;
  hand_back(trajectory);
}

void ControlLoop::reset() noexcept {
  if (status_.state != ExecutorState::kFault || !measured_now_ || !guard_.standing()) return;
  // A robot that was moved by hand must not jump back. Joints whose deviation is not checked (fingers,
  // pressing on what they grip) keep their command, and so their force.
  hold_ = guard_.command();
  for (std::size_t j = 0; j < params_.joints.size(); ++j)
    if (params_.joints[j].tracking_tolerance > 0.0) hold_.position[j] = measured_.position[j];
  guard_.reset(hold_);
  braking_ = false;
  status_.state = ExecutorState::kIdle;
  status_.verdict = {};
}

void ControlLoop::check_emergency_stop() noexcept {
  const std::uint32_t pressed = exchange_.emergency_stops.load(std::memory_order_relaxed);
  if (pressed == emergency_stops_seen_) return;
  emergency_stops_seen_ = pressed;
  braking_ = true;
  finish(ExecutorState::kFault, {LoopReason::kEmergencyStop, 0, 0.0});
}

void ControlLoop::check_measurement(std::int64_t time_ns) noexcept {
  if (params_.measurement_timeout <= 0.0 || status_.state == ExecutorState::kFault) return;
  const double age = 1e-9 * static_cast<double>(time_ns - last_measured_ns_);
  if (age <= params_.measurement_timeout) return;
  if (status_.state == ExecutorState::kStopping) {  // stopping already: end as a fault
    stop_verdict_ = {LoopReason::kNoMeasurement, 0, age};
    after_stop_ = ExecutorState::kFault;
    return;
  }
  begin_stop({LoopReason::kNoMeasurement, 0, age}, ExecutorState::kFault);
}

void ControlLoop::check_tracking() noexcept {
  if (!measured_now_) return;
  const JointSample& command = guard_.command();
  double largest = -1.0;
  for (std::size_t j = 0; j < params_.joints.size(); ++j) {
    const double error = std::abs(measured_.position[j] - command.position[j]);
    if (error > largest) {
      largest = error;
      status_.tracking_joint = static_cast<std::uint32_t>(j);
    }
    const double tolerance = params_.joints[j].tracking_tolerance;
    if (tolerance <= 0.0 || error <= tolerance) continue;
    const LoopVerdict verdict{LoopReason::kTracking, static_cast<std::uint32_t>(j), error};
    if (status_.state == ExecutorState::kExecuting) begin_stop(verdict, ExecutorState::kIdle);
    // Pushed away while it stood: it does not press back for ever either.
    if (status_.state == ExecutorState::kIdle) end_motion(ExecutorState::kIdle, verdict);
  }
  status_.tracking_error = largest;
}

void ControlLoop::begin_stop(LoopVerdict verdict, ExecutorState after) noexcept {
  stop_verdict_ = verdict;
  after_stop_ = after;
  if (trajectory_ == nullptr) return finish(after, verdict);
  stop_.begin(motion_, motion_ns_, guard_.command(), params_.joints);
  status_.state = ExecutorState::kStopping;
}

void ControlLoop::move(std::int64_t dt_ns) noexcept {
  if (dt_ns == 0) return;
  const double dt = 1e-9 * static_cast<double>(dt_ns);
  if (braking_) {
    guard_.brake(dt);
    hold_.position = guard_.command().position;
    return;
  }
  JointSample target = hold_;
  if (giving_way_) {
    target = give_way_.advance(dt);
  } else if (trajectory_ != nullptr) {
    double rate = 1.0;
    if (status_.state == ExecutorState::kStopping) {
      motion_ns_ = stop_.advance(dt_ns);
      rate = stop_.rate();
    } else {
      motion_ns_ = std::min(motion_ns_ + dt_ns, motion_.end_ns());
    }
    motion_.evaluate(motion_ns_, target);
    for (std::size_t j = 0; j < params_.joints.size(); ++j) target.velocity[j] *= rate;
    const std::int64_t end = motion_.end_ns();
    status_.progress =
        end > 0 ? std::min(1.0, static_cast<double>(motion_ns_) / static_cast<double>(end)) : 1.0;
  }
  if (guard_.follow(dt, target)) ++status_.guarded_cycles;
}

void ControlLoop::check_arrival(std::int64_t dt_ns) noexcept {
  const bool caught_up = guard_.lag() == 0.0 && guard_.standing();
  if (giving_way_ && give_way_.finished() && caught_up) finish(after_stop_, stop_verdict_);
  if (trajectory_ == nullptr) return;
  if (status_.state == ExecutorState::kStopping) {
    if (stop_.finished() && caught_up) end_motion(after_stop_, stop_verdict_);
    return;
  }
  if (motion_ns_ < motion_.end_ns() || !caught_up) return;
  for (std::size_t j = 0; j < params_.joints.size(); ++j) {
    const double tolerance = params_.joints[j].goal_tolerance;
    const double error = std::abs(measured_.position[j] - guard_.command().position[j]);
    if (tolerance <= 0.0 || error <= tolerance) continue;
    settling_ns_ += dt_ns;
    if (1e-9 * static_cast<double>(settling_ns_) < params_.settle_time) return;
    return end_motion(ExecutorState::kIdle, {LoopReason::kGoalMissed, static_cast<std::uint32_t>(j), error});
  }
  finish(ExecutorState::kIdle, {LoopReason::kDone, 0, 0.0});
}

// The command stands. Where joints are far from it, it goes to them before the robot is idle: the next motion
// is planned from where they are.
void ControlLoop::end_motion(ExecutorState state, LoopVerdict verdict) noexcept {
  const bool far =
      state == ExecutorState::kIdle && give_way_.begin(guard_.command(), measured_, params_.joints);
  finish(far ? ExecutorState::kStopping : state, verdict);
  if (!far) return;
  giving_way_ = true;
  after_stop_ = state;
  stop_verdict_ = verdict;
}

void ControlLoop::finish(ExecutorState state, LoopVerdict verdict) noexcept {
  if (trajectory_ != nullptr) hand_back(trajectory_);
  trajectory_ = nullptr;
  giving_way_ = false;
  hold_.position = guard_.command().position;
  hold_.velocity.fill(0.0);
  status_.state = state;
  status_.verdict = verdict;
}

void ControlLoop::hand_back(PreparedTrajectory* trajectory) noexcept {
  exchange_.finished.push(trajectory);  // never full, see LoopExchange
}

}  // namespace goalnet::executor
