// pour, pour-out, squeeze, add, scoop: what is held makes a gesture over (or in) something else and comes
// back.
#include <cmath>
#include <numbers>

#include "components/manipulation/place_candidates.h"
#include "components/manipulation/skills.h"

namespace goalnet::manipulation {
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;

constexpr double kOver = 0.05;      // [m] the lip above the receiver's mouth
constexpr double kBeyond = 0.20;    // [rad] more tilt than what makes contents run
constexpr double kTiltStep = 0.20;  // [rad]

// The object's pose with one of its points pinned and leaning by `tilt` towards `heading`, turned by `roll`
// about its own axis before.
Pose leaning(const Vector3d& pinned, const Vector3d& point_in_object, double heading, double tilt,
             double roll) {
  Pose pose = Pose::Identity();
  pose.linear() = (AngleAxisd(heading, Vector3d::UnitZ()) * AngleAxisd(tilt, Vector3d::UnitY()) *
                   AngleAxisd(roll, Vector3d::UnitZ()))
                      .toRotationMatrix();
  pose.translation() = pinned - pose.linear() * point_in_object;
  return pose;
}

// The end of a tool: the far end of its shapes along x, at their middle height.
Vector3d tip_of(const scene::ObjectModel& model) {
  const auto b = scene::bounds(model.shapes);
  return {b.upper.x() - 0.01, 0.0, 0.5 * (b.lower.z() + b.upper.z())};
}

// The gestures of one object as sequences of its poses; the last one is held for a while.
std::vector<std::vector<Pose>> pours(const scene::ObjectModel& model, const Vector3d& over) {
  std::vector<std::vector<Pose>> out;
  const double most = model.cavity->pour_tilt + kBeyond;
  for (int r = 0; r < 8; ++r) {
    const double roll = r * std::numbers::pi / 4;
    // The lip that will be lowest: towards the heading, seen from the rolled object.
    const Vector3d lip = model.cavity->mouth.translation() +
                         model.cavity->radius * Vector3d(std::cos(roll), -std::sin(roll), 0);
    for (int h = 0; h < 12; ++h) {
      const double heading = h * std::numbers::pi / 6;
      std::vector<Pose> poses{leaning(over + Vector3d(0, 0, 0.03), lip, heading, 0.0, roll)};
      for (double tilt = kTiltStep; tilt < most; tilt += kTiltStep)
        poses.push_back(leaning(over, lip, heading, tilt, roll));
      poses.push_back(leaning(over, lip, heading, most, roll));
      out.push_back(std::move(poses));
    }
  }
  return out;
}

std::vector<std::vector<Pose>> dips(const scene::ObjectModel& model, const Vector3d& above,
                                    const Vector3d& at, std::initializer_list<double> tilts) {
  std::vector<std::vector<Pose>> out;
  for (const double tilt : tilts) {
    for (int h = 0; h < 16; ++h) {
      const double heading = h * std::numbers::pi / 8;
      // On the way there it must not lean more than things carried may.
      out.push_back({leaning(above, tip_of(model), heading, std::min(tilt, 0.6), 0),
                     leaning(above, tip_of(model), heading, tilt, 0),
                     leaning(at, tip_of(model), heading, tilt, 0)});
    }
  }
  return out;
}

// Where unwanted contents go: into what a tap runs into.
std::optional<Vector3d> drain(const scene::Scene& scene) {
  for (const auto& rule : scene.rules.fills) {
    for (const auto& region : scene.regions) {
      if (region.fixture == rule.fixture && region.relation == scene::RegionRelation::kOn) {
        return support_pose(scene, region, region.supports.front()) * Vector3d(-0.08, 0.2, 0.2);
      }
    }
  }
  return std::nullopt;
}

}  // namespace

Expected<Phases> GestureSkill::attempt(Workbench& bench, int) {
  const std::string what = to_string(action_);
  const auto holding = bench.arm_holding(tool_);
  if (!holding) return fail(Outcome::kMotionFailed, what + ": " + tool_ + " is not in a hand");
  const std::size_t arm = *holding;
  const auto& model = *bench.scene().find_model_of(tool_);
  StandSearchOptions options;
  Vector3d mouth = Vector3d::Zero();
  if (receiver_.empty()) {
    const auto sink = drain(bench.scene());
    if (!sink) return fail(Outcome::kMotionFailed, what + ": there is no sink here");
    mouth = *sink;
  } else {
    const auto* receiver = bench.scene().find_model_of(receiver_);
    const Pose* pose = bench.world().object(receiver_);
    if (receiver == nullptr || pose == nullptr || !receiver->cavity) {
      return fail(Outcome::kMotionFailed, what + ": " + receiver_ + " cannot be seen or has no opening");
    }
    mouth = (*pose * receiver->cavity->mouth).translation();
    // What the other hand holds moves with base and lift: stay.
    options.may_drive = options.may_lift = !bench.arm_holding(receiver_).has_value();
  }
  std::vector<std::vector<Pose>> gestures;
  if (kind_ == Kind::kScoop) {
    gestures = dips(model, mouth + Vector3d(0, 0, 0.06), mouth - Vector3d(0, 0, 0.02), {0.8, 1.1, 0.6});
  } else if (model.cavity) {
    gestures = pours(model, mouth + Vector3d(0, 0, kOver));
  } else {
    gestures = dips(model, mouth + Vector3d(0, 0, 0.10), mouth + Vector3d(0, 0, 0.03), {1.35, 1.5});
  }
  const Pose grip = bench.held()[arm]->object_in_tool.inverse();
  std::vector<Reach> reaches;
  for (std::size_t i = 0; i < gestures.size(); ++i) {
    if (failed_.contains(i)) continue;
    Reach reach;
    reach.arm = arm;
    for (const auto& pose : gestures[i]) reach.tool.push_back(pose * grip);
    reach.opening = bench.opening_of(bench.now(), arm);
    reach.tag = i;
    reaches.push_back(std::move(reach));
  }
  options.most_reaches = 100;
  options.backwards = true;
  auto solution = find_stand(bench, reaches, options);
  if (!solution) return fail(solution.error().outcome, what + ": " + solution.error().message);
  const Reach reach = reaches[solution->reach];
  failed_.insert(reach.tag);
  Phases phases;
  add_back_off(phases, bench);
  add_go_to(phases, bench, *solution);
  add_approach(phases, *solution, reach);
  Phase there =
      straight(action_.name, arm, {reach.tool.begin() + 1, reach.tool.end()}, reach.tolerances, 0.6);
  there.settle = 1.4;  // contents take their time (DeviceRules: half a second to one second)
  phases.push_back(there);
  phases.push_back(
      straight("return", arm, {reach.tool.rbegin() + 1, reach.tool.rend()}, reach.tolerances, 0.8));
  return phases;
}

}  // namespace goalnet::manipulation
