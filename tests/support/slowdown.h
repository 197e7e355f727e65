// How much longer than alone everything takes on this machine now.
#pragma once

#include <ctime>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

namespace goalnet::testing_support {

// A thread that wants to work for a millisecond, sleep for one, and so on: about 1 on an idle machine, 10
// where it takes ten times as long. For tests that promise a time: no program holds it that is not let run.
class Slowdown {
 public:
  Slowdown() : thread_([this] { measure(); }) {}
  ~Slowdown() { stop(); }
  Slowdown(const Slowdown&) = delete;

  // Since construction, at least 1. Ends the measurement.
  double stop() {
    if (thread_.joinable()) {
      passed_ = std::chrono::steady_clock::now() - start_;
      stopped_ = true;
      thread_.join();
    }
    return std::max(1.0, factor_);
  }
  // The time since construction, as it would have been on an idle machine. Ends the measurement.
  std::chrono::duration<double> undisturbed() {
    const double factor = stop();
    return passed_ / factor;
  }

 private:
  static double processor_seconds() {
    timespec used{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
    return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
  }
  void measure() {
    int rounds = 0;
    while (!stopped_) {
      for (const double begin = processor_seconds(); processor_seconds() - begin < 1e-3;) {
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      ++rounds;
    }
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
    if (rounds > 0) factor_ = passed.count() / (2e-3 * rounds);
  }

  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::chrono::duration<double> passed_{};
  double factor_ = 1.0;
  std::atomic<bool> stopped_ = false;
  std::thread thread_;
};

}  // namespace goalnet::testing_support
