#include "executor/prepared_trajectory.h"

#include <algorithm>
#include <cmath>

#include "executor/joint_sample.h"

namespace goalnet::executor {
namespace {

// Bounds against hostile input: 100,000 points are 100 s of a sample per cycle.
constexpr std::size_t kMaxPoints = 100'000;
constexpr std::int64_t kMaxDurationNs = 3'600'000'000'000;
// Plans touch their limits exactly; rounding on the way must not make them invalid. The limit guard has the
// last word anyway.
constexpr double kRounding = 1e-3;

tl::unexpected<Error> invalid(const std::string& what) {
  return fail(Outcome::kInvalidRequest, "trajectory refused: " + what);
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

Expected<std::vector<std::size_t>> find_joints(const std::vector<std::string>& names,
                                               const ExecutorParams& params) {
  if (names.empty()) return invalid("it names no joint");
  std::vector<std::size_t> found;
  for (const std::string& name : names) {
    const auto at = std::find_if(params.joints.begin(), params.joints.end(),
                                 [&](const JointLimits& joint) { return joint.name == name; });
    if (at == params.joints.end()) return invalid("the robot has no joint '" + name.substr(0, 80) + "'");
    const auto index = static_cast<std::size_t>(at - params.joints.begin());
    if (std::find(found.begin(), found.end(), index) != found.end())
      return invalid("joint '" + name + "' is named twice");
    found.push_back(index);
  }
  return found;
}

Expected<void> check_shape(const JointTrajectory& trajectory) {
  if (trajectory.points.empty()) return invalid("it has no points");
  std::int64_t previous = -1;
  const std::size_t count = trajectory.joints.size();
  for (std::size_t k = 0; k < trajectory.points.size(); ++k) {
    const TrajectoryPoint& point = trajectory.points[k];
    const std::string where = "point " + std::to_string(k);
    if (point.time_ns <= previous) return invalid(where + " is not later than the one before");
    if (point.time_ns > kMaxDurationNs) return invalid(where + " lies more than an hour ahead");
    previous = point.time_ns;
    if (point.position.size() != count)
      return invalid(where + " has " + std::to_string(point.position.size()) + " positions for " +
                     std::to_string(count) + " joints");
    if (!point.velocity.empty() && point.velocity.size() != count)
      return invalid(where + " has " + std::to_string(point.velocity.size()) + " velocities for " +
                     std::to_string(count) + " joints");
  }
  return {};
}

// Within a micrometre or microradian.
bool equal_but_for_rounding(const std::vector<double>& a, const std::vector<double>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](double x, double y) { return std::abs(x - y) <= 1e-6; });
}

// A planner that has nothing to do for a moment may give the same point twice at the same time; that is
// harmless.
JointTrajectory without_repeated_points(const JointTrajectory& given) {
  JointTrajectory trajectory{given.stamp_ns, given.joints, {}};
  trajectory.points.reserve(given.points.size());
  for (const TrajectoryPoint& point : given.points) {
    const bool repeated = !trajectory.points.empty() && trajectory.points.back().time_ns == point.time_ns &&
                          equal_but_for_rounding(trajectory.points.back().position, point.position);
    if (!repeated) trajectory.points.push_back(point);
  }
  return trajectory;
}

// Slopes for points without velocities: those of a monotone cubic (Fritsch and Carlson, 1980), which never
// overshoots its points, so that positions within limits stay within limits.
double monotone_slope(double left, double right) {
  if (left * right <= 0.0) return 0.0;
  return 2.0 * left * right / (left + right);  // harmonic mean: at most twice the smaller one
}

}  // namespace

Expected<std::unique_ptr<PreparedTrajectory>> PreparedTrajectory::prepare(const JointTrajectory& given,
                                                                          const ExecutorParams& params) {
  if (given.points.size() > kMaxPoints)
    return invalid("it has " + std::to_string(given.points.size()) + " points; at most " +
                   std::to_string(kMaxPoints) + " are taken");
  const JointTrajectory trajectory = without_repeated_points(given);
  auto joints = find_joints(trajectory.joints, params);
  if (!joints) return tl::unexpected(joints.error());
  if (auto shape = check_shape(trajectory); !shape) return tl::unexpected(shape.error());

  auto prepared = std::make_unique<PreparedTrajectory>();
  prepared->stamp_ns_ = trajectory.stamp_ns;
  prepared->joints_ = std::move(*joints);
  const std::size_t count = prepared->joints_.size(), points = trajectory.points.size();
  prepared->times_.reserve(points);
  prepared->positions_.reserve(points * count);
  prepared->velocities_.assign(points * count, 0.0);
  for (const TrajectoryPoint& point : trajectory.points) {
    prepared->times_.push_back(point.time_ns);
    prepared->positions_.insert(prepared->positions_.end(), point.position.begin(), point.position.end());
  }

  if (auto ok = prepared->check_positions(params); !ok) return tl::unexpected(ok.error());
  if (auto ok = prepared->take_velocities(trajectory, params); !ok) return tl::unexpected(ok.error());
  return prepared;
}

