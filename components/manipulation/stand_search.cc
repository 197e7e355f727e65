#include "components/manipulation/stand_search.h"

#include "components/manipulation/stand_candidates.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

namespace goalnet::manipulation {
namespace {

constexpr double kMinConditioning =
    0.04;                      // smallest singular value at the first pose: keep away from singularities
constexpr double kGap = 0.05;  // [m] wanted between the robot's trunk and furniture; less if need be

// A way that worked from none of so many stands makes room for others: it may be impossible from anywhere.
constexpr int kMostFailures = 60;

class Search {
 public:
  Search(Workbench& bench, const std::vector<Reach>& reaches, const StandSearchOptions& options)
      : bench_(bench),
        reaches_(reaches),
        options_(options),
        most_tries_(bench.supposes() ? options.most_tries / 10 : options.most_tries),
        most_failures_(bench.supposes() ? kMostFailures / 10 : kMostFailures),
        driving_(bench.now()) {
    for (std::size_t i = 0; i < reaches.size(); ++i) order_.push_back(i);
    failures_.resize(reaches.size(), 0);
    hand_fits_.resize(reaches.size());
    std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
      return reaches_[a].preference < reaches_[b].preference;
    });
    if (!options.may_drive) return;
    for (std::size_t arm = 0; arm < bench.arm_count(); ++arm) {
      if (bench.hindered(arm)) continue;  // it may stay where it is
      if (const auto carry = bench.carry_posture(arm)) driving_ = bench.with_arm(driving_, arm, *carry);
    }
  }

  // Tries the reaches of places [from, to) among those within arm's length. From the cheapest question to the
  // dearest: lengths, room for the hand, the robot's own room, inverse kinematics, collisions along the way.
  std::optional<ReachSolution> try_stand(StandCandidate& candidate, std::size_t from, std::size_t to) {
    if (candidate.in_the_way) return std::nullopt;
    const Configuration q = bench_.with_stand(candidate.drives ? driving_ : bench_.now(), candidate.stand);
    const std::vector<std::size_t> chosen = options_.stand_only ? order_ : within_length(q, from, to);
    if (chosen.empty()) return std::nullopt;
    within_reach_ = true;
    bench_.checker().ride_along(candidate.drives);
    candidate.in_the_way = candidate.drives && has_no_room(q, candidate.stand);
    if (candidate.in_the_way) return std::nullopt;
    has_room_ = true;
    const std::vector<bool> blocked = blocked_by_lifting(q, candidate);
    for (const std::size_t index : chosen) {
      if (tries_ >= most_tries_) break;
      const Reach& reach = reaches_[index];
      bool free = true;
      for (std::size_t arm = 0; arm < blocked.size(); ++arm)
        free = free && (arm == reach.arm || !blocked[arm]);
      if (!free) continue;
      if (options_.stand_only) {
        ++tries_;
        if (options_.accept && !options_.accept(q, reach, {})) continue;
        return ReachSolution{candidate.stand, candidate.drives, index, {}};
      }
      if (auto along = try_reach(q, reach))
        return ReachSolution{candidate.stand, candidate.drives, index, std::move(*along)};
      ++failures_[index];
    }
    return std::nullopt;
  }

  // Why no stand will do, for people.
  std::string reason() const {
    if (!within_reach_) return "it is beyond the arms' reach from everywhere the robot could stand";
    if (!has_room_) return "the robot has no room to stand where it could be reached";
    return "no place to stand from which a hand reaches it without touching something";
  }
  // The same where no hand has room: what is too near.
  std::string crowd() const {
    std::map<std::string, int> counts;
    for (const Reach& reach : reaches_) {
      const Configuration q = bench_.with_fingers(bench_.now(), reach.arm, reach.opening);
      for (std::size_t i = 0; i < reach.tool.size(); ++i) {
        const double margin = i == 0 ? bench_.params().margin : bench_.params().contact_margin;
        const auto name = bench_.checker().hand_obstacle(q, reach.arm, reach.tool[i], margin,
                                                         i == 0 ? Tolerances() : reach.tolerances);
        if (name.empty()) continue;
        ++counts[name];
        break;
      }
    }
    std::vector<std::pair<int, std::string>> most;
    for (const auto& [name, count] : counts) most.emplace_back(-count, name);
    std::sort(most.begin(), most.end());
    std::string text = "there is no room for the hand and what it holds";
    for (std::size_t i = 0; i < std::min<std::size_t>(2, most.size()); ++i)
      text += (i == 0 ? ": too near to " : " and ") + most[i].second;
    return text;
  }

  bool exhausted() const { return tries_ >= most_tries_; }

  // Forgets the reaches whose hand has no room, and says whether any are left: if not, no stand will do.
  bool any_hand_fits() {
    if (!options_.stand_only) std::erase_if(order_, [&](std::size_t index) { return !hand_fits(index); });
    return !order_.empty();
  }

