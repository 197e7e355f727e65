// One moment of all joints, in the order of ExecutorParams::joints (the robot's actuated joints).
// Plain data of fixed size, so that it passes through lock-free exchanges and never touches the heap.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace goalnet::executor {

inline constexpr std::size_t kMaxJoints = 32;

struct JointSample {
  std::array<double, kMaxJoints> position{};  // [rad or m]; entries past the last joint are unused
  std::array<double, kMaxJoints> velocity{};  // [rad/s or m/s]
  // [ns] when this was measured, on the clock given to cycle(). 0 means "at this very cycle", which is what a
  // simulator in lockstep passes; a robot driver passes the real moment so that the watchdog can judge it.
  std::int64_t time_ns = 0;
};

}  // namespace goalnet::executor
