// The real-time heart of the robot: follows trajectories within limits, stops smoothly, and never surprises.
//
// One object, two threads:
// - cycle() is called from the real-time thread (or from the simulator, in lockstep), once per period. It
// never
//   blocks, allocates, locks, logs or makes a system call, and its result depends only on its arguments and
//   on what was submitted before: the same calls give the same bits.
// - submit(), stop(), reset() and status() are called from one other thread (the same thread is fine in
// lockstep).
//   emergency_stop() may be called from any thread.
// The two sides share lock-free exchanges only; trajectories are allocated and freed on the other thread.
#pragma once

#include <cstdint>
#include <memory>

#include "components/core/outcome.h"
#include "executor/executor_params.h"
#include "executor/executor_status.h"
#include "executor/joint_sample.h"
#include "executor/joint_trajectory.h"

namespace goalnet::executor {

class TrajectoryExecutor {
 public:
  // Fails with kInvalidRequest for no joints, too many, doubled names, or limits that are not positive and
  // finite.
  static Expected<std::unique_ptr<TrajectoryExecutor>> create(ExecutorParams params);
  ~TrajectoryExecutor();
  TrajectoryExecutor(const TrajectoryExecutor&) = delete;
  TrajectoryExecutor& operator=(const TrajectoryExecutor&) = delete;

  // Real-time thread. `time_ns` never goes back. `measured` is where the joints are; `command` receives where
  // they should be at the end of this period. Until the first finite measurement the command repeats
  // `measured`.
  void cycle(std::int64_t time_ns, const JointSample& measured, JointSample& command) noexcept;

  // Other thread. Checks the trajectory (names, sizes, finite numbers, times, limits, standstill at the end)
  // and hands it over; it replaces the one that runs, without a jump. Returns its id. Fails with
  // kInvalidRequest, or with kBusy when the loop takes nothing (stopped, or not running). The loop itself may
  // still refuse it, because it starts elsewhere or because of a stop or fault meanwhile: see status().
  Expected<std::uint64_t> submit(const JointTrajectory& trajectory);

  // A joint that does not follow (tracking or goal tolerance) ends the trajectory as kMotionFailed: the robot
  // slows down along the path, then the command of the joints that are off returns smoothly to where they are
  // measured (GiveWay; state STOPPING), then it is IDLE: nothing presses against what blocks the joint,
  // nothing jumps when it comes free, and a trajectory from the measured position is accepted. The same
  // happens at the end of stop(), and when a standing joint is pushed farther away than its tracking
  // tolerance.

  // Other thread. Slows down along the path, within limits, to standstill; the trajectory ends as kCancelled.
  void stop();

  // Any thread. Brakes every joint as hard as its limits allow; then FAULT, as kEmergencyStop, until reset().
  void emergency_stop() noexcept;

  // Other thread. Leaves FAULT once the robot stands and is measured; the command restarts where the joints
  // are.
  void reset();

  // Other thread. The newest status; also frees trajectories that the loop has finished with.
  ExecutorStatus status();

  const ExecutorParams& params() const;

 private:
  struct Impl;
  explicit TrajectoryExecutor(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace goalnet::executor
