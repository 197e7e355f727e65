#include "executor/give_way.h"

#include <algorithm>
#include <cmath>

namespace goalnet::executor {
namespace {

constexpr double kShare = 0.5;  // of the limits

}  // namespace

bool GiveWay::begin(const JointSample& command, const JointSample& measured,
                    const std::vector<JointLimits>& joints) noexcept {
  start_ = setpoint_ = command;
  way_.fill(0.0);
  elapsed_ = duration_ = 0.0;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const JointLimits& joint = joints[j];
    // A measurement may lie a little beyond the limits; a command must not.
    const double end = std::clamp(measured.position[j], joint.position_min, joint.position_max);
    const double distance = std::abs(end - command.position[j]);
    if (joint.tracking_tolerance <= 0.0 || distance <= joint.goal_tolerance) continue;
    way_[j] = end - command.position[j];
    // From rest to rest a cubic peaks at 1.5 distance / T and 6 distance / T^2.
    duration_ = std::max({duration_, 1.5 * distance / (kShare * joint.velocity),
                          std::sqrt(6.0 * distance / (kShare * joint.acceleration))});
  }
  return duration_ > 0.0;
}

const JointSample& GiveWay::advance(double dt) noexcept {
  elapsed_ += dt;
  const double u = duration_ > 0.0 ? std::min(1.0, elapsed_ / duration_) : 1.0;
  for (std::size_t j = 0; j < kMaxJoints; ++j) {
    setpoint_.position[j] = start_.position[j] + way_[j] * u * u * (3.0 - 2.0 * u);
    setpoint_.velocity[j] = duration_ > 0.0 ? way_[j] * 6.0 * u * (1.0 - u) / duration_ : 0.0;
  }
  return setpoint_;
}

}  // namespace goalnet::executor
