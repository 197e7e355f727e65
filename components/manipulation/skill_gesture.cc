// pour, pour-out, squeeze, add, scoop: what is held makes a gesture over (or in) something else and comes
// back.
#include <cmath>
#include <numbers>

#include "components/manipulation/place_candidates.h"
#include "components/manipulation/skills.h"
#include "components/manipulation/two_hands.h"

namespace goalnet::manipulation {
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;

// [m] the lip above the receiver's mouth when things run: low is neat
constexpr double kOver[] = {0.05, 0.11};
constexpr double kPourClear = 0.02;  // [m] everything else above it at any time
constexpr double kUpright = 0.9;     // upward part of the axis of a mouth that things can be poured into
constexpr double kBeyond = 0.20;     // [rad] more tilt than what makes contents run
constexpr std::size_t kReserveTag = 100'000;  // ways in reserve are numbered from here
constexpr double kTiltStep = 0.20;            // [rad]
constexpr double kLeaning = 0.3;              // [rad] less than an open vessel may lean on the way

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

// One way to make the gesture: poses of what is held, the last one is kept for a while.
struct Gesture {
  std::vector<Pose> poses;
  double preference = 0;  // [s] lower is better
};

// Pouring over a lip, seen from the hand: sideways by turning the wrist is what hands do best. The whole
// thing stays above the receiver's mouth while it leans: a full cup starts higher and comes down as it tilts.
// `reserve`: only for a search that failed otherwise.
std::vector<Gesture> pours(const scene::ObjectModel& model, const Vector3d& mouth, const Pose& tool_in_object,
                           bool reserve) {
  std::vector<Gesture> out;
  const double most = std::min(model.cavity->pour_tilt + kBeyond, std::numbers::pi - 0.05);
  const Vector3d hand = tool_in_object.linear().col(2);
  const double hand_angle = hand.head<2>().norm() > 0.2 ? std::atan2(hand.y(), hand.x()) : 0.0;
  for (const double beside : {90.0, -90.0, 60.0, -60.0, 120.0, -120.0, 30.0, -30.0, 0.0, 180.0}) {
    const double angle = beside * std::numbers::pi / 180;
    const double lip_angle = hand_angle + angle;
    const Vector3d lip = model.cavity->mouth.translation() +
                         model.cavity->radius * Vector3d(std::cos(lip_angle), std::sin(lip_angle), 0);
    const auto pose_at = [&](double heading, double tilt, double over) {
      const Pose low = leaning(mouth + Vector3d(0, 0, over), lip, heading, tilt, -lip_angle);
      const double short_of = mouth.z() + kPourClear - lowest_height(model.shapes, low);
      return moved(low, {0, 0, std::max(0.0, short_of)});
    };
    if (reserve && std::abs(std::remainder(beside, 90.0)) > 1.0) continue;
    for (const double over : kOver) {
      if (reserve && over == kOver[0]) continue;
      for (int h = 0; h < 12; ++h) {
        const double heading = h * std::numbers::pi / 6;
        Gesture gesture;
        gesture.preference = 0.5 * std::abs(std::cos(angle)) + 2.0 * (over - kOver[0]);
        // In reserve it comes leaning, away from what spans the mouth.
        for (double tilt = reserve ? kLeaning : 0.0; tilt < most; tilt += kTiltStep)
          gesture.poses.push_back(pose_at(heading, tilt, over));
        gesture.poses.push_back(pose_at(heading, most, over));
        out.push_back(std::move(gesture));
      }
    }
  }
  return out;
}

// The end of a tool goes into something, steeply.
std::vector<Gesture> dips(const scene::ObjectModel& model, const Vector3d& above, const Vector3d& at,
                          std::initializer_list<double> tilts) {
  std::vector<Gesture> out;
  for (const double tilt : tilts) {
    for (int h = 0; h < 16; ++h) {
      const double heading = h * std::numbers::pi / 8;
      // On the way there it must not lean more than things carried may.
      out.push_back(
          {{leaning(above, tip_of(model), heading, std::min(tilt, 0.6), 0),
            leaning(above, tip_of(model), heading, tilt, 0), leaning(at, tip_of(model), heading, tilt, 0)},
           0.0});
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

// The ways to make the gesture over a mouth (z up), at most a given distance from its middle. In reserve:
// higher and beside the middle, because something spans the mouth (a kettle's handle).
std::vector<Reach> GestureSkill::ways(const Workbench& bench, std::size_t arm, const Pose& mouth,
                                      double beside, bool reserve) const {
  const auto& model = *bench.scene().find_model_of(held_);
  const Pose grip = bench.held()[arm]->object_in_tool.inverse();
  std::vector<Vector3d> points{mouth.translation()};
  if (reserve) {
    points.clear();
    for (const double share : {1.0, 1.4}) {
      for (const Vector3d& side :
           {Vector3d(1, 0, 0), Vector3d(-1, 0, 0), Vector3d(0, 1, 0), Vector3d(0, -1, 0)})
        points.push_back(mouth * Vector3d(share * beside * side));
    }
  }
  std::vector<Reach> reaches;
  std::size_t tag = reserve ? kReserveTag : 0;
  for (const Vector3d& point : points) {
    const Vector3d higher(0, 0, reserve ? 0.12 : 0.0);
    std::vector<Gesture> gestures;
    if (kind_ == Kind::kScoop) {
      gestures =
          dips(model, point + Vector3d(0, 0, 0.06) + higher, point - Vector3d(0, 0, 0.02), {0.8, 1.1, 0.6});
    } else if (model.cavity) {
      gestures = pours(model, point, grip, reserve);
    } else {
      gestures = dips(model, point + Vector3d(0, 0, 0.10) + higher, point + Vector3d(0, 0, 0.03) + higher,
                      {1.35, 1.5});
    }
    for (const auto& gesture : gestures) {
      Reach reach;
      reach.arm = arm;
      reach.tag = tag++;
      if (failed_.contains(reach.tag)) continue;
      for (const auto& pose : gesture.poses) reach.tool.push_back(pose * grip);
      reach.opening = bench.opening_of(bench.now(), arm);
      reach.preference = gesture.preference;
      reaches.push_back(std::move(reach));
    }
  }
  return reaches;
}

// A scoop of ice cream would not survive it.
bool GestureSkill::another_grip_may_help(const Workbench& bench) const {
  return !bench.world().facts.contains({"state", held_, "ScoopsLeft"});
}

Expected<Phases> GestureSkill::use(Workbench& bench, std::size_t arm) {
  Phases phases;
  Expected<Reach> found = fail(Outcome::kMotionFailed, "");
  if (const auto other = receiver_.empty() ? std::nullopt : bench.arm_holding(receiver_)) {
    const auto& cavity = bench.scene().find_model_of(receiver_)->cavity;
    const auto at = [&](const Pose& held) { return ways(bench, arm, held * cavity->mouth, 0.0, false); };
    found = add_way_with_both(phases, bench, *other, at, what_);
  } else {
    Pose mouth = Pose::Identity();
    double beside = 0;  // [m] from the middle of the mouth where it may still run in
    if (receiver_.empty()) {
      const auto sink = drain(bench.scene());
      if (!sink) return fail(Outcome::kNoPlan, what_ + ": there is no sink here");
      mouth.translation() = *sink;
    } else if (const Pose* pose = bench.world().object(receiver_)) {
      const auto& cavity = *bench.scene().find_model_of(receiver_)->cavity;
      mouth = *pose * cavity.mouth;
      if (mouth.linear()(2, 2) < kUpright)
        return fail(Outcome::kMotionFailed, what_ + ": " + receiver_ + " does not stand upright");
      beside = 0.6 * cavity.radius;
    } else {
      return fail(Outcome::kMotionFailed, what_ + ": " + receiver_ + " cannot be seen");
    }
    StandSearchOptions options;
    options.backwards = !receiver_.empty() && bench.checker().rides(receiver_);
    options.may_drive = !options.backwards;
    for (const bool reserve : {false, true}) {
      const auto reaches = ways(bench, arm, mouth, beside, reserve);
      options.most_reaches = reaches.size();
      if (reserve) options.most_tries = 1'500;
      found = add_way_there(phases, bench, reaches, options, what_, receiver_);
      if (found || found.error().outcome == Outcome::kCancelled || beside == 0) break;
    }
  }
  if (!found) return tl::unexpected<Error>(found.error());
  const Reach reach = *found;
  failed_.insert(reach.tag);
  Phase there = straight(kind_ == Kind::kScoop ? "scoop" : "pour", arm,
                         {reach.tool.begin() + 1, reach.tool.end()}, reach.tolerances, 0.6);
  there.settle = 1.4;  // contents take their time (DeviceRules: half a second to one second)
  if (!receiver_.empty()) expect_unmoved(there, bench, receiver_);
  phases.push_back(there);
  phases.push_back(
      straight("return", arm, {reach.tool.rbegin() + 1, reach.tool.rend()}, reach.tolerances, 0.8));
  return phases;
}

}  // namespace goalnet::manipulation
