#include "tools/goalnet/physics_start.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "components/scene/fit.h"

namespace goalnet::tools {
namespace {

using scene::Pose;
using scene::Region;
using scene::Scene;
using scene::Support;

constexpr double kGrid = 0.02;     // [m] between the spots that are looked at
constexpr double kBetween = 0.01;  // [m] between neighbours
constexpr double kDrop = 0.003;    // [m] above what a thing is put onto
constexpr double kForward = 0.12;  // [m] from the middle of a support towards who stands in front of it

std::optional<std::size_t> object_index(const Scene& scene, const std::string& name) {
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    if (scene.objects[i].name == name) return i;
  return std::nullopt;
}

// Upright at `where`, turned as it was.
Pose upright(const Eigen::Vector3d& where, const Pose& before) {
  Pose pose = Pose::Identity();
  pose.translation() = where;
  const Eigen::Vector3d x = before.linear().col(0);
  pose.linear() = Eigen::AngleAxisd(std::atan2(x.y(), x.x()), Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return pose;
}

class Arranger {
 public:
  explicit Arranger(sim::World& world) : world_(world), scene_(world.scene()) {}

  void place(const std::vector<Predicate>& places) {
    waiting_.assign(scene_.objects.size(), false);
    for (const Predicate& fact : places) waiting_[*object_index(scene_, fact.subject)] = true;
    // What stands on furniture first: other things may belong into it.
    for (const bool into_things : {false, true}) {
      for (const Predicate& fact : places) {
        const auto container = object_index(scene_, fact.object);
        if (container.has_value() != into_things) continue;
        const std::size_t thing = *object_index(scene_, fact.subject);
        const auto spot = container ? inside(thing, *container) : free_spot(thing, fact.object);
        if (spot) world_.set_object_pose(thing, upright(*spot, world_.object_pose(thing)));
        waiting_[thing] = false;
      }
    }
  }

 private:
  // Clear of everything that has its place already.
  bool clear(std::size_t thing, const Eigen::Vector3d& at) const {
    const auto& model = scene_.model_of(scene_.objects[thing]);
    for (std::size_t other = 0; other < scene_.objects.size(); ++other) {
      if (other == thing || waiting_[other]) continue;
      const auto& its = scene_.model_of(scene_.objects[other]);
      const Eigen::Vector3d there = world_.object_pose(other).translation();
      const double reach = model.footprint_radius() + its.footprint_radius() + kBetween;
      const bool same_height = there.z() < at.z() + model.height() && at.z() < there.z() + its.height();
      if (same_height && (there - at).head<2>().norm() < reach) return false;
    }
    return true;
  }

  // The free spot nearest to where people put things, on the first support that has one.
  std::optional<Eigen::Vector3d> free_spot(std::size_t thing, const std::string& place) const {
    const auto& model = scene_.model_of(scene_.objects[thing]);
    for (const Region& region : scene_.regions) {
      if (region.name != place && region.within != place) continue;
      const scene::Fixture* fixture = scene_.find_fixture(region.fixture);
      if (fixture == nullptr) continue;
      for (const Support& support : region.supports) {
        if (support.reserved || support.clearance < model.height() + kDrop) continue;
        const Pose frame = fixture->pose * support.frame;
        const double x_room = std::max(0.0, support.size_x / 2 - model.footprint_radius());
        const double y_room = std::max(0.0, support.size_y / 2 - model.footprint_radius());
        std::optional<Eigen::Vector3d> best;
        double nearest = std::numeric_limits<double>::infinity();
        const int nx = static_cast<int>(x_room / kGrid), ny = static_cast<int>(y_room / kGrid);
        for (int i = -nx; i <= nx; ++i)
          for (int j = -ny; j <= ny; ++j) {
            const double distance = std::hypot(i * kGrid + std::min(kForward, x_room), j * kGrid);
            const Eigen::Vector3d at = frame * Eigen::Vector3d(i * kGrid, j * kGrid, kDrop);
            if (distance < nearest && clear(thing, at)) nearest = distance, best = at;
          }
        if (best) return best;
      }
    }
    return std::nullopt;
  }

  // Just above the bottom of the hollow, or above what was put there before; nowhere if it is full.
  std::optional<Eigen::Vector3d> inside(std::size_t thing, std::size_t container) {
    const auto& cavity = scene_.model_of(scene_.objects[container]).cavity;
    const auto& model = scene_.model_of(scene_.objects[thing]);
    if (thing == container || !cavity || cavity->slot) return std::nullopt;
    if (!cavity->shallow() && scene::girth(model) > cavity->radius) return std::nullopt;
    double& filled = filled_[container];  // [m]
    if (filled > 0.0 && filled + model.height() > cavity->depth) return std::nullopt;
    const Pose mouth = world_.object_pose(container) * cavity->mouth;
    const Eigen::Vector3d spot = mouth * Eigen::Vector3d(0, 0, filled + kDrop - cavity->depth);
    filled += model.height() + kDrop;
    return spot;
  }

  sim::World& world_;
  const Scene& scene_;
  std::vector<bool> waiting_;             // has not got its place yet
  std::map<std::size_t, double> filled_;  // [m] by container: how high
};

// Knobs and doors follow their joints; everything else that a device is, is a fact.
void set_states(sim::World& world, const FactSet& start, Contents contents) {
  const Scene& scene = world.scene();
  for (const scene::JointFact& rule : scene.rules.joint_facts) {
    const int joint = world.find_fixture_joint(rule.joint);
    const auto part = scene.find_joint(rule.joint);
    if (joint < 0 || !part) continue;
    const bool on = start.contains(rule.fact);
    world.set_fixture_position(static_cast<std::size_t>(joint),
                               on ? part.part->on_position : part.part->off_position);
  }
  const FactSet before = world.facts();
  for (const Predicate& fact : before) {
    const bool stays = contents == Contents::kAsTheyAre && object_index(scene, fact.subject);
    if (!stays && !start.contains(fact)) world.set_fact(fact, false);
  }
  for (const Predicate& fact : known_facts(start, scene))
    if (fact.relation == "state") world.set_fact(fact, true);
}

// Whether the facts also say which part of the place: in FridgeLeft, and so in the Fridge.
bool said_closer(const Predicate& fact, const std::vector<Predicate>& all, const Scene& scene) {
  return std::any_of(scene.regions.begin(), scene.regions.end(), [&](const Region& region) {
    return region.within == fact.object &&
           std::find(all.begin(), all.end(), Predicate{fact.relation, fact.subject, region.name}) !=
               all.end();
  });
}

// Things that the scene has in that very place stay as they stand there.
bool is_there_already(const Predicate& fact, const Scene& scene) {
  const std::string& on = scene.objects[*object_index(scene, fact.subject)].placement.on;
  return on == fact.object ||
         std::any_of(scene.regions.begin(), scene.regions.end(),
                     [&](const Region& region) { return region.name == on && region.within == fact.object; });
}

}  // namespace

bool is_place(const Predicate& fact) { return fact.relation == "On" || fact.relation == "In"; }

FactSet known_facts(const FactSet& facts, const Scene& scene) {
  const auto known = [&](const std::string& name) {
    return std::binary_search(scene.symbols.begin(), scene.symbols.end(), name);
  };
  std::vector<Predicate> result;
  for (const Predicate& fact : facts) {
    const bool place = is_place(fact) && object_index(scene, fact.subject) && known(fact.object) &&
                       fact.subject != fact.object;
    if (place || (fact.relation == "state" && known(fact.subject))) result.push_back(fact);
  }
  return FactSet(std::move(result));
}

void arrange(sim::World& world, const FactSet& start, Contents contents) {
  const Scene& scene = world.scene();
  std::vector<Predicate> places;
  for (const Predicate& fact : known_facts(start, scene))
    if (is_place(fact)) places.push_back(fact);
  const std::vector<Predicate> all = places;
  std::erase_if(places, [&](const Predicate& fact) {
    return said_closer(fact, all, scene) || is_there_already(fact, scene);
  });
  set_states(world, start, contents);
  Arranger(world).place(places);
}

}  // namespace goalnet::tools
