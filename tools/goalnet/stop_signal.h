// Ctrl-C, SIGTERM and the end of the terminal (SIGHUP) as a question that a loop can ask.
#pragma once

#include <chrono>
#include <functional>

namespace goalnet::tools {

// One at a time in a process. While it lives, SIGINT, SIGTERM and SIGHUP (unless that is ignored, as under
// nohup) are counted instead of ending the process; a second SIGINT or SIGTERM ends it at once, for people
// who have lost patience.
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
