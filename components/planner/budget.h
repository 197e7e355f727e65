// When to stop: a deadline and a stop token, asked cheaply from inner loops.
//
// Every loop whose length grows with the problem asks, so that a search can be stopped at any time. What a
// stopped function answers means nothing: who calls one looks at stopped() before using the answer.
#pragma once

#include <chrono>
#include <cstdint>
#include <stop_token>

namespace goalnet::planner {

class Budget {
 public:
  using Clock = std::chrono::steady_clock;
  enum class Reason { kNone, kCancelled, kTime };

  Budget() = default;
  // A zero limit means none.
  Budget(std::stop_token stop, std::chrono::nanoseconds limit)
      : stop_(std::move(stop)), limited_(limit.count() > 0), deadline_(Clock::now() + limit) {}

  // Call in inner loops; looks at the clock once in 64 calls. True once it is time to stop.
  bool poll() {
    if (reason_ != Reason::kNone) return true;
    if ((++calls_ & 63u) != 0) return false;
    return check();
  }
  // Looks at once.
  bool check() {
    if (reason_ == Reason::kNone) {
      if (stop_.stop_requested()) {
        reason_ = Reason::kCancelled;
      } else if (limited_ && Clock::now() >= deadline_) {
        reason_ = Reason::kTime;
      }
    }
    return reason_ != Reason::kNone;
  }
  // What the last look said.
  bool stopped() const { return reason_ != Reason::kNone; }
  Reason reason() const { return reason_; }
  bool limited() const { return limited_; }
  Clock::time_point deadline() const { return deadline_; }
  const std::stop_token& stop_token() const { return stop_; }

 private:
  std::stop_token stop_;
  bool limited_ = false;
  Clock::time_point deadline_{};
  Reason reason_ = Reason::kNone;
  std::uint32_t calls_ = 0;
};

}  // namespace goalnet::planner
