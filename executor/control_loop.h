// The real-time side of TrajectoryExecutor: what happens in each cycle, in order.
#pragma once

#include <cstdint>

#include "executor/executor_params.h"
#include "executor/give_way.h"
#include "executor/joint_sample.h"
#include "executor/limit_guard.h"
#include "executor/loop_exchange.h"
#include "executor/motion.h"
#include "executor/smooth_stop.h"

namespace goalnet::executor {

// Every member runs on the real-time thread and never allocates, blocks or makes a system call.
class ControlLoop {
 public:
  ControlLoop(const ExecutorParams& params, LoopExchange& exchange);
  void cycle(std::int64_t time_ns, const JointSample& measured, JointSample& command) noexcept;
  // After the last cycle: the trajectory that the loop still holds, or nothing.
  PreparedTrajectory* current() const { return trajectory_; }

 private:
  std::int64_t elapsed_since_last(std::int64_t time_ns) noexcept;
  void take_measurement(std::int64_t time_ns, const JointSample& measured) noexcept;
  void take_requests() noexcept;
  void follow(PreparedTrajectory* trajectory) noexcept;
  void reject(PreparedTrajectory* trajectory, LoopVerdict verdict) noexcept;
  void reset() noexcept;
  void check_emergency_stop() noexcept;
  void check_measurement(std::int64_t time_ns) noexcept;
  void check_tracking() noexcept;
  void begin_stop(LoopVerdict verdict, ExecutorState after) noexcept;
  void move(std::int64_t dt_ns) noexcept;
  void check_arrival(std::int64_t dt_ns) noexcept;
  void end_motion(ExecutorState state, LoopVerdict verdict) noexcept;
  void finish(ExecutorState state, LoopVerdict verdict) noexcept;
  void hand_back(PreparedTrajectory* trajectory) noexcept;

  const ExecutorParams& params_;
  LoopExchange& exchange_;
  const std::int64_t period_ns_;
  LimitGuard guard_;
  Motion motion_;
  SmoothStop stop_;
  GiveWay give_way_;

  PreparedTrajectory* trajectory_ = nullptr;  // followed now
  std::int64_t motion_ns_ = 0;                // how far along it
  std::int64_t settling_ns_ = 0;              // time since its end
  JointSample hold_;                          // where to stand without a trajectory
  JointSample measured_;                      // last finite measurement
  bool measured_now_ = false;                 // ... of this cycle
  bool started_ = false;                      // a first measurement has come
  bool giving_way_ = false;                   // the command goes to where the joints are; state STOPPING
  bool braking_ = false;                      // emergency stop: until reset()
  std::uint32_t emergency_stops_seen_ = 0;
  std::int64_t last_time_ns_ = 0;
  std::int64_t last_measured_ns_ = 0;
  LoopVerdict stop_verdict_;  // why it is stopping ...
  ExecutorState after_stop_ = ExecutorState::kIdle;
  LoopStatus status_;
};

}  // namespace goalnet::executor
