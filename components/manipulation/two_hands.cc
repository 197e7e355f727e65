#include "components/manipulation/two_hands.h"

#include <algorithm>
#include <cmath>

namespace goalnet::manipulation {
namespace {

constexpr int kMostTries = 12'000;  // bounds the time of a search in vain (about 0.1 ms each)

struct Place {
  Stand stand;
  bool drives = false;
};

std::vector<Place> places(const Workbench& bench) {
  const Stand here = bench.stand_of(bench.now());
  std::vector<Place> out{{here, false}};
  for (const double back : {0.3, 0.5, 0.75}) {
    for (const double turn : {0.0, 0.8, -0.8, 1.6, -1.6, 2.4, -2.4, 3.1}) {
      Stand stand = here;
      stand.x -= back * std::cos(here.yaw);
      stand.y -= back * std::sin(here.yaw);
      stand.yaw += turn;
      out.push_back({stand, true});
    }
  }
  return out;
}

class Search {
 public:
  Search(Workbench& bench, std::size_t holder, const WaysAt& ways)
      : bench_(bench), holder_(holder), ways_(ways) {}

  std::optional<TwoHandSolution> at(const Place& place) {
    const auto& checker = bench_.checker();
    Configuration q = bench_.with_stand(bench_.now(), place.stand);
    if (place.drives) {
      for (std::size_t arm = 0; arm < bench_.arm_count(); ++arm) {
        if (const auto carry = bench_.carry_posture(arm)) q = bench_.with_arm(q, arm, *carry);
      }
      const CollisionQuery all{&checker.all_parts(), bench_.params().drive_margin, nullptr, true};
      if (checker.collides(q, all)) return std::nullopt;
    }
    const HeldObject& held = *bench_.held()[holder_];
    const Pose base = bench_.arm_base_pose(q, holder_);
    const Pose now = base.inverse() * bench_.tool_pose(q, holder_) * held.object_in_tool;
    const double heading = std::atan2(now.linear()(1, 0), now.linear()(0, 0));
    const double side = bench_.shoulder_side(holder_) > 0 ? 1.0 : -1.0;
    for (const double turn : {0.0, 0.6, -0.6, 1.2, -1.2, 2.0, -2.0}) {
      for (const double ahead : {0.50, 0.42, 0.58}) {
        for (const double across : {0.10, 0.02, 0.18}) {
          for (const double up : {-0.20, -0.08, 0.04}) {
            if (tries_ > (bench_.supposes() ? kMostTries / 10 : kMostTries) || bench_.stopped())
              return std::nullopt;
            Pose object = Pose::Identity();
            object.linear() = Eigen::AngleAxisd(heading + turn, Eigen::Vector3d::UnitZ()).toRotationMatrix();
            object.translation() = Eigen::Vector3d(ahead, side * across, up);
            if (auto found = held_at(q, place, base * object)) return found;
          }
        }
      }
    }
    return std::nullopt;
  }

  int tries() const { return tries_; }

 private:
  std::optional<TwoHandSolution> held_at(const Configuration& q, const Place& place, const Pose& object) {
    const auto& arm = bench_.arm(holder_);
    const Pose tool = bench_.arm_base_pose(q, holder_).inverse() * object *
                      bench_.held()[holder_]->object_in_tool.inverse();
    const CollisionQuery query{&bench_.checker().arm_parts(holder_), bench_.params().margin, nullptr, true};
    ++tries_;
    for (const auto& posture : arm.solve(tool, bench_.arm_of(q, holder_), 6, 0.05)) {
      const Configuration out = bench_.with_arm(q, holder_, posture);
      if (bench_.checker().collides(out, query)) continue;
      auto reaches = ways_(object);
      std::stable_sort(reaches.begin(), reaches.end(),
                       [](const Reach& a, const Reach& b) { return a.preference < b.preference; });
      const std::size_t most = std::min<std::size_t>(reaches.size(), 48);
      for (std::size_t i = 0; i < most; ++i) {
        if (auto along = work(out, reaches[i])) {
          return TwoHandSolution{
              {place.stand, place.drives, i, std::move(*along)}, std::move(reaches), holder_, posture};
        }
      }
      break;  // another elbow would not give the other arm much more room
    }
    return std::nullopt;
  }

  std::optional<std::vector<ArmPositions>> work(const Configuration& out, const Reach& reach) {
    ++tries_;
    const Configuration q = bench_.with_fingers(out, reach.arm, reach.opening);
    const auto& arm = bench_.arm(reach.arm);
    const Pose base = bench_.arm_base_pose(q, reach.arm);
    if ((base.inverse() * reach.tool.front()).translation().norm() > 1.15) return std::nullopt;
    const CollisionQuery query{&bench_.checker().arm_parts(reach.arm), bench_.params().contact_margin,
                               &reach.tolerances, true};
    int tried = 0;
    for (const auto& start :
         arm.solve(base.inverse() * reach.tool.front(), bench_.arm_of(q, reach.arm), 12, 0.05)) {
      if (++tried > 6) break;
      if (bench_.checker().collides(bench_.with_arm(q, reach.arm, start), query)) continue;
      const std::vector<Pose> rest(reach.tool.begin() + 1, reach.tool.end());
      auto along = bench_.follow(q, reach.arm, start, rest, reach.tolerances, bench_.params().contact_margin);
      if (along) return along;
    }
    return std::nullopt;
  }

  Workbench& bench_;
  std::size_t holder_;
  const WaysAt& ways_;
  int tries_ = 0;
};

}  // namespace

Expected<TwoHandSolution> find_two_hands(Workbench& bench, std::size_t holder, const WaysAt& ways) {
  Search search(bench, holder, ways);
  for (const Place& place : places(bench)) {
    if (bench.stopped()) return fail(Outcome::kCancelled, "cancelled while looking how to hold it out");
    bench.checker().ride_along(place.drives);
    auto solution = search.at(place);
    bench.checker().ride_along(false);
    if (solution) return std::move(*solution);
  }
  return fail(Outcome::kMotionFailed, "the two hands do not get at it together without touching something");
}

Expected<Reach> add_way_with_both(Phases& phases, Workbench& bench, std::size_t holder, const WaysAt& ways,
                                  const std::string& what) {
  const auto both = find_two_hands(bench, holder, ways);
  if (!both) return fail(both.error().outcome, what + ": " + both.error().message);
  const Reach& reach = both->reaches[both->work.reach];
  add_back_off(phases, bench);
  add_go_to(phases, bench, both->work);
  Phase phase;
  phase.stage = "hold out";
  phase.plan = [holder, posture = both->held_out, lift = both->work.stand.lift](Workbench& b) {
    return b.move_arm(holder, posture, lift);
  };
  phases.push_back(phase);
  add_approach(phases, both->work, reach);
  return reach;
}

}  // namespace goalnet::manipulation
