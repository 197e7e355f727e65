#include "components/manipulation/trajectory_timing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <kdl/velocityprofile_trap.hpp>

namespace goalnet::manipulation {
namespace {

constexpr double kSamplePeriod = 0.01;  // [s] between points of straight motions
// Part of the acceleration limit that curvature may use up; the rest is left for speeding up and braking.
constexpr double kCurvatureShare = 0.7;

std::int64_t to_ns(double seconds) { return static_cast<std::int64_t>(std::llround(seconds * 1e9)); }

std::vector<double> to_vector(const JointVector& v) { return {v.data(), v.data() + v.size()}; }

// First and second derivative of the path at each point, with respect to its length in scaled units.
struct Slopes {
  std::vector<double> step;  // step[i] = length from point i to i + 1
  JointPath first, second;
};

Slopes slopes_of(const JointPath& path, const JointVector& scale) {
  const std::size_t n = path.size();
  Slopes out;
  for (std::size_t i = 0; i + 1 < n; ++i) out.step.push_back(scaled_distance(path[i], path[i + 1], scale));
  out.first.resize(n);
  out.second.assign(n, JointVector::Zero(path[0].size()));
  for (std::size_t i = 0; i < n; ++i) {
    if (i == 0 || i + 1 == n) {
      const std::size_t k = i == 0 ? 0 : n - 2;
      out.first[i] = (path[k + 1] - path[k]) / out.step[k];
      continue;
    }
    const double h0 = out.step[i - 1], h1 = out.step[i];
    const JointVector d0 = (path[i] - path[i - 1]) / h0, d1 = (path[i + 1] - path[i]) / h1;
    out.first[i] = (h1 * d0 + h0 * d1) / (h0 + h1);
    out.second[i] = 2.0 * (d1 - d0) / (h0 + h1);
  }
  return out;
}

// Largest path acceleration (sign +1) at this squared speed.
double path_acceleration(const TimedJoints& joints, const JointVector& first, const JointVector& second,
                         double squared_speed) {
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index j = 0; j < first.size(); ++j) {
    const double slope = std::abs(first[j]);
    if (slope < 1e-9) continue;
    const double left = joints.acceleration[j] - std::abs(second[j]) * squared_speed;
    least = std::min(least, std::max(left, 0.05 * joints.acceleration[j]) / slope);
  }
  return std::isfinite(least) ? least : 1.0;
}

}  // namespace

double duration_s(const JointTrajectory& trajectory) {
  return trajectory.points.empty() ? 0.0 : static_cast<double>(trajectory.points.back().time_ns) * 1e-9;
}

namespace {

// A smooth path of at least two points, all distinct.
JointTrajectory time_smooth_path(const TimedJoints& joints, JointPath path) {
  JointTrajectory out;
  out.joints = joints.names;
  const JointVector scale = joints.velocity.cwiseInverse();
  // Both ends rest: a path needs points between them to have any speed at all.
  while (path.size() < 9) {
    JointPath finer{path.front()};
    for (std::size_t i = 1; i < path.size(); ++i) {
      finer.push_back(0.5 * (path[i - 1] + path[i]));
      finer.push_back(path[i]);
    }
    path = std::move(finer);
  }
  const auto slopes = slopes_of(path, scale);
  const std::size_t n = path.size();
  std::vector<double> speed2(n);
  for (std::size_t i = 0; i < n; ++i) {
    double limit = 1.0;  // full speed: every joint's velocity limit is met by the scaling of length, roughly
    for (Eigen::Index j = 0; j < path[i].size(); ++j) {
      const double v = joints.velocity[j] / std::max(1e-9, std::abs(slopes.first[i][j]));
      limit = std::min(limit, v * v);
      limit = std::min(
          limit, kCurvatureShare * joints.acceleration[j] / std::max(1e-9, std::abs(slopes.second[i][j])));
    }
    speed2[i] = limit;
  }
  speed2.front() = speed2.back() = 0;
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const double a = path_acceleration(joints, slopes.first[i], slopes.second[i], speed2[i]);
    speed2[i + 1] = std::min(speed2[i + 1], speed2[i] + 2 * a * slopes.step[i]);
  }
  for (std::size_t i = n - 1; i > 0; --i) {
    const double a = path_acceleration(joints, slopes.first[i], slopes.second[i], speed2[i]);
    speed2[i - 1] = std::min(speed2[i - 1], speed2[i] + 2 * a * slopes.step[i - 1]);
  }
  double t = 0;
  std::int64_t last = -1;
  for (std::size_t i = 0; i < n; ++i) {
    if (i > 0) t += 2 * slopes.step[i - 1] / (std::sqrt(speed2[i - 1]) + std::sqrt(speed2[i]));
    const std::int64_t at = to_ns(t);
    // Points closer than 2 ms say nothing new to a 1 kHz loop; the last one always counts.
    if (i > 0 && i + 1 < n && at - last < 2'000'000) continue;
    if (i + 1 == n && at - last < 1'000'000 && out.points.size() > 1) out.points.pop_back();
    last = at;
    executor::TrajectoryPoint point;
    point.time_ns = at;
    point.position = to_vector(path[i]);
    point.velocity = to_vector(slopes.first[i] * std::sqrt(speed2[i]));
    out.points.push_back(std::move(point));
  }
  return out;
}

