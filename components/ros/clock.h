// Time as a node sees it: the wall clock, or what /clock says where use_sim_time is set.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>

#include "builtin_interfaces/msg/Duration.h"
#include "builtin_interfaces/msg/Time.h"

namespace goalnet::ros {

// A moment in nanoseconds: since 1970 on a wall clock, since the simulation's start on a simulated one.
struct Time {
  std::int64_t nanoseconds = 0;

  Time() = default;
  explicit constexpr Time(std::int64_t ns) : nanoseconds(ns) {}
  explicit Time(const builtin_interfaces::msg::Time& message)
      : nanoseconds(std::int64_t{message.sec()} * 1'000'000'000 + message.nanosec()) {}

  double seconds() const { return static_cast<double>(nanoseconds) * 1e-9; }
  builtin_interfaces::msg::Time to_msg() const;
  operator builtin_interfaces::msg::Time() const { return to_msg(); }

  auto operator<=>(const Time&) const = default;
};

inline Time operator+(Time time, std::chrono::nanoseconds span) {
  return Time(time.nanoseconds + span.count());
}
inline std::chrono::nanoseconds operator-(Time a, Time b) {
  return std::chrono::nanoseconds(a.nanoseconds - b.nanoseconds);
}

builtin_interfaces::msg::Duration to_duration_msg(std::chrono::nanoseconds span);
std::chrono::nanoseconds from_duration_msg(const builtin_interfaces::msg::Duration& message);

// now() may be called from any thread; the rest from the loop's thread.
class Clock {
 public:
  // Wall clock (system_clock); 0 on a simulated clock before the first /clock message.
  Time now() const;

  bool simulated() const { return simulated_.load(std::memory_order_relaxed); }
  void use_simulated(bool simulated) { simulated_.store(simulated, std::memory_order_relaxed); }
  void set_simulated(Time now) { simulated_ns_.store(now.nanoseconds, std::memory_order_release); }

  // [ns] what timers count on: steady where time is real (it never jumps), else simulated time.
  std::int64_t timer_now() const;

 private:
  std::atomic<bool> simulated_{false};
  std::atomic<std::int64_t> simulated_ns_{0};
};

}  // namespace goalnet::ros
