#include "components/ros/event_loop.h"

#include <algorithm>

#include "components/ros/clock.h"
#include "components/ros/timer.h"

namespace goalnet::ros {
namespace {

// Sleeping longer than this gains nothing; it also bounds the harm of a missed wake-up.
constexpr std::chrono::nanoseconds kLongestSleep = std::chrono::milliseconds(100);

}  // namespace

bool EventLoop::post(std::function<void()> callback) {
  {
    std::lock_guard lock(mutex_);
    if (queue_.size() >= capacity_) return false;
    queue_.push_back(std::move(callback));
  }
  changed_.notify_one();
  return true;
}

bool EventLoop::run_pending() {
  bool ran = false;
  std::unique_lock lock(mutex_);
  // What a callback posts is for the next round: timers come first.
  for (std::size_t left = queue_.size(); left > 0 && !queue_.empty(); --left) {
    auto callback = std::move(queue_.front());
    queue_.pop_front();
    lock.unlock();
    callback();
    callback = nullptr;  // what it holds may be large, and may post when it ends
    ran = true;
    lock.lock();
  }
  lock.unlock();
  return run_due_timers() || ran;
}

void EventLoop::run() {
  while (true) {
    run_pending();
    const auto sleep = until_next_timer();
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, sleep, [this] { return stop_ || woken_ || !queue_.empty(); });
    woken_ = false;
    if (stop_) {
      stop_ = false;
      return;
    }
  }
}

bool EventLoop::run_for(std::chrono::nanoseconds limit, const std::function<bool()>& done) {
  const auto end = std::chrono::steady_clock::now() + limit;
  while (true) {
    run_pending();
    if (done && done()) return true;
    const auto left = end - std::chrono::steady_clock::now();
    if (left <= std::chrono::nanoseconds(0)) return false;
    const auto sleep =
        std::min<std::chrono::nanoseconds>({until_next_timer(), left, std::chrono::milliseconds(5)});
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, sleep, [this] { return stop_ || woken_ || !queue_.empty(); });
    woken_ = false;
    if (stop_) {
      stop_ = false;
      return false;
    }
  }
}

void EventLoop::stop() {
  {
    std::lock_guard lock(mutex_);
    stop_ = true;
  }
  changed_.notify_all();
}

void EventLoop::wake() {
  {
    std::lock_guard lock(mutex_);
    woken_ = true;
  }
  changed_.notify_all();
}

void EventLoop::add(const std::shared_ptr<Timer>& timer) {
  std::erase_if(timers_, [](const auto& weak) { return weak.expired(); });
  timers_.push_back(timer);
}

bool EventLoop::run_due_timers() {
  // A callback may create or drop timers: work on a copy.
  std::vector<std::shared_ptr<Timer>> due;
  for (const auto& weak : timers_) {
    auto timer = weak.lock();
    if (timer && timer->due()) due.push_back(std::move(timer));
  }
  std::stable_sort(due.begin(), due.end(), [](const auto& a, const auto& b) { return a->next_ < b->next_; });
  bool ran = false;
  for (const auto& timer : due) {
    if (!timer->due()) continue;  // cancelled by one that ran before it
    timer->fire();
    ran = true;
  }
  return ran;
}

std::chrono::nanoseconds EventLoop::until_next_timer() const {
  auto shortest = kLongestSleep;
  for (const auto& weak : timers_) {
    const auto timer = weak.lock();
    // Simulated time only moves by a callback, which wakes the loop anyway.
    if (!timer || !timer->active_ || timer->clock_.simulated()) continue;
    shortest = std::min(shortest, std::chrono::nanoseconds(timer->next_ - timer->clock_.timer_now()));
  }
  return std::max(shortest, std::chrono::nanoseconds(0));
}

}  // namespace goalnet::ros