// One after the other; `next` begins where `first` ends.
void append(JointTrajectory& first, JointTrajectory next) {
  const std::int64_t start = first.points.empty() ? 0 : first.points.back().time_ns;
  for (std::size_t i = first.points.empty() ? 0 : 1; i < next.points.size(); ++i) {
    next.points[i].time_ns += start;
    first.points.push_back(std::move(next.points[i]));
  }
}

}  // namespace

JointTrajectory time_path(const TimedJoints& joints, const JointPath& given) {
  JointTrajectory out;
  out.joints = joints.names;
  const JointVector scale = joints.velocity.cwiseInverse();  // path length in seconds at full speed
  JointPath path;
  for (const auto& q : given) {
    if (path.empty() || scaled_distance(path.back(), q, scale) > 1e-5) path.push_back(q);
  }
  if (path.size() < 2) return out;
  path.back() = given.back();
  std::size_t first = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (i + 1 < path.size() && !turns_sharply(path[i - 1], path[i], path[i + 1], scale)) continue;
    append(out, time_smooth_path(joints, JointPath(path.begin() + static_cast<std::ptrdiff_t>(first),
                                                   path.begin() + static_cast<std::ptrdiff_t>(i) + 1)));
    first = i;
  }
  return out;
}

JointTrajectory time_straight(const TimedJoints& joints, const JointVector& from, const JointVector& to,
                              double speed) {
  JointTrajectory out;
  out.joints = joints.names;
  const JointVector way = to - from;
  double v = std::numeric_limits<double>::infinity(), a = v;
  for (Eigen::Index j = 0; j < way.size(); ++j) {
    if (std::abs(way[j]) < 1e-9) continue;
    v = std::min(v, speed * joints.velocity[j] / std::abs(way[j]));
    a = std::min(a, joints.acceleration[j] / std::abs(way[j]));
  }
  if (!std::isfinite(v)) return out;
  KDL::VelocityProfile_Trap profile(v, a);
  profile.SetProfile(0.0, 1.0);
  const double total = profile.Duration();
  const int steps = std::max(2, static_cast<int>(std::ceil(total / kSamplePeriod)));
  for (int i = 0; i <= steps; ++i) {
    const double t = total * i / steps;
    executor::TrajectoryPoint point;
    point.time_ns = to_ns(t);
    const bool last = i == steps;
    point.position = to_vector(last ? to : JointVector(from + way * profile.Pos(t)));
    point.velocity = to_vector(way * (last || i == 0 ? 0.0 : profile.Vel(t)));
    out.points.push_back(std::move(point));
  }
  return out;
}

namespace {

// Position and velocity at a moment by cubic Hermite interpolation, as the executor does it.
void sample(const JointTrajectory& t, std::int64_t time_ns, std::vector<double>& position,
            std::vector<double>& velocity) {
  const auto after = std::lower_bound(t.points.begin(), t.points.end(), time_ns,
                                      [](const auto& point, std::int64_t at) { return point.time_ns < at; });
  if (after == t.points.begin() || after == t.points.end()) {
    const auto& p = after == t.points.end() ? t.points.back() : t.points.front();
    position.insert(position.end(), p.position.begin(), p.position.end());
    velocity.insert(velocity.end(), t.joints.size(), 0.0);
    return;
  }
  const auto& a = *(after - 1);
  const auto& b = *after;
  const double h = static_cast<double>(b.time_ns - a.time_ns) * 1e-9;
  const double u = static_cast<double>(time_ns - a.time_ns) * 1e-9 / h, u2 = u * u, u3 = u2 * u;
  for (std::size_t j = 0; j < t.joints.size(); ++j) {
    position.push_back((2 * u3 - 3 * u2 + 1) * a.position[j] + (u3 - 2 * u2 + u) * h * a.velocity[j] +
                       (-2 * u3 + 3 * u2) * b.position[j] + (u3 - u2) * h * b.velocity[j]);
    velocity.push_back((6 * u2 - 6 * u) / h * a.position[j] + (3 * u2 - 4 * u + 1) * a.velocity[j] +
                       (-6 * u2 + 6 * u) / h * b.position[j] + (3 * u2 - 2 * u) * b.velocity[j]);
  }
}

}  // namespace

JointTrajectory merge(const JointTrajectory& a, const JointTrajectory& b) {
  if (a.points.empty()) return b;
  if (b.points.empty()) return a;
  JointTrajectory out;
  out.joints = a.joints;
  out.joints.insert(out.joints.end(), b.joints.begin(), b.joints.end());
  const auto& longer = a.points.back().time_ns >= b.points.back().time_ns ? a : b;
  for (const auto& point : longer.points) {
    executor::TrajectoryPoint merged;
    merged.time_ns = point.time_ns;
    sample(a, point.time_ns, merged.position, merged.velocity);
    sample(b, point.time_ns, merged.position, merged.velocity);
    out.points.push_back(std::move(merged));
  }
  out.points.front().velocity.assign(out.joints.size(), 0.0);
  out.points.back().velocity.assign(out.joints.size(), 0.0);
  return out;
}

}  // namespace goalnet::manipulation
