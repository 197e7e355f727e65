// A queue of callbacks and timers that one thread runs, so that the callbacks of a component never run at the
// same time and need no locks.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

namespace goalnet::ros {

class Timer;

// post(), stop() and wake() may be called from any thread; all else from the one thread that runs the loop.
// Callbacks run in order of arrival; timers that are due run between them, earliest first, then oldest first.
class EventLoop {
 public:
  // At most `capacity` callbacks wait; beyond that post() refuses. Subscriptions bound themselves long
  // before.
  explicit EventLoop(std::size_t capacity = 100'000) : capacity_(capacity) {}
  EventLoop(const EventLoop&) = delete;
  EventLoop& operator=(const EventLoop&) = delete;

  // Returns false, and drops the callback, where the queue is full.
  bool post(std::function<void()> callback);

  // Runs what waits now and timers that are due; never blocks. Returns whether anything ran.
  bool run_pending();

  // Runs until stop(); sleeps while there is nothing to do.
  void run();

  // As run(), but returns after `limit` of wall-clock time or when `done` says so (asked after each round).
  // Returns whether `done` was met.
  bool run_for(std::chrono::nanoseconds limit, const std::function<bool()>& done = {});

  // Ends run() once what waits in this round has run. A stopped loop can be run again.
  void stop();

  // Makes run() look at its timers again, for example after simulated time moved.
  void wake();

 private:
  friend class Timer;
  void add(const std::shared_ptr<Timer>& timer);
  bool run_due_timers();
  std::chrono::nanoseconds until_next_timer() const;

  const std::size_t capacity_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> queue_;
  bool stop_ = false;
  bool woken_ = false;
  std::vector<std::weak_ptr<Timer>> timers_;  // in order of creation
};

}  // namespace goalnet::ros
