// Driving, and the posture for it.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "components/manipulation/workbench.h"

namespace goalnet::manipulation {
namespace {

double wrap(double angle) { return std::remainder(angle, 2 * std::numbers::pi); }

}  // namespace

Expected<JointTrajectory> Workbench::drive(const Stand& goal, int iterations) {
  const RidingAlong scope(checker_);
  std::vector<int> joints{base_x_, base_y_, base_yaw_};
  if (lift_ >= 0) joints.push_back(lift_);
  const Stand here = stand_of(now_);
  Stand there = goal;
  there.yaw = here.yaw + wrap(goal.yaw - here.yaw);  // the short way round
  const Configuration target = with_stand(now_, there);
  CollisionQuery query{&checker_.all_parts(), params_.drive_margin, nullptr, true};
  Tolerances relaxed = checker_.baseline(now_, query);
  {
    CollisionQuery at_goal = query;
    at_goal.tolerances = &relaxed;
    relaxed = checker_.baseline(target, at_goal, 0.01);
  }
  query.tolerances = &relaxed;
  const TimedJoints limits = timed(joints);
  PathQuery path;
  path.start = pick(now_, joints);
  path.goal = pick(target, joints);
  path.scale = limits.velocity.cwiseInverse();
  path.lower = path.start;
  path.upper = path.start;
  path.lower[0] = scene_.floor_x_min;
  path.upper[0] = scene_.floor_x_max;
  path.lower[1] = scene_.floor_y_min;
  path.upper[1] = scene_.floor_y_max;
  path.lower[2] = std::min(here.yaw, there.yaw) - std::numbers::pi / 2;
  path.upper[2] = std::max(here.yaw, there.yaw) + std::numbers::pi / 2;
  if (lift_ >= 0) {
    path.lower[3] = model_.joints[static_cast<std::size_t>(lift_)].limits.lower;
    path.upper[3] = model_.joints[static_cast<std::size_t>(lift_)].limits.upper;
  }
  Configuration scratch = now_;
  path.is_free = [&](const JointVector& v) {
    for (std::size_t i = 0; i < joints.size(); ++i)
      scratch[static_cast<std::size_t>(joints[i])] = v[static_cast<Eigen::Index>(i)];
    return !checker_.collides(scratch, query);
  };
  path.stopped = stopped_;
  PlannerLimits planner;
  planner.iterations = iterations;
  planner.range = 0.8;
  auto corners = plan_path(path, planner);
  if (!corners) {
    auto error = corners.error();
    const auto why = checker_.explain(target, query);
    error.message = "cannot drive there: " + error.message + (why.empty() ? "" : " (" + why + ")");
    return tl::unexpected<Error>(error);
  }
  return time_path(limits, round_corners(*corners, path.scale, 0.6, kPathSpacing, path.is_free));
}

namespace {

constexpr double kSlideStep = 0.02;   // [m] between looks
constexpr double kPassing = 0.004;    // [m] kept by the hands from what they pass, if they have that now
constexpr double kBesideBase = 0.02;  // [m] the same for the base

Stand moved(Stand stand, double direction, double distance) {
  stand.x += distance * std::cos(stand.yaw + direction);
  stand.y += distance * std::sin(stand.yaw + direction);
  return stand;
}

}  // namespace

bool Workbench::can_slide(const Configuration& from, double direction, double distance) const {
  CollisionQuery arms{&checker_.all_parts(), kPassing, nullptr, true};
  CollisionQuery base{&checker_.trunk_parts(), kBesideBase, nullptr, false};
  const Tolerances arms_now = checker_.baseline(from, arms), base_now = checker_.baseline(from, base);
  arms.tolerances = &arms_now;
  base.tolerances = &base_now;
  const Stand here = stand_of(from);
  const int n = static_cast<int>(std::ceil(distance / kSlideStep));
  for (int i = 1; i <= n; ++i) {
    const Configuration q = with_stand(from, moved(here, direction, distance * i / n));
    if (checker_.collides(q, base) || checker_.collides(q, arms)) return false;
  }
  const Stand end = moved(here, direction, distance);
  return end.x > scene_.floor_x_min && end.x < scene_.floor_x_max && end.y > scene_.floor_y_min &&
         end.y < scene_.floor_y_max;
}

Expected<JointTrajectory> Workbench::slide(double direction, double distance) {
  const RidingAlong scope(checker_);
  if (!can_slide(now_, direction, distance))
    return fail(Outcome::kMotionFailed, "the base cannot move straight without the robot touching something");
  const std::vector<int> joints{base_x_, base_y_, base_yaw_};
  const Configuration target = with_stand(now_, moved(stand_of(now_), direction, distance));
  return time_straight(timed(joints), pick(now_, joints), pick(target, joints));
}

bool Workbench::is_tucked(std::size_t arm) const {
  const auto posture = carry_posture(arm);
  return posture && robot::largest_step(arm_of(now_, arm), *posture) < 0.05;
}

// Home, or if something is in the way there, the nearest free place for the hand around it.
std::optional<ArmPositions> Workbench::empty_posture(std::size_t arm) const {
  const ArmPositions home = arm_of(model_.home(), arm);
  const CollisionQuery query{&checker_.arm_parts(arm), params_.drive_margin, nullptr, true};
  if (!checker_.collides(with_arm(now_, arm, home), query)) return home;
  const double side = sides_[arm] > 0 ? 1.0 : -1.0;
  const Pose tool = arms_[arm].forward(home);
  for (const double inwards : {0.0, 0.5, -0.4, 1.0}) {
    for (const double up : {0.0, 0.12, -0.1, 0.24}) {
      for (const double out : {0.0, 0.08, 0.16, -0.08}) {
        for (const double ahead : {0.0, -0.06, 0.08}) {
          Pose pose = tool;
          pose.linear() = Eigen::AngleAxisd(-side * inwards, Eigen::Vector3d::UnitZ()) * tool.linear();
          pose.translation() += Eigen::Vector3d(ahead, side * out, up);
          for (const auto& q : arms_[arm].solve(pose, home, 8, 0.05)) {
            if (!checker_.collides(with_arm(now_, arm, q), query)) return q;
          }
        }
      }
    }
  }
  return std::nullopt;
}

std::optional<ArmPositions> Workbench::carry_posture(std::size_t arm) const {
  const ArmPositions current = arm_of(now_, arm);
  // Tucked already: stay so, also where another posture has become free meanwhile.
  if (carry_[arm] && (held_[arm] || robot::largest_step(current, *carry_[arm]) < 0.05)) return carry_[arm];
  if (!held_[arm]) return empty_posture(arm);
  const CollisionQuery query{&checker_.arm_parts(arm), params_.margin, nullptr, true};
  const Pose base = arm_base_pose(now_, arm);
  const Pose object_now = base.inverse() * tool_pose(now_, arm) * held_[arm]->object_in_tool;
  const double heading = std::atan2(object_now.linear()(1, 0), object_now.linear()(0, 0));
  const double side = sides_[arm] > 0 ? 1.0 : -1.0;
  std::optional<ArmPositions> best;
  double least = 1e9;
  for (const double turn : {0.0, 0.4, -0.4, 0.8, -0.8, 1.2, -1.2, 1.6, -1.6, 2.2, -2.2, 3.1}) {
    for (const Eigen::Vector3d& place :
         {Eigen::Vector3d(0.36, 0.20, -0.20), Eigen::Vector3d(0.36, 0.26, -0.10),
          Eigen::Vector3d(0.42, 0.24, -0.18), Eigen::Vector3d(0.36, 0.24, 0.0),
          Eigen::Vector3d(0.42, 0.30, -0.05), Eigen::Vector3d(0.34, 0.32, -0.25),
          Eigen::Vector3d(0.48, 0.26, -0.1), Eigen::Vector3d(0.46, 0.30, 0.05)}) {
      Pose object = Pose::Identity();
      object.linear() = Eigen::AngleAxisd(heading + turn, Eigen::Vector3d::UnitZ()).toRotationMatrix();
      Pose tool = object * held_[arm]->object_in_tool.inverse();
      tool.translation() = Eigen::Vector3d(place.x(), side * place.y(), place.z());
      for (const auto& q : arms_[arm].solve(tool, current, 12, 0.05)) {
        double cost = std::abs(turn) * 0.3;
        for (std::size_t i = 0; i < 7; ++i)
          cost = std::max(cost, std::abs(q[i] - current[i]) + std::abs(turn) * 0.2);
        if (cost >= least) continue;
        if (checker_.collides(with_arm(now_, arm, q), query)) continue;
        least = cost;
        best = q;
        break;
      }
    }
    if (best && least < 1.6) break;
  }
  return best;
}

Expected<JointTrajectory> Workbench::tuck(std::size_t arm, int iterations) {
  const auto posture = carry_posture(arm);
  if (!posture) return fail(Outcome::kMotionFailed, "no posture to carry what the hand holds");
  auto motion = move_arm(arm, *posture, stand_of(now_).lift, 0.0, iterations);
  if (motion) carry_[arm] = *posture;
  return motion;
}

}  // namespace goalnet::manipulation
