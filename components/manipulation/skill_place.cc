// keep-on, keep-in, release, stow.
#include <algorithm>
#include <cmath>

#include "components/manipulation/in_the_way.h"
#include "components/manipulation/place_candidates.h"
#include "components/manipulation/skills.h"

namespace goalnet::manipulation {

struct PlaceWay {
  Reach reach;
  Pose object;              // where it should come to rest
  Eigen::Vector3d further;  // where the hand goes after letting go
};

namespace {

constexpr std::size_t kOtherEnd = 1'000'000;  // added to tags
constexpr double kStepBack = 0.35;            // [m]
constexpr int kFirstLook = 1'000;             // iterations for a way onto the tray before stepping back
constexpr double kSmall = 0.30;       // [m] wide: a burner, where nothing is put that has to go somewhere
constexpr double kClear = 0.30;       // [m] around a place that is to be kept clear
constexpr double kElsewhere = 30.0;   // [s] rather aside in the same place than somewhere else
constexpr double kAsideOfTap = 0.20;  // [m] room for what comes under it, and for the hand that holds that

std::vector<PlaceCandidate> candidates_for(Workbench& bench, PlaceSkill::Where where,
                                           const std::string& object, const std::string& region_name,
                                           std::vector<const scene::Region*>& origin) {
  std::vector<PlaceCandidate> out;
  std::vector<const scene::Region*> regions;
  const bool aside = where == PlaceSkill::Where::kAside;
  if (where == PlaceSkill::Where::kRegion || aside) regions = regions_of(bench.scene(), region_name);
  if (where != PlaceSkill::Where::kRegion) {
    for (const auto& region : bench.scene().regions) {
      if (aside && !is_worktop(bench.scene(), region)) continue;
      // Worktops only: nobody wants what is released in the sink or on a burner. What goes aside may stay
      // where it is: the fridge, say.
      if (is_worktop(bench.scene(), region) ||
          (region.name == region_name && region.supports.front().size_y > kSmall))
        regions.push_back(&region);
    }
  }
  const Stand here = bench.stand_of(bench.now());
  for (const auto* region : regions) {
    const auto* fixture = bench.scene().find_fixture(region->fixture);
    for (auto& candidate : place_candidates(bench, object, *region)) {
      if (aside && outlet_near(bench.scene(), *fixture, candidate.object.translation(), kAsideOfTap))
        continue;
      if (where == PlaceSkill::Where::kNearest || region->supports.front().size_y > 1.0) {
        const auto& p = candidate.object.translation();
        candidate.preference += std::hypot(p.x() - here.x, p.y() - here.y);
      }
      if (aside && is_worktop(bench.scene(), *region)) candidate.preference += kElsewhere;
      out.push_back(candidate);
      origin.push_back(region);
    }
  }
  return out;
}

// Spots on the floor around where the hand is now: for what stands on the floor.
std::vector<PlaceCandidate> floor_candidates(Workbench& bench, const std::string& object) {
  std::vector<PlaceCandidate> out;
  const Eigen::Vector3d here = bench.world().object(object)->translation();
  for (const double away : {0.0, 0.25, 0.5, 0.8}) {
    for (int direction = 0; direction < (away > 0 ? 8 : 1); ++direction) {
      const double angle = direction * M_PI / 4;
      for (int h = 0; h < 12; ++h) {
        PlaceCandidate c;
        c.object.translation() = here + away * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0);
        c.object.translation().z() = 0.002;
        c.object.linear() = Eigen::AngleAxisd(h * M_PI / 6, Eigen::Vector3d::UnitZ()).toRotationMatrix();
        c.approaches = {Eigen::Vector3d::UnitZ() * 0.10};
        c.preference = away;
        if (bench.checker().object_fits(object, c.object, 0.03, {"floor"})) out.push_back(c);
      }
    }
  }
  return out;
}

// Slots of the tray, seen from where the robot stands now.
std::vector<PlaceCandidate> tray_candidates(Workbench& bench, const std::string& object) {
  std::vector<PlaceCandidate> out;
  const auto& tray = bench.model().tray;
  if (!tray) return out;
  const Pose frame = bench.kinematics().forward(bench.now(), bench.kinematics().link_index(tray->link));
  for (std::size_t i = 0; i < tray->slots.size(); ++i) {
    for (int h = 0; h < 12; ++h) {
      PlaceCandidate c;
      c.object = frame * Eigen::Translation3d(tray->slots[i].position + Eigen::Vector3d(0, 0, 0.003)) *
                 Eigen::AngleAxisd(h * M_PI / 6, Eigen::Vector3d::UnitZ());
      c.approaches = {Eigen::Vector3d::UnitZ() * 0.12};
      if (bench.checker().object_fits(object, c.object, 0.008, {})) out.push_back(c);
    }
  }
  return out;
}

std::vector<PlaceWay> ways(Workbench& bench, std::size_t arm, const std::vector<PlaceCandidate>& candidates,
                           const std::vector<const scene::Region*>& origin, const Pose& turn) {
  std::vector<PlaceWay> out;
  const Pose grip = bench.held()[arm]->object_in_tool.inverse();
  const Eigen::Vector3d higher(0, 0, let_go_height(bench, arm, turn));
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    auto c = candidates[i];
    c.object = moved(c.object, higher) * turn;
    PlaceWay way;
    way.object = c.object;
    way.reach.arm = arm;
    for (const auto& offset : c.approaches) way.reach.tool.push_back(moved(c.object, offset) * grip);
    way.reach.tool.push_back(c.object * grip);
    way.reach.opening = bench.opening_of(bench.now(), arm);
    way.reach.preference = c.preference;
    way.reach.tag = i;
    way.further = c.approaches.size() > 1 ? Eigen::Vector3d(c.approaches.front() - c.approaches.back())
                                          : Eigen::Vector3d::Zero();
    if (i < origin.size() && origin[i] != nullptr) {
      // The object ends 2 mm above what carries it: nearer than any margin.
      way.reach.tolerances.allow(bench.checker().attachment(arm), bench.checker().body(origin[i]->fixture),
                                 -0.001);
    }
    if (i < origin.size() && origin[i] == nullptr)
      way.reach.tolerances.allow(bench.checker().attachment(arm), bench.checker().body("floor"), -0.001);
    if (origin.empty() && bench.model().tray) {
      const int tray = bench.kinematics().link_index(bench.model().tray->link);
      way.reach.tolerances.allow_self(tray, bench.checker().attachment(arm), -0.001);
    }
    out.push_back(std::move(way));
  }
  return out;
}

