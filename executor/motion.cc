#include "executor/motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace goalnet::executor {
namespace {

constexpr double kSecond = 1e-9;  // [s] in a nanosecond

// Cubic Hermite over [0, duration] from (p0, v0) to (p1, v1), at time t.
PreparedTrajectory::Sample hermite(double p0, double v0, double p1, double v1, double duration, double t) {
  const double u = t / duration, m0 = v0 * duration, m1 = v1 * duration;
  const double c2 = 3.0 * (p1 - p0) - 2.0 * m0 - m1, c3 = 2.0 * (p0 - p1) + m0 + m1;
  return {p0 + u * (m0 + u * (c2 + u * c3)), (m0 + u * (2.0 * c2 + u * 3.0 * c3)) / duration};
}

// From (p0, v0) to rest within `duration`; the acceleration begins and ends at 0 and peaks at 1.5 v0 /
// duration.
PreparedTrajectory::Sample slow_down(double p0, double v0, double duration, double t) {
  if (t >= duration) return {p0 + 0.5 * v0 * duration, 0.0};
  const double u = t / duration;
  return {p0 + v0 * duration * u * (1.0 - u * u * (1.0 - 0.5 * u)), v0 * (1.0 - u * u * (3.0 - 2.0 * u))};
}

std::int64_t nanoseconds(double seconds) { return static_cast<std::int64_t>(std::ceil(seconds / kSecond)); }

}  // namespace

Motion::Motion(const std::vector<JointLimits>& joints) : joints_(joints) { row_.fill(-1); }

// A cubic from (difference, rate) to (0, 0) accelerates by at most 6 |difference| / T^2 + 4 |rate| / T.
// Half of the limit is left to the trajectory itself.
double Motion::fade_duration(double difference, double rate, double acceleration) noexcept {
  const double w = std::abs(rate), d = std::abs(difference), a = 0.5 * acceleration;
  return (2.0 * w + std::sqrt(4.0 * w * w + 6.0 * a * d)) / a;
}

StartMismatch Motion::begin(const PreparedTrajectory& trajectory, const JointSample& command) noexcept {
  std::array<std::int32_t, kMaxJoints> row;
  row.fill(-1);
  for (std::size_t i = 0; i < trajectory.size(); ++i) row[trajectory.joint(i)] = static_cast<std::int32_t>(i);

  std::array<Splice, kMaxJoints> splices{};
  const double lead = kSecond * static_cast<double>(trajectory.first_ns());
  std::int64_t end = trajectory.last_ns();
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    Splice& splice = splices[j];
    if (row[j] < 0) {
      splice.duration = 1.5 * std::abs(command.velocity[j]) / joints_[j].acceleration;
    } else {
      const auto first = trajectory.sample(static_cast<std::size_t>(row[j]), trajectory.first_ns(), 0);
      if (joints_[j].continuous) {
        constexpr double kTurn = 2.0 * std::numbers::pi;
        splice.offset = kTurn * std::round((command.position[j] - first.position) / kTurn);
      }
      splice.difference = command.position[j] - (first.position + splice.offset);
      splice.rate = command.velocity[j] - first.velocity;
      const double distance = std::abs(splice.difference);
      // At rest at both ends a cubic peaks at 1.5 times its average velocity and 6 distance / T^2.
      const bool far = lead > 0.0 ? 1.5 * distance > joints_[j].velocity * lead ||
                                        6.0 * distance > joints_[j].acceleration * lead * lead
                                  : distance > joints_[j].start_tolerance;
      if (far && distance > 1e-6) return {true, j, -splice.difference};
      if (lead == 0.0 && (splice.difference != 0.0 || splice.rate != 0.0))
        splice.duration = fade_duration(splice.difference, splice.rate, joints_[j].acceleration);
    }
    end = std::max(end, nanoseconds(splice.duration));
  }
  trajectory_ = &trajectory;
  segment_ = 0;
  end_ns_ = end;
  start_ = command;
  splices_ = splices;
  row_ = row;
  return {};
}

void Motion::evaluate(std::int64_t time_ns, JointSample& setpoint) noexcept {
  const double t = kSecond * static_cast<double>(time_ns);
  const std::int64_t first_ns = trajectory_->first_ns();
  segment_ = trajectory_->find_segment(time_ns, segment_);
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const Splice& splice = splices_[j];
    PreparedTrajectory::Sample sample;
    if (row_[j] < 0) {
      sample = splice.duration > 0.0 ? slow_down(start_.position[j], start_.velocity[j], splice.duration, t)
                                     : PreparedTrajectory::Sample{start_.position[j], 0.0};
    } else if (time_ns < first_ns) {
      const auto first = trajectory_->sample(static_cast<std::size_t>(row_[j]), first_ns, 0);
      sample = hermite(start_.position[j], start_.velocity[j], first.position + splice.offset, first.velocity,
                       kSecond * static_cast<double>(first_ns), t);
    } else {
      sample = trajectory_->sample(static_cast<std::size_t>(row_[j]), time_ns, segment_);
      sample.position += splice.offset;
      if (t < splice.duration) {
        const auto fade = hermite(splice.difference, splice.rate, 0.0, 0.0, splice.duration, t);
        sample.position += fade.position;
        sample.velocity += fade.velocity;
      }
    }
    setpoint.position[j] = sample.position;
    setpoint.velocity[j] = sample.velocity;
  }
}

}  // namespace goalnet::executor
