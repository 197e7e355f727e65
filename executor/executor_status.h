// What the real-time loop is doing, as seen from other threads.
#pragma once

#include <cstdint>
#include <string>

#include "components/core/outcome.h"

namespace goalnet::executor {

// The values equal those of goalnet_msgs/ExecutorStatus.
enum class ExecutorState : std::uint8_t {
  kIdle = 0,       // holds its position
  kExecuting = 1,  // follows a trajectory
  kStopping = 2,   // comes to standstill, or gives way; takes no trajectory
  kFault = 3,      // holds; takes no trajectory until reset()
};

struct ExecutorStatus {
  ExecutorState state = ExecutorState::kIdle;
  std::uint64_t trajectory_id = 0;       // the last trajectory accepted; counts from 1
  std::int64_t trajectory_stamp_ns = 0;  // JointTrajectory::stamp_ns of it
  double progress = 0.0;                 // 0..1 of it
  double tracking_error = 0.0;           // [rad or m] largest deviation of a measured joint from its command
  std::string tracking_joint;            // the joint with that deviation
  std::uint64_t cycles = 0;              // since start
  std::uint64_t overruns = 0;            // cycles that came late by more than half a period
  std::uint64_t guarded_cycles = 0;      // cycles in which the limit guard changed a command
  Outcome outcome = Outcome::kDone;      // why the last trajectory ended
  std::string message;                   // what a person should read about it; empty for kDone
  // A trajectory refused by the loop (not by submit()) while another one runs does not disturb that one:
  std::uint64_t rejections = 0;        // how many so far
  std::int64_t rejected_stamp_ns = 0;  // the last of them
  Outcome rejected_outcome = Outcome::kDone;
  std::string rejected_message;
};

}  // namespace goalnet::executor