std::vector<Reach> reaches_of(const std::vector<PlaceWay>& ways) {
  std::vector<Reach> reaches;
  for (const auto& way : ways) reaches.push_back(way.reach);
  return reaches;
}

bool runs(const Workbench& bench, const scene::FillRule& outlet) {
  return std::ranges::all_of(outlet.when,
                             [&](const Predicate& fact) { return bench.world().facts.contains(fact); });
}

// Whether a thing that no hand holds keeps another from standing at a place, however that is turned.
bool stands_on(const Workbench& bench, const std::string& thing, const Pose& place,
               const std::string& other) {
  const Pose* pose = bench.world().object(thing);
  if (pose == nullptr || bench.arm_holding(thing) || bench.checker().rides(thing)) return false;
  for (int h = 0; h < 8; ++h) {
    const Pose turned =
        moved(place, {0, 0, 0.006}) * Eigen::AngleAxisd(h * M_PI / 4, Eigen::Vector3d::UnitZ());
    if (bench.checker().object_clears(other, turned, thing, kPlaceGap)) return false;
  }
  return true;
}

// Whether the empty hand would get away from where it let go: a little way back, along its fingers.
bool gets_away(const Workbench& bench, const Configuration& start, std::size_t arm,
               const ArmPositions& last) {
  constexpr double kAway = 0.06;  // [m]
  const Pose back = backed(bench.arm(arm).forward(last), kAway);
  const auto away = bench.arm(arm).follow(back, last, 1.5);
  if (!away) return false;
  PartSet parts = bench.checker().arm_parts(arm);
  std::erase(parts, bench.checker().attachment(arm));
  const CollisionQuery query{&parts, bench.params().contact_margin, nullptr, true};
  return !bench.checker().collides(bench.with_arm(start, arm, *away), query);
}

}  // namespace

