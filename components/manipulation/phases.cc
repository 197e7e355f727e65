#include "components/manipulation/phases.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "components/manipulation/in_the_way.h"

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

namespace {

constexpr int kShortWay = 200;  // iterations for a step back

// Away from what the robot stands before, arms as they are: rather straight back, else aside, else a turn.
Expected<JointTrajectory> step_back(Workbench& bench) {
  const Stand here = bench.stand_of(bench.now());
  std::vector<Stand> stands;
  for (const double direction : {0.0, 0.5, -0.5, 1.0, -1.0, 1.57, -1.57}) {
    for (const double distance : {0.40, 0.25}) {
      Stand back = here;
      back.x -= distance * std::cos(here.yaw + direction);
      back.y -= distance * std::sin(here.yaw + direction);
      stands.push_back(back);
    }
  }
  for (const double turn : {0.8, -0.8, 1.6, -1.6}) {
    stands.push_back(here);
    stands.back().yaw += turn;
  }
  for (const Stand& stand : stands) {
    auto motion = bench.drive(stand, kShortWay);
    if (motion || motion.error().outcome == Outcome::kCancelled) return motion;
  }
  return fail(Outcome::kMotionFailed,
              "the arm finds no way into the posture for driving, nor is there room to step back");
}

// The arms into the posture in which the base drives. Where one finds no way into it, between boards or under
// a door, the robot steps back first.
void add_tuck(Phases& phases, const Workbench& bench) {
  for (std::size_t arm = 0; arm < bench.arm_count(); ++arm) {
    const auto has_failed = std::make_shared<bool>(false);
    Phase tuck;
    tuck.stage = "tuck";
    tuck.plan = [arm, has_failed](Workbench& b) -> Expected<JointTrajectory> {
      if (b.is_tucked(arm)) return JointTrajectory{};
      auto motion = b.tuck(arm);
      *has_failed = !motion && motion.error().outcome == Outcome::kMotionFailed;
      return *has_failed ? step_back(b) : motion;
    };
    tuck.optional = bench.hindered(arm);
    phases.push_back(tuck);
    Phase again = tuck;
    again.plan = [arm, has_failed](Workbench& b) -> Expected<JointTrajectory> {
      return *has_failed ? b.tuck(arm) : JointTrajectory{};
    };
    phases.push_back(again);
  }
}

}  // namespace

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

void add_approach(Phases& phases, const ReachSolution& solution, const Reach& reach) {
  Phase phase;
  phase.stage = "approach";
  phase.plan = [goal = solution.along.front(), lift = solution.stand.lift, arm = reach.arm,
                opening = reach.opening](Workbench& b) -> Expected<JointTrajectory> {
    const bool holds = b.held()[arm].has_value();
    auto motion = b.move_arm(arm, goal, lift, holds ? 0.0 : opening);
    if (!motion) b.note_dead_end({b.stand_of(b.now()), arm, goal});
    if (!motion || holds) return motion;
    return merge(*motion, b.move_fingers(arm, opening));
  };
  phases.push_back(phase);
}

void add_way(Phases& phases, const Workbench& bench, const ReachSolution& solution, const Reach& reach) {
  add_back_off(phases, bench);
  add_go_to(phases, bench, solution);
  add_approach(phases, solution, reach);
}

Expected<Reach> add_way_there(Phases& phases, Workbench& bench, const std::vector<Reach>& reaches,
                              const StandSearchOptions& options, const std::string& what) {
  const auto solution = find_stand(bench, reaches, options);
  if (!solution && solution.error().outcome == Outcome::kMotionFailed && options.looks_for_obstacles) {
    if (auto things = find_in_the_way(bench, reaches, options)) bench.note_in_the_way(std::move(things));
  }
  if (!solution) return fail(solution.error().outcome, what + ": " + solution.error().message);
  const Reach& reach = reaches[solution->reach];
  add_way(phases, bench, *solution, reach);
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
