#include "components/manipulation/stand_candidates.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace goalnet::manipulation {
namespace {

constexpr double kElsewhere = 0.5;         // [m] from all other targets
constexpr std::size_t kMostElsewhere = 3;  // such targets

double wrap(double angle) { return std::remainder(angle, 2 * std::numbers::pi); }

}  // namespace

std::vector<StandCandidate> stand_candidates(const Workbench& bench, const std::vector<Reach>& reaches,
                                             const StandSearchOptions& options) {
  const Stand here = bench.stand_of(bench.now());
  const auto& model = bench.model();
  double lift_low = 0, lift_high = 0;
  if (!model.lift.empty()) {
    const auto& limits = model.joints[static_cast<std::size_t>(model.index_of(model.lift))].limits;
    lift_low = limits.lower + 0.005;
    lift_high = limits.upper - 0.005;
  }
  std::vector<StandCandidate> out;
  const auto add = [&](const Stand& stand, double cost, bool drives) {
    out.push_back({stand, cost, drives, false});
  };
  std::vector<double> lifts{here.lift};
  for (const double share : {0.95, 0.7, 0.45, 0.2, 0.0})
    lifts.push_back(lift_low + share * (lift_high - lift_low));
  if (!options.may_lift) lifts.resize(1);
  for (const double lift : lifts) {
    Stand stand = here;
    stand.lift = std::clamp(lift, lift_low, lift_high);
    add(stand, std::abs(lift - here.lift) / 0.3, false);
  }
  if (!options.may_drive) return out;
  // Where the target should be seen from the base: ahead, and on the side of the arm.
  struct Target {
    Eigen::Vector3d point;
    double side;
    double preference;
  };
  std::vector<Target> targets;
  for (const auto& reach : reaches) {
    const double side = bench.shoulder_side(reach.arm);
    const Eigen::Vector3d point = reach.tool.back().translation();
    const bool known = std::any_of(targets.begin(), targets.end(), [&](const Target& t) {
      return t.side == side && (t.point - point).norm() < 0.12;
    });
    if (!known && targets.size() < 6) targets.push_back({point, side, reach.preference});
  }
  // Where those are all around one spot, say the rim of one bin however that is turned, others as well.
  const std::size_t near = targets.size();
  for (const auto& reach : reaches) {
    const Eigen::Vector3d point = reach.tool.back().translation();
    const bool known = std::any_of(targets.begin(), targets.end(),
                                   [&](const Target& t) { return (t.point - point).norm() < kElsewhere; });
    if (!known && targets.size() < near + kMostElsewhere)
      targets.push_back({point, bench.shoulder_side(reach.arm), reach.preference});
  }
  for (const auto& target : targets) {
    for (int turn = 0; turn < 24; ++turn) {
      const double yaw = here.yaw + wrap(turn * std::numbers::pi / 12 - here.yaw);
      const Eigen::Rotation2Dd rotation(yaw);
      for (const double ahead : {0.62, 0.70, 0.54, 0.78, 0.86, 0.47, 0.95, 1.04}) {
        for (const double across : {0.2, 0.05, 0.35, -0.1, 0.5, -0.25, 0.65}) {
          const double y = target.side > 0 ? across : -across;
          const Eigen::Vector2d at = target.point.head<2>() - rotation * Eigen::Vector2d(ahead, y);
          const auto& scene = bench.scene();
          if (at.x() < scene.floor_x_min + 0.25 || at.x() > scene.floor_x_max - 0.2 ||
              at.y() < scene.floor_y_min + 0.2 || at.y() > scene.floor_y_max - 0.2) {
            continue;
          }
          const double way =
              std::hypot(at.x() - here.x, at.y() - here.y) / 0.8 + std::abs(yaw - here.yaw) / 1.6;
          const double comfort = 2.0 * std::abs(ahead - 0.64) + 1.5 * std::abs(across - 0.2);
          // Above the target the forearm points down a little: comfortable for both hand and eye.
          const double best = std::clamp(target.point.z() + 0.2 - 0.80, lift_low, lift_high);
          for (const double offset : {0.0, 0.15, -0.15}) {
            const double lift = std::clamp(best + offset, lift_low, lift_high);
            if (offset != 0.0 && std::abs(lift - best) < 0.05) continue;
            add({at.x(), at.y(), yaw, lift}, 1.5 + way + comfort + target.preference + 2 * std::abs(offset),
                true);
          }
        }
      }
    }
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const StandCandidate& a, const StandCandidate& b) { return a.cost < b.cost; });
  return out;
}

}  // namespace goalnet::manipulation