// What is filled there goes where the water runs; what is in the way there, standing or lying, goes aside.
std::unique_ptr<Skill> PlaceSkill::make_room(const Workbench& bench, std::string& occupant) const {
  const auto& scene = bench.scene();
  const auto* model = scene.find_model_of(held_);
  if (where_ != Where::kRegion || !model->cavity || !model->cavity->liquid || model->cavity->shallow())
    return nullptr;
  for (const auto* region : regions_of(scene, region_)) {
    const auto* fixture = scene.find_fixture(region->fixture);
    for (const auto& spot : region->spots) {
      const Pose at = fixture->pose * spot.frame;
      const auto* outlet = outlet_near(scene, *fixture, at.translation(), 0.02);
      // With both hands full it is worth putting something down only if water runs already.
      if (outlet == nullptr || !(has_free_hand(bench) || runs(bench, *outlet))) continue;
      for (const auto& object : scene.objects) {
        if (object.name == held_ || !stands_on(bench, object.name, at, held_)) continue;
        occupant = object.name;
        return std::make_unique<PlaceSkill>(object.name, Where::kAside, region_);
      }
    }
  }
  return nullptr;
}

// Off what the robot stands before, arms tucked: between boards an arm has no way to the tray.
Expected<Phases> PlaceSkill::step_back(Workbench& bench) {
  stepped_back_ = true;
  ReachSolution solution;
  solution.drives = true;
  solution.stand = bench.stand_of(bench.now());
  solution.stand.x -= kStepBack * std::cos(solution.stand.yaw);
  solution.stand.y -= kStepBack * std::sin(solution.stand.yaw);
  Phases phases;
  add_back_off(phases, bench);
  add_go_to(phases, bench, solution);
  failed_.clear();  // they failed there
  only_prepared_ = true;
  return phases;
}

// Whether the thing would stand under water that runs now, and can take it.
bool PlaceSkill::runs_into(const Workbench& bench, const PlaceWay& way) const {
  const auto& cavity = bench.scene().find_model_of(held_)->cavity;
  if (where_ != Where::kRegion || !cavity || !cavity->liquid || cavity->shallow()) return false;
  for (const auto* region : regions_of(bench.scene(), region_)) {
    const auto& fixture = *bench.scene().find_fixture(region->fixture);
    const auto* outlet = outlet_near(bench.scene(), fixture, way.object.translation(), 0.02);
    if (outlet != nullptr && runs(bench, *outlet)) return true;
  }
  return false;
}

// By what is free now; those that failed already are left out.
std::vector<PlaceWay> PlaceSkill::find_ways(Workbench& bench, std::size_t arm, const Pose* turn) const {
  std::vector<const scene::Region*> origin;
  // What stood on the floor at the start is put down there.
  const bool on_floor = where_ == Where::kNearest && bench.scene().find_object(held_)->placement.on.empty();
  const auto candidates = where_ == Where::kTray ? tray_candidates(bench, held_)
                          : on_floor             ? floor_candidates(bench, held_)
                                                 : candidates_for(bench, where_, held_, region_, origin);
  if (on_floor) origin.resize(candidates.size());
  auto all = ways(bench, arm, candidates, origin, turn != nullptr ? *turn : Pose::Identity());
  if (turn != nullptr)
    for (PlaceWay& way : all) way.reach.tag += kOtherEnd;
  std::erase_if(all, [&](const PlaceWay& w) {
    const bool near = keep_clear_ && (w.object.translation() - *keep_clear_).head<2>().norm() < kClear;
    return near || failed_.contains(w.reach.tag);
  });
  return all;
}

