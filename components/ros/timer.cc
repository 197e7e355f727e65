#include "components/ros/timer.h"

#include <algorithm>

#include "components/ros/clock.h"
#include "components/ros/event_loop.h"

namespace goalnet::ros {

Timer::Timer(Clock& clock, std::chrono::nanoseconds period, std::function<void()> callback)
    : clock_(clock), period_(std::max<std::int64_t>(period.count(), 1)), callback_(std::move(callback)) {
  reset();
}

std::shared_ptr<Timer> Timer::create(EventLoop& loop, Clock& clock, std::chrono::nanoseconds period,
                                     std::function<void()> callback) {
  std::shared_ptr<Timer> timer(new Timer(clock, period, std::move(callback)));
  loop.add(timer);
  return timer;
}

void Timer::reset() {
  next_ = clock_.timer_now() + period_;
  active_ = true;
}

bool Timer::due() {
  const std::int64_t now = clock_.timer_now();
  // Simulated time that jumped back (a simulator started anew) must not silence us until it is where it was.
  if (next_ - now > period_) next_ = now + period_;
  return active_ && now >= next_;
}

void Timer::fire() {
  next_ += period_;
  const std::int64_t now = clock_.timer_now();
  if (next_ <= now) next_ += (now - next_) / period_ * period_ + period_;
  callback_();
}

}  // namespace goalnet::ros
