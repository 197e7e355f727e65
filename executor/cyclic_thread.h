// A thread that calls one function at a fixed rate, in real time where the system permits.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <thread>

namespace goalnet::executor {

// Where time comes from and how to wait: the system's steady clock, or a fake one in tests.
struct TimeSource {
  std::function<std::int64_t()> now_ns;              // [ns] steady
  std::function<void(std::int64_t)> sleep_until_ns;  // returns at or after that time
};
TimeSource steady_time_source();

struct CyclicThreadParams {
  std::string name = "goalnet_rt";     // shown by top and ps (15 characters at most)
  std::int64_t period_ns = 1'000'000;  // > 0
  int priority = 80;                   // SCHED_FIFO 1..99; 0 = ordinary scheduling
  std::optional<int> cpu = {};         // pin to this CPU
  bool lock_memory = true;             // mlockall and prefaulted stack
};

struct CyclicStatistics {
  std::uint64_t cycles = 0;
  std::uint64_t overruns = 0;  // woke later than half a period
  std::uint64_t skipped = 0;   // periods left out because a cycle took longer than its period
  std::int64_t worst_lateness_ns = 0;
};

// Overrun policy: a cycle that misses its slot is not made up for. The next one is scheduled on the first
// slot of the original grid that still lies ahead, so lateness never accumulates and cycles never come in
// bursts.
class CyclicThread {
 public:
  // `cycle` runs on the thread with the actual wake-up time [ns]; returning false ends the thread.
  using Cycle = std::function<bool(std::int64_t time_ns)>;

  CyclicThread(CyclicThreadParams params, Cycle cycle, TimeSource time = steady_time_source());
  ~CyclicThread();  // stops and joins
  CyclicThread(const CyclicThread&) = delete;
  CyclicThread& operator=(const CyclicThread&) = delete;

  // Starts the thread: memory, then scheduling, then the loop. Returns one warning that names everything the
  // system did not permit (the loop runs all the same, with less punctuality), or nothing.
  std::optional<std::string> start();
  void stop();  // from another thread; returns when the thread has ended
  // Runs the loop in the caller's thread (tests with a fake clock), until `cycle` returns false or stop().
  void run_here();

  CyclicStatistics statistics() const;  // any thread

 private:
  CyclicThreadParams params_;
  Cycle cycle_;
  TimeSource time_;
  std::atomic<bool> stopping_{false};
  std::atomic<std::uint64_t> cycles_{0}, overruns_{0}, skipped_{0};
  std::atomic<std::int64_t> worst_lateness_ns_{0};
  std::thread thread_;
};

}  // namespace goalnet::executor
