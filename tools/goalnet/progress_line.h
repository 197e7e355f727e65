// How far a long command is and how long it still takes, on standard error.
#pragma once

#include <chrono>
#include <string>

namespace goalnet::tools {

// One line that rewrites itself on a terminal; elsewhere a line every so often. For one thread.
class ProgressLine {
 public:
  explicit ProgressLine(std::chrono::milliseconds pause_elsewhere = std::chrono::seconds(10));
  // `done`: share of the work, 0 to 1; `measured`: what else is known by now.
  void show(double done, const std::string& measured = {});
  void finish() const;
  double seconds() const;  // since it was made

 private:
  bool terminal_;
  std::chrono::milliseconds pause_;
  double first_share_ = -1;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now(), shown_{};
};

}  // namespace goalnet::tools
