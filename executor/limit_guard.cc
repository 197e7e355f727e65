#include "executor/limit_guard.h"

#include <algorithm>
#include <cmath>

namespace goalnet::executor {
namespace {

// Rounding of positions of a few metres or radians, seen as velocity over a cycle.
constexpr double kRounding = 1e-9;

// The largest velocity for the coming `dt` after which braking still ends within `distance`: v*dt + v^2/(2a).
// With v - a*dt' in the next step the same holds for the rest of the distance, whatever dt' is.
double braking_velocity(double distance, double acceleration, double dt) {
  if (!(distance > 0.0)) return 0.0;
  const double change = acceleration * dt;
  return std::sqrt(change * change + 2.0 * acceleration * distance) - change;
}

}  // namespace

LimitGuard::LimitGuard(const std::vector<JointLimits>& joints) {
  for (const JointLimits& joint : joints)
    limits_.push_back({joint.position_min, joint.position_max, joint.velocity, joint.acceleration});
}

void LimitGuard::reset(const JointSample& position) noexcept {
  command_.position = position.position;
  command_.velocity.fill(0.0);
  velocity_.fill(0.0);
  target_ = position.position;
}

void LimitGuard::rebase_target() noexcept { target_ = command_.position; }

double LimitGuard::clamp_step(std::size_t joint, double wanted, double dt) const noexcept {
  const Limits& limits = limits_[joint];
  const double position = command_.position[joint], change = limits.acceleration * dt;
  const auto towards = [&](double distance) {
    return std::min(limits.velocity, braking_velocity(distance, limits.acceleration, dt));
  };
  double low = -towards(position - limits.min), high = towards(limits.max - position);
  // The limit of acceleration comes last: it is the one that a robot cannot disobey.
  low = std::clamp(low, velocity_[joint] - change, velocity_[joint] + change);
  high = std::clamp(high, velocity_[joint] - change, velocity_[joint] + change);
  if (std::isnan(wanted)) wanted = 0.0;
  const double clamped = std::clamp(wanted, std::min(low, high), std::max(low, high));
  // Within rounding of the limits the target is taken as it is, so that a command equals its target exactly.
  const bool equal =
      std::isfinite(wanted) && std::abs(clamped - wanted) <= kRounding * (1.0 + std::abs(wanted));
  return equal ? wanted : clamped;
}

bool LimitGuard::follow(double dt, const JointSample& target) noexcept {
  bool guarded = false;
  for (std::size_t i = 0; i < limits_.size(); ++i) {
    const double lag = target_[i] - command_.position[i];
    double wanted;
    if (lag == 0.0) {
      wanted = (target.position[i] - command_.position[i]) / dt;
    } else {
      // Behind: move with the target and close the gap along a braking curve. Half of the acceleration is
      // left for what the target itself does meanwhile.
      const double distance = std::abs(lag), acceleration = 0.5 * limits_[i].acceleration;
      double closing = braking_velocity(distance, acceleration, dt);
      if (distance <= acceleration * dt * dt) closing = distance / dt;  // there within this step
      wanted = (target.position[i] - target_[i]) / dt + std::copysign(closing, lag);
    }
    const double velocity = clamp_step(i, wanted, dt);
    const double reached = command_.position[i] + velocity * dt;
    if (velocity == wanted &&
        std::abs(reached - target.position[i]) <= kRounding * dt * (1.0 + std::abs(wanted))) {
      command_.position[i] = target.position[i];
      const double given = std::isfinite(target.velocity[i]) ? target.velocity[i] : velocity;
      command_.velocity[i] = std::clamp(given, -limits_[i].velocity, limits_[i].velocity);
    } else {
      guarded = guarded || velocity != wanted;
      command_.position[i] = reached;
      command_.velocity[i] = velocity;
    }
    velocity_[i] = velocity;
    if (std::isfinite(target.position[i])) target_[i] = target.position[i];
  }
  return guarded;
}

void LimitGuard::brake(double dt) noexcept {
  for (std::size_t i = 0; i < limits_.size(); ++i) {
    const double velocity = clamp_step(i, 0.0, dt);
    command_.position[i] += velocity * dt;
    command_.velocity[i] = velocity_[i] = velocity;
    target_[i] = command_.position[i];
  }
}

bool LimitGuard::standing() const noexcept {
  for (std::size_t i = 0; i < limits_.size(); ++i)
    if (velocity_[i] != 0.0) return false;
  return true;
}

double LimitGuard::lag() const noexcept {
  double largest = 0.0;
  for (std::size_t i = 0; i < limits_.size(); ++i)
    largest = std::max(largest, std::abs(target_[i] - command_.position[i]));
  return largest;
}

}  // namespace goalnet::executor