Expected<Phases> PlaceSkill::use(Workbench& bench, std::size_t arm) {
  if (where_ == Where::kTray && !failed_.empty() && !stepped_back_ && !bench.supposes())
    return step_back(bench);
  std::vector<PlaceWay> all = find_ways(bench, arm);
  const bool streams = std::ranges::any_of(all, [&](const PlaceWay& w) { return runs_into(bench, w); });
  if (failed_.empty() && !bench.supposes() && !did_with_less_) wants_stream_ = streams;
  if (wants_stream_) std::erase_if(all, [&](const PlaceWay& w) { return !runs_into(bench, w); });
  const std::vector<Reach> reaches = reaches_of(all);
  StandSearchOptions options;
  options.may_drive = where_ != Where::kTray;
  options.backwards = where_ == Where::kTray;
  options.looks_for_obstacles = false;  // spots that are taken are not among these ways
  // Onto the tray from between boards there is none; two steps back it is found soon.
  if (where_ == Where::kTray && !stepped_back_) options.iterations = kFirstLook;
  Phases phases;
  const StandSearchOptions anyhow = options;
  options.accept = [&](const Configuration& start, const Reach& reach, const auto& along) {
    return gets_away(bench, start, reach.arm, along.back());
  };
  Expected<Reach> found = fail(
      Outcome::kMotionFailed, "no free place for " + held_ + (region_.empty() ? "" : " in or on " + region_));
  if (!reaches.empty()) {
    found = add_way_there(phases, bench, reaches, options, what_);
    if (!found && found.error().outcome == Outcome::kMotionFailed)
      found = add_way_there(phases, bench, reaches, anyhow, what_);
  }
  // Held by its foot, it stands on its other end, if nothing runs out of it.
  const bool may_turn = std::ranges::none_of(bench.world().facts, [&](const Predicate& fact) {
    return fact.relation == "state" && fact.subject == held_;
  });
  const auto turn = may_turn ? other_end(*bench.scene().find_model_of(held_)) : std::nullopt;
  if (!found && found.error().outcome == Outcome::kMotionFailed && turn && where_ != Where::kTray) {
    all = find_ways(bench, arm, &*turn);
    if (auto way = add_way_there(phases, bench, reaches_of(all), options, what_)) found = std::move(way);
  }
  if (!found && found.error().outcome == Outcome::kMotionFailed && !bench.supposes()) {
    std::vector<Reach> wanted;
    {
      const ThingsAway scope(bench);
      wanted = reaches_of(find_ways(bench, arm));
    }
    if (auto what = find_in_the_way(bench, wanted, anyhow)) bench.note_in_the_way(std::move(what));
  }
  if (!found) return tl::unexpected<Error>(found.error());
  failed_.insert(found->tag);
  const PlaceWay way =
      *std::find_if(all.begin(), all.end(), [&](const PlaceWay& w) { return w.reach.tag == found->tag; });
  Phase lower = straight("put down", arm, {way.reach.tool.begin() + 1, way.reach.tool.end()},
                         way.reach.tolerances, 0.6);
  lower.settle = 0.1;
  phases.push_back(lower);
  Tolerances touch;
  touch.allow_all(bench.checker().hand_parts(arm), bench.checker().body(held_));
  add_let_go(phases, bench, arm, 0.03, touch, way.further);
  Phase& last = phases.back();
  last.settle = 0.2;
  last.check = [object = held_, target = way.object,
                tray = where_ == Where::kTray](Workbench& b) -> Expected<void> {
    const Pose* now = b.world().object(object);
    if (now == nullptr) return fail(Outcome::kMotionFailed, object + " cannot be seen after it was put down");
    const double off = (now->translation() - target.translation()).norm();
    if (off > (tray ? 0.08 : 0.05)) {
      return fail(Outcome::kMotionFailed, object + " did not stay where it was put: it is " +
                                              std::to_string(static_cast<int>(off * 100)) + " cm away");
    }
    if (now->linear().col(2).dot(target.linear().col(2)) < std::cos(0.5))
      return fail(Outcome::kMotionFailed, object + " fell over when it was put down");
    return {};
  };
  return phases;
}

}  // namespace goalnet::manipulation
