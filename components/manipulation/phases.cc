#include "components/manipulation/phases.h"

#include <algorithm>
#include <cmath>

#include "components/manipulation/in_the_way.h"
#include "components/manipulation/retreat.h"

namespace goalnet::manipulation {

Pose moved(const Pose& pose, const Eigen::Vector3d& offset) {
  Pose out = pose;
  out.translation() += offset;
  return out;
}

double lowest_height(const std::vector<scene::Shape>& shapes, const Pose& owner) {
  double lowest = owner.translation().z();
  for (const auto& shape : shapes) {
    const Pose pose = owner * shape.pose;
    // The box around the shape reaches this far down from its middle.
    const double down = pose.linear().row(2).cwiseAbs().dot(scene::half_extents(shape));
    lowest = std::min(lowest, pose.translation().z() - down);
  }
  return lowest;
}

Pose backed(const Pose& tool, double distance) { return tool * Eigen::Translation3d(0, 0, -distance); }

double grip_opening(double width, double force) {
  // Finger servos push harder the further their command lies inside the thing: about 10 N and 4 N a
  // millimetre. A real gripper with force control does the same with another law; what counts is "narrower
  // than the thing".
  const double deeper = std::clamp((force - 10.0) / 4000.0, 0.003, 0.012);
  return std::max(0.0, width - 2 * deeper);
}

Phase straight(std::string stage, std::size_t arm, std::vector<Pose> poses, Tolerances tolerances,
               double speed) {
  Phase phase;
  phase.stage = std::move(stage);
  phase.plan = [=](Workbench& bench) { return bench.move_straight(arm, poses, tolerances, speed); };
  return phase;
}

Phase fingers(std::string stage, std::size_t arm, double opening, double settle) {
  Phase phase;
  phase.stage = std::move(stage);
  phase.plan = [=](Workbench& bench) -> Expected<JointTrajectory> {
    return bench.move_fingers(arm, opening);
  };
  phase.settle = settle;
  return phase;
}

void expect_unmoved(Phase& phase, const Workbench& bench, const std::string& object) {
  constexpr double kMoved = 0.02, kTurned = 0.2;  // [m, rad]
  const Pose* pose = bench.world().object(object);
  if (pose == nullptr || bench.arm_holding(object) || bench.checker().rides(object)) return;
  phase.plan = [plan = std::move(phase.plan), object,
                before = *pose](Workbench& b) -> Expected<JointTrajectory> {
    const Pose* now = b.world().object(object);
    if (now == nullptr) return fail(Outcome::kMotionFailed, object + " is not seen any more");
    const Eigen::Vector3d up = now->linear().col(2), up_before = before.linear().col(2);
    if ((now->translation() - before.translation()).norm() > kMoved || up.cross(up_before).norm() > kTurned)
      return fail(Outcome::kMotionFailed, object + " was moved meanwhile");
    return plan(b);
  };
}

namespace {

// Everything that the hand is in touch with now may be touched while backing away.
Tolerances touching_now(Workbench& bench, std::size_t arm, double gap) {
  const CollisionQuery query{&bench.checker().hand_parts(arm), gap, nullptr, true};
  return bench.checker().baseline(bench.now(), query);
}

bool hand_is_near_something(Workbench& bench, std::size_t arm) {
  const CollisionQuery query{&bench.checker().hand_parts(arm), 0.006, nullptr, false};
  return bench.checker().collides(bench.now(), query);
}

}  // namespace

void add_back_off(Phases& phases, const Workbench& bench) {
  for (std::size_t arm = 0; arm < bench.arm_count(); ++arm) {
    Phase open;
    open.stage = "back off";
    open.optional = true;
    open.plan = [arm](Workbench& b) -> Expected<JointTrajectory> {
      if (b.held()[arm] || !hand_is_near_something(b, arm)) return JointTrajectory{};
      return b.move_fingers(arm, std::min(0.1, b.opening_of(b.now(), arm) + 0.04));
    };
    phases.push_back(open);
    Phase away;
    away.stage = "back off";
    away.optional = true;
    away.plan = [arm](Workbench& b) -> Expected<JointTrajectory> {
      if (!hand_is_near_something(b, arm)) return JointTrajectory{};
      const Pose tool = b.tool_pose(b.now(), arm);
      const Tolerances tolerances = touching_now(b, arm, 0.01);
      if (b.held()[arm]) return b.move_straight(arm, {moved(tool, {0, 0, 0.05})}, tolerances, 0.7);
      return b.move_straight(arm, {backed(tool, 0.08)}, tolerances, 0.7);
    };
    phases.push_back(away);
  }
}

void add_go_to(Phases& phases, const Workbench& bench, const ReachSolution& solution) {
  if (!solution.drives) return;
  add_tuck(phases, bench);
  Phase drive;
  drive.stage = "drive";
  drive.plan = [stand = solution.stand](Workbench& b) {
    auto motion = b.drive(stand);
    if (!motion) b.note_dead_end({stand, std::nullopt, {}});
    return motion;
  };
  phases.push_back(drive);
}

void add_approach(Phases& phases, const ReachSolution& solution, const Reach& reach, int iterations) {
  Phase phase;
  phase.stage = "approach";
  phase.plan = [goal = solution.along.front(), lift = solution.stand.lift, arm = reach.arm,
                opening = reach.opening, iterations](Workbench& b) -> Expected<JointTrajectory> {
    const bool holds = b.held()[arm].has_value();
    auto motion = b.move_arm(arm, goal, lift, holds ? 0.0 : opening, iterations);
    if (!motion) b.note_dead_end({b.stand_of(b.now()), arm, goal});
    if (!motion || holds) return motion;
    return merge(*motion, b.move_fingers(arm, opening));
  };
  phases.push_back(phase);
}

void add_way(Phases& phases, const Workbench& bench, const ReachSolution& solution, const Reach& reach,
             int iterations) {
  add_back_off(phases, bench);
  add_go_to(phases, bench, solution);
  add_approach(phases, solution, reach, iterations);
}

namespace {

Try as_try(const Workbench& bench, const Reach& reach, const std::string& what, const std::string& about) {
  const Pose* thing = about.empty() ? nullptr : bench.world().object(about);
  const Pose& tool = reach.tool[std::min<std::size_t>(1, reach.tool.size() - 1)];
  return {what, reach.arm, thing != nullptr ? thing->inverse() * tool : tool};
}

// Among the ways that were not tried before; if none of those will do, among all.
Expected<ReachSolution> find_new_way(Workbench& bench, const std::vector<Reach>& reaches,
                                     const StandSearchOptions& options, const std::string& what,
                                     const std::string& about) {
  std::vector<Reach> untried;
  std::vector<std::size_t> index;
  for (std::size_t i = 0; i < reaches.size() && bench.tried().size() > 0; ++i) {
    if (bench.tried().contains(as_try(bench, reaches[i], what, about))) continue;
    untried.push_back(reaches[i]);
    index.push_back(i);
  }
  if (!untried.empty() && untried.size() < reaches.size()) {
    auto solution = find_stand(bench, untried, options);
    if (solution) solution->reach = index[solution->reach];
    if (solution || solution.error().outcome == Outcome::kCancelled) return solution;
  }
  return find_stand(bench, reaches, options);
}

}  // namespace

Expected<Reach> add_way_there(Phases& phases, Workbench& bench, const std::vector<Reach>& reaches,
                              const StandSearchOptions& options, const std::string& what,
                              const std::string& about) {
  const auto solution = find_new_way(bench, reaches, options, what, about);
  if (!solution && solution.error().outcome == Outcome::kMotionFailed && options.looks_for_obstacles) {
    if (auto things = find_in_the_way(bench, reaches, options)) bench.note_in_the_way(std::move(things));
  }
  if (!solution) return fail(solution.error().outcome, what + ": " + solution.error().message);
  const Reach& reach = reaches[solution->reach];
  if (!bench.supposes()) bench.tried().add(as_try(bench, reach, what, about));
  add_way(phases, bench, *solution, reach, options.iterations);
  return reach;
}

void add_let_go(Phases& phases, const Workbench&, std::size_t arm, double more, const Tolerances& tolerances,
                const Eigen::Vector3d& further) {
  Phase open;
  open.stage = "let go";
  open.plan = [arm, more](Workbench& b) -> Expected<JointTrajectory> {
    return b.move_fingers(arm, std::min(0.119, b.opening_of(b.now(), arm) + more));
  };
  open.check = [arm](Workbench& b) -> Expected<void> {
    b.set_held(arm, std::nullopt);
    return {};
  };
  open.settle = 0.1;
  phases.push_back(open);
  Phase away;
  away.stage = "retreat";
  away.optional = true;
  away.plan = [arm, tolerances, further](Workbench& b) -> Expected<JointTrajectory> {
    const Pose tool = b.tool_pose(b.now(), arm);
    for (const double distance : {0.10, 0.07, 0.05, 0.04, 0.03}) {
      const Pose back = backed(tool, distance);
      if (further.norm() > 0) {
        auto motion = b.move_straight(arm, {back, moved(back, further)}, tolerances);
        if (motion) return motion;
      }
      auto motion = b.move_straight(arm, {back}, tolerances);
      if (motion) return motion;
    }
    return fail(Outcome::kMotionFailed, "the hand cannot retreat");
  };
  phases.push_back(away);
}

}  // namespace goalnet::manipulation
