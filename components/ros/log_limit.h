// Keeps a flood of one kind of line from flooding the log: the first few of each second are written, the rest
// is counted, and the next line that is written says how many were left out.
//
//   ros::LogLimit limit_;
//   limit_.write([&](const std::string& more) { node_.log().warn("refused: {}{}", why, more); });
#pragma once

#include <chrono>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>

namespace goalnet::ros {

// Thread-safe; not for the real-time thread. Counts on the wall clock: simulated time may stand still in a
// flood.
class LogLimit {
 public:
  using Time = std::chrono::steady_clock::time_point;
  static constexpr int kLines = 3;
  static constexpr std::chrono::nanoseconds kPeriod = std::chrono::seconds(1);

  // What to append to the line: "" or " (317 more in the last 1.0 s)"; nullopt: write nothing. `now` never
  // goes back.
  std::optional<std::string> pass(Time now = std::chrono::steady_clock::now());

  // Calls line(what to append), or not.
  template <class Line>
  void write(const Line& line) {
    if (const auto more = pass()) line(*more);
  }

  // Lines left out so far, in all.
  std::uint64_t left_out() const;

 private:
  mutable std::mutex mutex_;
  Time begin_{};     // of the period at hand
  int written_ = 0;  // in it
  std::uint64_t left_out_ = 0, left_out_in_all_ = 0;
};

}  // namespace goalnet::ros
