// The last stage before the command: nothing leaves the executor outside the limits of position, velocity and
// acceleration, whatever the stages before it ask for.
#pragma once

#include <array>
#include <vector>

#include "executor/executor_params.h"
#include "executor/joint_sample.h"

namespace goalnet::executor {

// Real-time thread; never allocates after construction. Where the target keeps the limits, the command equals
// the target exactly. Where it does not, the command lags and then catches up along a braking curve, without
// overshoot. Given that the command starts within the limits, for every target (also a jumping or infinite
// one):
//   |velocity| <= limit, |change of velocity| <= acceleration * dt, and the position can always still be
//   braked before its limit. A command that starts outside its position limits may only move inward.
class LimitGuard {
 public:
  explicit LimitGuard(const std::vector<JointLimits>& joints);

  // The command stands at `position`, and so does the target.
  void reset(const JointSample& position) noexcept;
  // The target starts anew at the current command (after a change of motion); velocities are kept.
  void rebase_target() noexcept;

  // Moves the command towards `target` for `dt` seconds (> 0). Returns true if a limit
  // changed the command.
  bool follow(double dt, const JointSample& target) noexcept;
  // Brakes every joint as hard as permitted for `dt` seconds.
  void brake(double dt) noexcept;

  const JointSample& command() const noexcept { return command_; }
  bool standing() const noexcept;
  // Largest distance between command and target: 0 when the command has caught up.
  double lag() const noexcept;

 private:
  struct Limits {
    double min, max, velocity, acceleration;
  };
  double clamp_step(std::size_t joint, double wanted, double dt) const noexcept;

  std::vector<Limits> limits_;
  JointSample command_;                      // last command
  std::array<double, kMaxJoints> target_{};  // last target position
  std::array<double, kMaxJoints>
      velocity_{};  // average velocity over the last cycle: what the limits apply to
};

}  // namespace goalnet::executor
