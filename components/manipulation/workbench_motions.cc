// Motions of the hands: free motion of an arm, straight lines of the tool, fingers.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "components/manipulation/workbench.h"

namespace goalnet::manipulation {
namespace {

constexpr double kCornerReach = 0.25;  // [s] at full speed: how early corners of free motions are rounded

}  // namespace

Expected<JointTrajectory> Workbench::move_arm(std::size_t arm, const ArmPositions& goal, double lift,
                                              double opening, int iterations) {
  std::vector<int> joints(arms_[arm].joints().begin(), arms_[arm].joints().end());
  const Configuration from = with_fingers(now_, arm, std::max(opening, opening_of(now_, arm)));
  const Stand here = stand_of(from);
  const bool lifting = lift_ >= 0 && std::abs(lift - here.lift) > 1e-4;
  if (lifting) joints.push_back(lift_);
  Configuration target = with_arm(from, arm, goal);
  if (lifting) target[static_cast<std::size_t>(lift_)] = lift;

  const PartSet& parts = lifting ? checker_.all_parts() : checker_.arm_parts(arm);
  CollisionQuery query{&parts, params_.margin, nullptr, true};
  Tolerances relaxed = checker_.baseline(from, query);
  {  // The goal may be near things on purpose (a hand before a handle); it was checked with the smaller
     // margin.
    CollisionQuery at_goal{&parts, params_.margin, &relaxed, true};
    relaxed = checker_.baseline(target, at_goal, 0.003);
  }
  query.tolerances = &relaxed;
  double tilt = tilt_limit(arm);
  // What holds nothing may be turned over on the way where it is to be put down like that.
  if (held_[arm] && !upright(target, arm, tilt) && !contains_something(held_[arm]->name))
    tilt = std::numbers::pi;

  PathQuery path;
  const TimedJoints limits = timed(joints);
  path.start = pick(from, joints);
  path.goal = pick(target, joints);
  path.scale = limits.velocity.cwiseInverse();
  path.lower.resize(path.start.size());
  path.upper.resize(path.start.size());
  for (std::size_t i = 0; i < joints.size(); ++i) {
    path.lower[static_cast<Eigen::Index>(i)] =
        model_.joints[static_cast<std::size_t>(joints[i])].limits.lower;
    path.upper[static_cast<Eigen::Index>(i)] =
        model_.joints[static_cast<std::size_t>(joints[i])].limits.upper;
  }
  Configuration scratch = from;
  const auto expand = [&](const JointVector& v) {
    for (std::size_t i = 0; i < joints.size(); ++i)
      scratch[static_cast<std::size_t>(joints[i])] = v[static_cast<Eigen::Index>(i)];
  };
  path.is_free = [&](const JointVector& v) {
    expand(v);
    return upright(scratch, arm, tilt) && !checker_.collides(scratch, query);
  };
  if (held_[arm] && tilt < 1.5) {
    // Few configurations chosen blindly keep a cup upright: choose a place and a heading for it instead.
    path.sample = [&](const std::function<double(double, double)>& uniform, JointVector& out) {
      const Pose base = arm_base_pose(now_, arm);
      Pose object = Pose::Identity();
      object.linear() =
          (Eigen::AngleAxisd(uniform(-std::numbers::pi, std::numbers::pi), Eigen::Vector3d::UnitZ()) *
           Eigen::AngleAxisd(uniform(-0.6, 0.6) * tilt, Eigen::Vector3d::UnitX()) *
           Eigen::AngleAxisd(uniform(-0.6, 0.6) * tilt, Eigen::Vector3d::UnitY()))
              .toRotationMatrix();
      const Pose tool_rotation = object * held_[arm]->object_in_tool.inverse();
      Pose tool = Pose::Identity();
      tool.linear() = base.linear().transpose() * tool_rotation.linear();
      tool.translation() =
          Eigen::Vector3d(uniform(-0.1, 0.9), sides_[arm] + uniform(-0.7, 0.7), uniform(-0.6, 0.5));
      ArmPositions seed;
      for (std::size_t i = 0; i < 7; ++i) seed[i] = uniform(arms_[arm].lower()[i], arms_[arm].upper()[i]);
      const auto solutions = arms_[arm].solve(tool, seed, 4);
      if (solutions.empty()) return false;
      out.resize(path.start.size());
      for (std::size_t i = 0; i < 7; ++i) out[static_cast<Eigen::Index>(i)] = solutions.front()[i];
      if (lifting) out[7] = uniform(path.lower[7], path.upper[7]);
      return true;
    };
  }
  path.stopped = stopped_;
  PlannerLimits planner;
  planner.iterations = iterations;
  auto corners = plan_path(path, planner);
  if (!corners) {
    auto error = corners.error();
    if (error.outcome == Outcome::kMotionFailed) {
      const auto why_start = checker_.explain(from, query), why_goal = checker_.explain(target, query);
      if (!why_start.empty()) error.message += " (" + why_start + ")";
      if (!why_goal.empty()) error.message += " (" + why_goal + ")";
    }
    return tl::unexpected<Error>(error);
  }
  return time_path(limits, round_corners(*corners, path.scale, kCornerReach, kPathSpacing, path.is_free));
}

std::optional<std::vector<ArmPositions>> Workbench::follow(const Configuration& q, std::size_t arm,
                                                           const ArmPositions& start,
                                                           const std::vector<Pose>& poses,
                                                           const Tolerances& tolerances,
                                                           double margin) const {
  const Pose to_base = arm_base_pose(q, arm).inverse();
  const CollisionQuery query{&checker_.arm_parts(arm), margin, &tolerances, true};
  std::vector<ArmPositions> out{start};
  Pose last = arm_base_pose(q, arm) * arms_[arm].forward(start);
  for (const auto& waypoint : poses) {
    for (const auto& pose : interpolate(last, waypoint)) {
      const auto next = arms_[arm].follow(to_base * pose, out.back(), 0.35);
      if (!next) return std::nullopt;
      out.push_back(*next);
    }
    last = waypoint;
  }
  // Collisions only once the whole line can be followed at all, from its far end, where they are likeliest.
  for (std::size_t i = out.size(); i-- > 1;) {
    if (checker_.collides(with_arm(q, arm, out[i]), query)) return std::nullopt;
  }
  return out;
}

Expected<JointTrajectory> Workbench::move_straight(std::size_t arm, const std::vector<Pose>& poses,
                                                   const Tolerances& tolerances, double speed) {
  const CollisionQuery query{&checker_.arm_parts(arm), params_.contact_margin, &tolerances, true};
  const Tolerances relaxed = checker_.baseline(now_, query);
  const auto points = follow(now_, arm, arm_of(now_, arm), poses, relaxed, params_.contact_margin);
  if (!points) {
    return fail(Outcome::kMotionFailed,
                "the hand cannot follow a straight line from here without a collision");
  }
  const std::vector<int> joints(arms_[arm].joints().begin(), arms_[arm].joints().end());
  const TimedJoints limits = timed(joints, speed);
  JointPath path;
  for (const auto& p : *points) path.push_back(Eigen::Map<const JointVector>(p.data(), 7));
  path = through_points(path, limits.velocity.cwiseInverse(), kPathSpacing);
  // Between points at a limit the curve may swing beyond it by a hair.
  for (auto& q : path) {
    for (std::size_t i = 0; i < 7; ++i) {
      auto& value = q[static_cast<Eigen::Index>(i)];
      value = std::clamp(value, arms_[arm].lower()[i], arms_[arm].upper()[i]);
    }
  }
  return time_path(limits, path);
}

JointTrajectory Workbench::move_fingers(std::size_t arm, double opening, double speed) const {
  std::vector<int> joints;
  for (const auto& name : model_.arms[arm].gripper.fingers) joints.push_back(model_.index_of(name));
  // From the command where there is one: fingers that grip are measured short of it.
  const Configuration& from = command_.size() == now_.size() ? command_ : now_;
  JointVector start = pick(from, joints);
  for (std::size_t i = 0; i < joints.size(); ++i) {  // measured fingers may stand a hair outside
    const auto& limits = model_.joints[static_cast<std::size_t>(joints[i])].limits;
    auto& value = start[static_cast<Eigen::Index>(i)];
    value = std::clamp(value, limits.lower, limits.upper);
  }
  return time_straight(timed(joints), start, pick(with_fingers(now_, arm, opening), joints), speed);
}

}  // namespace goalnet::manipulation
