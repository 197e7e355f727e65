// Ctrl-C and SIGTERM as a question that a loop can ask.
#pragma once

#include <chrono>
#include <functional>

namespace goalnet::tools {

// One at a time in a process. While it lives, SIGINT and SIGTERM are counted instead of ending the process;
// the second one ends it at once, for people who have lost patience.
class StopSignal {
 public:
  // `on_signal` is called from a thread of its own at the first signal: for interrupting long computations.
  explicit StopSignal(std::function<void()> on_signal = {});
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;

  bool requested() const;
  // Since the first signal; zero before it.
  std::chrono::steady_clock::duration age() const;

 private:
  struct Impl;
  Impl* impl_;
};

}  // namespace goalnet::tools
