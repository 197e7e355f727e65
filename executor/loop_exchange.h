// What the real-time loop and the rest of the program pass to each other: plain data through lock-free
// exchanges.
#pragma once

#include <atomic>
#include <cstdint>

#include "executor/executor_status.h"
#include "executor/prepared_trajectory.h"
#include "executor/spsc_ring.h"
#include "executor/triple_buffer.h"

namespace goalnet::executor {

struct LoopRequest {
  enum class Kind : std::uint8_t { kFollow, kStop, kReset };
  Kind kind = Kind::kStop;
  // kFollow: the loop owns it until it hands it back through `finished`.
  PreparedTrajectory* trajectory = nullptr;
};

// Why a trajectory ended, or was refused. Turned into words outside the loop.
enum class LoopReason : std::uint8_t {
  kDone,
  kStopped,        // stop()
  kStartMismatch,  // begins elsewhere
  kNotReady,       // stopping, in fault, or nothing measured yet
  kTracking,       // a joint does not follow
  kGoalMissed,     // a joint is not where it should be at the end
  kNoMeasurement,  // watchdog
  kEmergencyStop,
};

struct LoopVerdict {
  LoopReason reason = LoopReason::kDone;
  std::uint32_t joint = 0;
  double value = 0.0;  // [rad, m or s] by how much
};

struct LoopStatus {
  ExecutorState state = ExecutorState::kIdle;
  std::uint64_t trajectory_id = 0;
  std::int64_t trajectory_stamp_ns = 0;
  double progress = 0.0;
  double tracking_error = 0.0;
  std::uint32_t tracking_joint = 0;
  std::uint64_t cycles = 0;
  std::uint64_t overruns = 0;
  std::uint64_t guarded_cycles = 0;
  LoopVerdict verdict;
  std::uint64_t rejections = 0;
  std::int64_t rejected_stamp_ns = 0;
  LoopVerdict rejected;
};

struct LoopExchange {
  // Far fewer requests than this arrive in one period; if the ring fills up, the loop is not running.
  static constexpr std::uint32_t kRequests = 64;
  SpscRing<LoopRequest, kRequests> requests;
  // Twice as large: submit() never lets more than kRequests trajectories exist, so this ring is never full.
  SpscRing<PreparedTrajectory*, 2 * kRequests> finished;
  TripleBuffer<LoopStatus> status;
  // Counts presses instead of being a flag: a press that comes just as the last one is reset is not lost.
  std::atomic<std::uint32_t> emergency_stops{0};
};

}  // namespace goalnet::executor
