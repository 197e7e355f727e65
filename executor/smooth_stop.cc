#include "executor/smooth_stop.h"

#include <algorithm>
#include <cmath>

namespace goalnet::executor {

double SmoothStop::rate_at(double elapsed) const noexcept {
  if (elapsed >= duration_) return 0.0;
  const double u = elapsed / duration_;
  return 1.0 - u * u * (3.0 - 2.0 * u);
}

std::int64_t SmoothStop::time_at(double elapsed) const noexcept {
  if (duration_ <= 0.0) return start_ns_;
  const double u = std::min(elapsed / duration_, 1.0);
  const double travelled = duration_ * u * (1.0 - u * u * (1.0 - 0.5 * u));  // the integral of rate_at()
  return start_ns_ + static_cast<std::int64_t>(std::llround(1e9 * travelled));
}

std::int64_t SmoothStop::advance(std::int64_t dt_ns) noexcept {
  elapsed_ += 1e-9 * static_cast<double>(dt_ns);
  return time_at(elapsed_);
}

bool SmoothStop::within_limits(Motion& motion, const JointSample& command,
                               const std::vector<JointLimits>& joints) const noexcept {
  constexpr int kSamples = 16;
  const double step = duration_ / kSamples;
  JointSample before = command, setpoint;
  for (int k = 1; k <= kSamples; ++k) {
    const double elapsed = k * step, rate = rate_at(elapsed);
    motion.evaluate(time_at(elapsed), setpoint);
    for (std::size_t j = 0; j < joints.size(); ++j) {
      setpoint.velocity[j] *= rate;
      if (std::abs(setpoint.velocity[j] - before.velocity[j]) > joints[j].acceleration * step) return false;
    }
    before = setpoint;
  }
  return true;
}

void SmoothStop::begin(Motion& motion, std::int64_t time_ns, const JointSample& command,
                       const std::vector<JointLimits>& joints) noexcept {
  start_ns_ = time_ns;
  elapsed_ = 0.0;
  double shortest = 0.0;
  for (std::size_t j = 0; j < joints.size(); ++j)
    shortest = std::max(shortest, 1.5 * std::abs(command.velocity[j]) / joints[j].acceleration);
  duration_ = shortest;
  while (duration_ > 0.0 && duration_ < kLongest * shortest && !within_limits(motion, command, joints))
    duration_ *= 1.25;
}

}  // namespace goalnet::executor
