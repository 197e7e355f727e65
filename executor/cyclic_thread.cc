#include "executor/cyclic_thread.h"

#include <time.h>

#include <algorithm>
#include <future>
#include <utility>

#include "executor/realtime_setup.h"

namespace goalnet::executor {
namespace {

std::int64_t steady_now_ns() {
  timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return now.tv_sec * 1'000'000'000LL + now.tv_nsec;
}

void steady_sleep_until_ns(std::int64_t time_ns) {
  const timespec until{time_ns / 1'000'000'000LL, time_ns % 1'000'000'000LL};
  // An absolute time: an interrupted sleep simply goes on.
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) != 0) {
  }
}

// Only the loop's own thread writes these counters; others read them. A plain store is enough.
template <class T>
void add(std::atomic<T>& counter, T amount) {
  counter.store(counter.load(std::memory_order_relaxed) + amount, std::memory_order_relaxed);
}

}  // namespace

TimeSource steady_time_source() { return {steady_now_ns, steady_sleep_until_ns}; }

CyclicThread::CyclicThread(CyclicThreadParams params, Cycle cycle, TimeSource time)
    : params_(std::move(params)), cycle_(std::move(cycle)), time_(std::move(time)) {
  params_.period_ns = std::max<std::int64_t>(params_.period_ns, 1);
}

CyclicThread::~CyclicThread() { stop(); }

std::optional<std::string> CyclicThread::start() {
  stop();
  stopping_ = false;
  std::string missing;
  const auto note = [&missing](const std::optional<std::string>& what) {
    if (what) missing += (missing.empty() ? "" : "; ") + *what;
  };

  // 1. The process: memory is locked before the thread exists, so that its stack is locked too.
  if (params_.lock_memory) note(lock_process_memory());
  // 2. The thread prepares itself and reports; 3. only then does the loop begin.
  std::promise<void> ready;
  std::future<void> prepared = ready.get_future();
  thread_ = std::thread([this, &note, ready = std::move(ready)]() mutable {
    name_thread(params_.name);
    if (params_.lock_memory) prefault_stack();
    if (params_.cpu) note(pin_to_cpu(*params_.cpu));
    if (params_.priority > 0) note(use_realtime_scheduling(params_.priority));
    ready.set_value();  // from here on nothing of start() is touched
    run_here();
  });
  prepared.wait();
  if (missing.empty()) return std::nullopt;
  return params_.name + " runs without real-time guarantees: " + missing;
}

void CyclicThread::stop() {
  stopping_ = true;
  if (thread_.joinable()) thread_.join();
}

void CyclicThread::run_here() {
  std::int64_t due = time_.now_ns();
  while (!stopping_.load(std::memory_order_relaxed)) {
    time_.sleep_until_ns(due);
    const std::int64_t now = time_.now_ns(), lateness = now - due;
    add<std::uint64_t>(cycles_, 1);
    if (lateness > params_.period_ns / 2) add<std::uint64_t>(overruns_, 1);
    if (lateness > worst_lateness_ns_.load(std::memory_order_relaxed))
      worst_lateness_ns_.store(lateness, std::memory_order_relaxed);
    if (!cycle_(now)) return;

    due += params_.period_ns;
    const std::int64_t behind = time_.now_ns() - due;
    if (behind > 0) {  // missed: go on with the first slot that still lies ahead
      const std::int64_t slots = behind / params_.period_ns + 1;
      due += slots * params_.period_ns;
      add(skipped_, static_cast<std::uint64_t>(slots));
    }
  }
}

CyclicStatistics CyclicThread::statistics() const {
  return {cycles_.load(), overruns_.load(), skipped_.load(), worst_lateness_ns_.load()};
}

}  // namespace goalnet::executor
