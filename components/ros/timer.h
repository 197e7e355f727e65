// Calls back periodically on a node's clock: real time, or simulated time where the node uses it.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>

namespace goalnet::ros {

class Clock;
class EventLoop;

// Lives as long as its owner keeps the shared_ptr. Used from the loop's thread only.
class Timer {
 public:
  // `period` > 0. First call one period from now. A period that was missed (the loop was busy, time jumped)
  // is skipped, not made up for.
  static std::shared_ptr<Timer> create(EventLoop& loop, Clock& clock, std::chrono::nanoseconds period,
                                       std::function<void()> callback);

  void cancel() { active_ = false; }
  // Starts (again): next call one period from now.
  void reset();

 private:
  friend class EventLoop;
  Timer(Clock& clock, std::chrono::nanoseconds period, std::function<void()> callback);
  bool due();
  void fire();

  Clock& clock_;
  const std::int64_t period_;  // [ns]
  std::function<void()> callback_;
  std::int64_t next_ = 0;  // [ns] on clock_
  bool active_ = true;
};

}  // namespace goalnet::ros
