#include "components/manipulation/retreat.h"

#include <array>
#include <cmath>
#include <memory>
#include <numbers>

namespace goalnet::manipulation {
namespace {

constexpr int kFirstLook = 1'500;  // iterations for a way into the driving posture before coming out
constexpr int kShortWay = 200;     // iterations for a step back around something
constexpr int kRounds = 3;         // of coming out a little and looking again

// [rad] of the base, rather straight back.
constexpr double kBack = std::numbers::pi;
constexpr std::array kDirections{kBack,       kBack + 0.5, kBack - 0.5, kBack + 1.0,
                                 kBack - 1.0, kBack / 2,   -kBack / 2};
constexpr std::array kSlides{0.45, 0.30, 0.20, 0.10};  // [m]
constexpr std::array kPulls{0.25, 0.15, 0.08, 0.04};   // [m]

// Straight lines by which a hand comes out: along its own axis, towards the robot and askew, up; level, or
// raised a little first.
std::vector<std::vector<Pose>> ways_out(const Workbench& bench, const Configuration& q, const Pose& tool,
                                        double distance) {
  constexpr double kRise = 0.025;  // [m]
  const Pose raised = moved(tool, {0, 0, kRise});
  std::vector<std::vector<Pose>> ways{{backed(tool, distance)}};
  const double yaw = bench.stand_of(q).yaw + std::numbers::pi;
  for (const double askew : {0.0, 0.5, -0.5, 1.0, -1.0}) {
    const Eigen::Vector3d to = distance * Eigen::Vector3d(std::cos(yaw + askew), std::sin(yaw + askew), 0);
    ways.push_back({moved(tool, to)});
    ways.push_back({raised, moved(raised, to)});
  }
  ways.push_back({moved(tool, {0, 0, distance})});
  return ways;
}

// Where the base may get to round a corner with the arm as it is: back or aside, higher or lower, turned.
std::vector<Stand> ways_round(const Stand& here) {
  std::vector<Stand> stands;
  for (const double up : {0.0, 0.12, -0.12}) {
    for (const double direction : kDirections) {
      for (const double distance : {0.40, 0.25}) {
        stands.push_back(here);
        stands.back().x += distance * std::cos(here.yaw + direction);
        stands.back().y += distance * std::sin(here.yaw + direction);
        stands.back().lift += up;
      }
    }
    for (const double turn : {0.8, -0.8, 1.6, -1.6}) {
      stands.push_back(here);
      stands.back().yaw += turn;
      stands.back().lift += up;
    }
  }
  return stands;
}

// What the hand is in touch with may be touched while it comes away.
Tolerances touching(const Workbench& b, std::size_t arm) {
  const CollisionQuery query{&b.checker().hand_parts(arm), 0.01, nullptr, true};
  return b.checker().baseline(b.now(), query);
}

// The next way to come out that is free, as arms are.
Expected<JointTrajectory> come_out(Workbench& b, std::size_t arm) {
  for (const double direction : kDirections) {
    for (const double distance : kSlides) {
      if (auto motion = b.slide(direction, distance)) return motion;
    }
  }
  const Pose tool = b.tool_pose(b.now(), arm);
  for (const Tolerances& tolerances : {touching(b, arm), brushing(b, arm)}) {
    for (const double distance : kPulls) {
      for (const auto& way : ways_out(b, b.now(), tool, distance)) {
        if (auto motion = b.move_straight(arm, way, tolerances, 0.8)) return motion;
      }
    }
  }
  const int lift = b.model().lift.empty() ? -1 : b.model().index_of(b.model().lift);
  for (const Stand& stand : ways_round(b.stand_of(b.now()))) {
    if (lift >= 0) {
      const auto& limits = b.model().joints[static_cast<std::size_t>(lift)].limits;
      if (stand.lift < limits.lower || stand.lift > limits.upper) continue;
    }
    auto motion = b.drive(stand, kShortWay);
    if (motion || motion.error().outcome == Outcome::kCancelled) return motion;
  }
  return fail(Outcome::kMotionFailed,
              "the arm finds no way into the posture for driving, nor is there room to step back");
}

}  // namespace

Tolerances brushing(const Workbench& bench, std::size_t arm) {
  constexpr double kBeside = 0.006;  // [m]
  const PartSet& parts = bench.checker().hand_parts(arm);
  Tolerances out = touching(bench, arm);
  for (const std::string& name :
       bench.checker().touched_objects(bench.now(), {&parts, kBeside, nullptr, false}))
    out.allow_all(parts, bench.checker().body(name));
  return out;
}

void add_tuck(Phases& phases, const Workbench& bench) {
  for (std::size_t arm = 0; arm < bench.arm_count(); ++arm) {
    const auto planned = std::make_shared<bool>(false);
    for (int round = 0; round <= kRounds; ++round) {
      Phase tuck;
      tuck.stage = "tuck";
      tuck.plan = [arm, round, planned](Workbench& b) -> Expected<JointTrajectory> {
        if (*planned || b.is_tucked(arm)) return JointTrajectory{};
        auto motion = round < kRounds ? b.tuck(arm, kFirstLook) : b.tuck(arm);
        *planned = motion.has_value();
        const bool stuck = !motion && motion.error().outcome == Outcome::kMotionFailed;
        return stuck && round < kRounds ? come_out(b, arm) : motion;
      };
      tuck.optional = bench.hindered(arm);
      phases.push_back(tuck);
    }
  }
}

bool gets_out(Workbench& bench, const std::string& object, const Configuration& start, const Reach& reach,
              const std::vector<ArmPositions>& along) {
  const Pose* pose = bench.world().object(object);
  if (pose == nullptr || reach.tool.size() < 3) return true;
  const auto& arm = bench.arm(reach.arm);
  const Pose base = bench.arm_base_pose(start, reach.arm);
  // Where along the way the fingers close.
  std::size_t at = 0;
  while (at + 1 < along.size() &&
         ((base * arm.forward(along[at])).translation() - reach.tool[1].translation()).norm() > 1e-3)
    ++at;
  bench.suppose_held(reach.arm, object, reach.tool[1].inverse() * *pose);
  const auto& checker = bench.checker();
  const Configuration q = bench.with_fingers(start, reach.arm, reach.width);
  CollisionQuery query{&checker.arm_parts(reach.arm), bench.params().contact_margin, &reach.tolerances, true};
  const Tolerances in_touch = checker.baseline(bench.with_arm(q, reach.arm, along[at]), query);
  query.tolerances = &in_touch;
  bool out = true;
  for (std::size_t i = at + 1; i < along.size() && out; ++i)
    out = !checker.collides(bench.with_arm(q, reach.arm, along[i]), query);
  const Configuration lifted = bench.with_arm(q, reach.arm, along.back());
  const auto slides = [&] {
    const RidingAlong scope(bench.checker());
    for (const double direction : kDirections)
      if (bench.can_slide(lifted, direction, kSlides[1])) return true;
    return false;
  };
  const auto pulls = [&] {
    for (const auto& way : ways_out(bench, lifted, reach.tool.back(), kPulls[0]))
      if (bench.follow(lifted, reach.arm, along.back(), way, in_touch, bench.params().contact_margin))
        return true;
    return false;
  };
  out = out && (slides() || pulls());
  bench.end_supposition();
  return out;
}

}  // namespace goalnet::manipulation
