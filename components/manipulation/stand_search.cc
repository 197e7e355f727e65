#include "components/manipulation/stand_search.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace goalnet::manipulation {
namespace {

constexpr double kMinConditioning =
    0.04;                      // smallest singular value at the first pose: keep away from singularities
constexpr double kGap = 0.05;  // [m] wanted between the robot's trunk and furniture; less if need be

struct Candidate {
  Stand stand;
  double cost = 0;
  bool drives = true;
};

double wrap(double angle) { return std::remainder(angle, 2 * std::numbers::pi); }

// Robot configuration as it will be at a stand: other arms tucked if the base moves.
Configuration posture_at(const Workbench& bench, const Stand& stand, bool drives) {
  Configuration q = bench.with_stand(bench.now(), stand);
  if (!drives) return q;
  for (std::size_t arm = 0; arm < bench.arm_count(); ++arm) {
    if (const auto carry = bench.carry_posture(arm)) q = bench.with_arm(q, arm, *carry);
  }
  return q;
}

std::vector<Candidate> candidates(const Workbench& bench, const std::vector<Reach>& reaches,
                                  const StandSearchOptions& options) {
  const Stand here = bench.stand_of(bench.now());
  const auto& model = bench.model();
  double lift_low = 0, lift_high = 0;
  if (!model.lift.empty()) {
    const auto& limits = model.joints[static_cast<std::size_t>(model.index_of(model.lift))].limits;
    lift_low = limits.lower + 0.005;
    lift_high = limits.upper - 0.005;
  }
  std::vector<Candidate> out;
  const auto add = [&](const Stand& stand, double cost, bool drives) {
    out.push_back({stand, cost, drives});
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
  for (const auto& target : targets) {
    for (int turn = 0; turn < 24; ++turn) {
      const double yaw = here.yaw + wrap(turn * std::numbers::pi / 12 - here.yaw);
      const Eigen::Rotation2Dd rotation(yaw);
      for (const double ahead : {0.62, 0.70, 0.54, 0.78, 0.86, 0.47}) {
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
                   [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
  return out;
}

class Search {
 public:
  Search(Workbench& bench, const std::vector<Reach>& reaches, const StandSearchOptions& options)
      : bench_(bench), reaches_(reaches), options_(options) {
    for (std::size_t i = 0; i < reaches.size(); ++i) order_.push_back(i);
    hand_fits_.resize(reaches.size());
    std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
      return reaches_[a].preference < reaches_[b].preference;
    });
  }

  // Tries the reaches of places [from, to) among those within arm's length.
  std::optional<ReachSolution> try_stand(const Candidate& candidate, std::size_t from, std::size_t to) {
    const Configuration q = posture_at(bench_, candidate.stand, candidate.drives);
    bench_.checker().ignore_riding(candidate.drives);
    if (candidate.drives) {
      const CollisionQuery trunk{&bench_.checker().trunk_parts(), kGap, nullptr, false};
      if (bench_.checker().collides(q, trunk)) return std::nullopt;
      const CollisionQuery all{&bench_.checker().all_parts(), bench_.params().drive_margin, nullptr, true};
      if (bench_.checker().collides(q, all)) return std::nullopt;
    }
    // Raising the lift takes the other arms along.
    std::vector<bool> blocked(bench_.arm_count(), false);
    if (!candidate.drives && std::abs(candidate.stand.lift - bench_.stand_of(bench_.now()).lift) > 1e-4) {
      for (std::size_t arm = 0; arm < blocked.size(); ++arm) {
        const CollisionQuery query{&bench_.checker().arm_parts(arm), bench_.params().contact_margin, nullptr,
                                   true};
        blocked[arm] = bench_.checker().collides(q, query);
      }
    }
    const auto others_are_free = [&](std::size_t arm) {
      for (std::size_t other = 0; other < blocked.size(); ++other)
        if (other != arm && blocked[other]) return false;
      return true;
    };
    std::size_t place = 0;
    for (const std::size_t index : order_) {
      if (place >= to || tries_ >= options_.most_tries) break;
      if (!others_are_free(reaches_[index].arm)) continue;
      if (options_.stand_only) {
        ++tries_;
        if (options_.accept && !options_.accept(q, reaches_[index], {})) continue;
        return ReachSolution{candidate.stand, candidate.drives, index, {}};
      }
      if (!within_length(q, reaches_[index]) || !hand_fits(index) || place++ < from) continue;
      if (auto along = try_reach(q, reaches_[index])) {
        return ReachSolution{candidate.stand, candidate.drives, index, std::move(*along)};
      }
    }
    return std::nullopt;
  }

 private:
  // Quick no: too far, or reaching back towards oneself.
  bool within_length(const Configuration& stand, const Reach& reach) const {
    const Pose first = bench_.arm_base_pose(stand, reach.arm).inverse() * reach.tool.front();
    return first.translation().norm() < 1.15 && (options_.backwards || first.linear()(0, 2) > -0.35);
  }

  // Quick no: where the hand should be there is something already, wherever the robot stands. Found out once,
  // when asked.
  bool hand_fits(std::size_t index) {
    auto& known = hand_fits_[index];
    if (known) return *known;
    const Reach& reach = reaches_[index];
    const Configuration q = bench_.with_fingers(bench_.now(), reach.arm, reach.opening);
    const CollisionChecker& checker = bench_.checker();
    bool fits = !checker.hand_collides(q, reach.arm, reach.tool.front(), bench_.params().margin, {});
    for (std::size_t i = 1; i < reach.tool.size() && fits; ++i) {
      fits = !checker.hand_collides(q, reach.arm, reach.tool[i], bench_.params().contact_margin,
                                    reach.tolerances);
    }
    known = fits;
    return fits;
  }

  std::optional<std::vector<ArmPositions>> try_reach(const Configuration& stand, const Reach& reach) {
    const Configuration q = bench_.with_fingers(stand, reach.arm, reach.opening);
    const Pose base = bench_.arm_base_pose(q, reach.arm);
    const Pose first = base.inverse() * reach.tool.front();
    ++tries_;
    // Long ways (the arc of a door) mostly fail at their far end: ask for that first, it is cheap.
    if (reach.tool.size() > 2) {
      for (const std::size_t k : {reach.tool.size() - 1, reach.tool.size() / 2}) {
        const Pose far = base.inverse() * reach.tool[k];
        if (far.translation().norm() > 1.15) return std::nullopt;
        if (bench_.arm(reach.arm).solve(far, bench_.arm_of(q, reach.arm), 8, 0.0).empty())
          return std::nullopt;
      }
    }
    const auto& arm = bench_.arm(reach.arm);
    const ArmPositions seed = bench_.arm_of(q, reach.arm);
    const CollisionQuery query{&bench_.checker().arm_parts(reach.arm), bench_.params().margin, nullptr, true};
    int tried = 0;
    ArmPositions last{};
    for (const auto& start : arm.solve(first, seed, 16, 0.05)) {
      if (tried > 0 && robot::largest_step(start, last) < 0.2) continue;
      if (tried >= 10) break;
      if (bench_.checker().collides(bench_.with_arm(q, reach.arm, start), query)) {
        last = start;
        ++tried;
        continue;
      }
      if (arm.conditioning(start) < kMinConditioning) continue;
      last = start;
      ++tried;
      const std::vector<Pose> rest(reach.tool.begin() + 1, reach.tool.end());
      auto along = bench_.follow(q, reach.arm, start, rest, reach.tolerances, bench_.params().contact_margin);
      if (!along) continue;
      if (options_.accept && !options_.accept(bench_.with_arm(q, reach.arm, start), reach, *along)) continue;
      return along;
    }
    return std::nullopt;
  }

  Workbench& bench_;
  const std::vector<Reach>& reaches_;
  const StandSearchOptions& options_;
  std::vector<std::size_t> order_;
  std::vector<std::optional<bool>> hand_fits_;  // by reach; empty: not looked at yet
  std::size_t tries_ = 0;
};

}  // namespace

Expected<ReachSolution> find_stand(Workbench& bench, const std::vector<Reach>& reaches,
                                   const StandSearchOptions& options) {
  if (reaches.empty())
    return fail(Outcome::kMotionFailed, "there is no way to take hold of it or to put it there");
  Search search(bench, reaches, options);
  // First only the best ways everywhere: a better stand is found sooner than a contorted reach from this one.
  constexpr std::size_t kBest = 24;
  const auto stands = candidates(bench, reaches, options);
  const std::pair<std::size_t, std::size_t> passes[] = {{0, kBest}, {kBest, options.most_reaches}};
  for (const auto& [from, to] : passes) {
    if (from >= std::min(to, reaches.size())) continue;
    for (const auto& stand : stands) {
      if (bench.stopped()) return fail(Outcome::kCancelled, "cancelled while looking for a place to stand");
      auto solution = search.try_stand(stand, from, to);
      bench.checker().ignore_riding(false);
      if (solution) return std::move(*solution);
    }
  }
  return fail(Outcome::kMotionFailed,
              "no place to stand from which a hand reaches it without touching something");
}

}  // namespace goalnet::manipulation