Expected<void> PreparedTrajectory::check_positions(const ExecutorParams& params) {
  const std::size_t count = joints_.size();
  for (std::size_t n = 0; n < positions_.size(); ++n) {
    const JointLimits& limits = params.joints[joints_[n % count]];
    const auto where = [&] {
      return "point " + std::to_string(n / count) + ", joint '" + limits.name + "': ";
    };
    double& position = positions_[n];
    if (!std::isfinite(position)) return invalid(where() + "position is not a number");
    if (position < limits.position_min - kRounding || position > limits.position_max + kRounding)
      return invalid(where() + "position " + number(position) + " is outside [" +
                     number(limits.position_min) + ", " + number(limits.position_max) + "]");
    position = std::clamp(position, limits.position_min, limits.position_max);
  }
  return {};
}

Expected<void> PreparedTrajectory::take_velocities(const JointTrajectory& trajectory,
                                                   const ExecutorParams& params) {
  const std::size_t count = joints_.size(), points = times_.size();
  for (std::size_t i = 0; i < count; ++i) {
    const JointLimits& limits = params.joints[joints_[i]];
    double before = 0.0;  // average velocity of the segment before point k
    for (std::size_t k = 0; k < points; ++k) {
      const auto where = [&] { return "point " + std::to_string(k) + ", joint '" + limits.name + "': "; };
      const double position = positions_[k * count + i];
      double after = 0.0;
      if (k + 1 < points) {
        const double duration = 1e-9 * static_cast<double>(times_[k + 1] - times_[k]);
        after = (positions_[(k + 1) * count + i] - position) / duration;
        if (std::abs(after) > limits.velocity * (1.0 + kRounding) + kRounding)
          return invalid(where() + "the way to the next point needs " + number(std::abs(after)) +
                         " per second, the limit is " + number(limits.velocity));
      }
      const std::vector<double>& given = trajectory.points[k].velocity;
      double& velocity = velocities_[k * count + i];
      velocity = !given.empty()                ? given[i]
                 : (k == 0 || k + 1 == points) ? 0.0
                                               : monotone_slope(before, after);
      if (!std::isfinite(velocity)) return invalid(where() + "velocity is not a number");
      if (std::abs(velocity) > limits.velocity * (1.0 + kRounding))
        return invalid(where() + "velocity " + number(velocity) + " exceeds the limit " +
                       number(limits.velocity));
      if (k + 1 == points) {
        if (std::abs(velocity) > 0.01 * limits.velocity)
          return invalid(where() + "it must end at standstill, not at " + number(velocity));
        velocity = 0.0;
      }
      before = after;
    }
  }
  return {};
}

std::size_t PreparedTrajectory::find_segment(std::int64_t time_ns, std::size_t hint) const noexcept {
  const std::size_t segments = times_.size() - 1;
  if (segments == 0) return 0;
  std::size_t k = std::min(hint, segments - 1);
  while (k + 1 < segments && time_ns >= times_[k + 1]) ++k;
  while (k > 0 && time_ns < times_[k]) --k;
  return k;
}

PreparedTrajectory::Sample PreparedTrajectory::sample(std::size_t i, std::int64_t time_ns,
                                                      std::size_t segment) const noexcept {
  const std::size_t count = joints_.size();
  if (time_ns >= times_.back()) return {positions_[(times_.size() - 1) * count + i], 0.0};
  if (time_ns < times_.front()) return {positions_[i], 0.0};
  const std::size_t from = segment * count + i, to = from + count;
  const double h = 1e-9 * static_cast<double>(times_[segment + 1] - times_[segment]);
  const double u = 1e-9 * static_cast<double>(time_ns - times_[segment]) / h;
  const double p0 = positions_[from], p1 = positions_[to], m0 = h * velocities_[from],
               m1 = h * velocities_[to];
  // Hermite basis in Horner form around p0, exact at both ends up to rounding.
  const double c2 = 3.0 * (p1 - p0) - 2.0 * m0 - m1, c3 = 2.0 * (p0 - p1) + m0 + m1;
  return {p0 + u * (m0 + u * (c2 + u * c3)), (m0 + u * (2.0 * c2 + u * 3.0 * c3)) / h};
}

}  // namespace goalnet::executor
