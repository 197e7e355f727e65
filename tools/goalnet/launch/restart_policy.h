// When a process that ended is started again. Pure: time is given.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

namespace goalnet::tools {

enum class RestartWhen { kNever, kOnFailure, kAlways };

struct RestartParams {
  RestartWhen when = RestartWhen::kOnFailure;
  double delay = 0.5;          // [s] before the first restart; doubles with each that follows within `window`
  double longest_delay = 8.0;  // [s]
  int limit = 5;               // restarts within `window`; then it is given up
  double window = 60.0;        // [s]
  double silent_after = 0.0;   // [s] without a sign of life until a component is killed and counts as failed; 0: never
};

class RestartPolicy {
 public:
  explicit RestartPolicy(const RestartParams& params) : params_(params) {}

  struct Decision {
    enum class Kind { kStayEnded, kRestart, kGiveUp } kind = Kind::kStayEnded;
    double at = 0.0;  // [s] when to start again
  };
  // The process ended at `now` [s]; failed: by a signal or with a code other than 0.
  Decision ended(bool failed, double now);

 private:
  const RestartParams params_;
  std::deque<double> restarts_;  // moments within the window
};

}  // namespace goalnet::tools