 private:
  std::vector<std::size_t> within_length(const Configuration& q, std::size_t from, std::size_t to) {
    std::vector<Pose> bases;
    for (std::size_t arm = 0; arm < bench_.arm_count(); ++arm)
      bases.push_back(bench_.arm_base_pose(q, arm).inverse());
    std::vector<std::size_t> chosen;
    std::size_t place = 0;
    for (const std::size_t index : order_) {
      if (place >= to) break;
      const Reach& reach = reaches_[index];
      const Pose first = bases[reach.arm] * reach.tool.front();
      // Too far, or reaching back towards oneself.
      if (first.translation().norm() >= 1.15 || (!options_.backwards && first.linear()(0, 2) <= -0.35))
        continue;
      if (failures_[index] < most_failures_ && hand_fits(index) && place++ >= from) chosen.push_back(index);
    }
    return chosen;
  }

  // Whether the robot, ready to drive, would be too near to something there.
  bool has_no_room(const Configuration& q, const Stand& stand) const {
    if (bench_.leads_nowhere(stand)) return true;
    const CollisionQuery trunk{&bench_.checker().trunk_parts(), kGap, nullptr, false};
    const CollisionQuery all{&bench_.checker().all_parts(), bench_.params().drive_margin, nullptr, true};
    return bench_.checker().collides(q, trunk) || bench_.checker().collides(q, all);
  }

  // Raising the lift takes the other arms along: those that would touch something.
  std::vector<bool> blocked_by_lifting(const Configuration& q, const StandCandidate& candidate) const {
    std::vector<bool> blocked(bench_.arm_count(), false);
    const bool lifts = std::abs(candidate.stand.lift - bench_.stand_of(bench_.now()).lift) > 1e-4;
    for (std::size_t arm = 0; arm < blocked.size() && lifts && !candidate.drives; ++arm) {
      const CollisionQuery query{&bench_.checker().arm_parts(arm), bench_.params().contact_margin, nullptr,
                                 true};
      blocked[arm] = bench_.checker().collides(q, query);
    }
    return blocked;
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
      if (bench_.leads_nowhere(bench_.stand_of(stand), reach.arm, start)) continue;
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
  const std::size_t most_tries_;
  const int most_failures_;                     // of one reach
  Configuration driving_;                       // as now, arms as they are while the base moves
  std::vector<std::size_t> order_;              // reaches, best first
  std::vector<int> failures_;                   // by reach: stands from which it did not work
  std::vector<std::optional<bool>> hand_fits_;  // by reach; empty: not looked at yet
  std::size_t tries_ = 0;
  bool within_reach_ = false, has_room_ = false;  // from or at any stand
};

Expected<ReachSolution> search_stand(Workbench& bench, const std::vector<Reach>& reaches,
                                     const StandSearchOptions& options) {
  if (reaches.empty())
    return fail(Outcome::kMotionFailed, "there is no way to take hold of it or to put it there");
  Search search(bench, reaches, options);
  // First only the best ways everywhere: a better stand is found sooner than a contorted reach from this one.
  constexpr std::size_t kBest = 24;
  auto stands = stand_candidates(bench, reaches, options);
  const std::pair<std::size_t, std::size_t> passes[] = {{0, kBest}, {kBest, options.most_reaches}};
  bool pruned = false;
  for (const auto& [from, to] : passes) {
    if (from >= std::min(to, reaches.size())) continue;
    for (auto& stand : stands) {
      if (bench.stopped()) return fail(Outcome::kCancelled, "cancelled while looking for a place to stand");
      if (search.exhausted()) break;
      auto solution = search.try_stand(stand, from, to);
      bench.checker().ride_along(false);
      if (solution) return std::move(*solution);
      if (!std::exchange(pruned, true) && !search.any_hand_fits())
        return fail(Outcome::kMotionFailed, search.crowd());
    }
  }
  return fail(Outcome::kMotionFailed, search.reason());
}

}  // namespace

Expected<ReachSolution> find_stand(Workbench& bench, const std::vector<Reach>& reaches,
                                   const StandSearchOptions& options) {
  std::vector<std::size_t> unhindered;
  for (std::size_t i = 0; i < reaches.size(); ++i)
    if (!bench.hindered(reaches[i].arm)) unhindered.push_back(i);
  if (!unhindered.empty() && unhindered.size() < reaches.size()) {
    std::vector<Reach> some;
    for (const std::size_t i : unhindered) some.push_back(reaches[i]);
    auto solution = search_stand(bench, some, options);
    if (solution) solution->reach = unhindered[solution->reach];
    if (solution || solution.error().outcome == Outcome::kCancelled) return solution;
  }
  return search_stand(bench, reaches, options);
}

}  // namespace goalnet::manipulation
