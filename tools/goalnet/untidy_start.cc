#include "tools/goalnet/untidy_start.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "components/goalnet/random.h"
#include "components/scene/fit.h"

namespace goalnet::tools {
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using scene::ObjectModel;
using scene::Pose;
using scene::Region;
using scene::RegionRelation;
using scene::Scene;
using scene::Support;

// What happens to a thing: shares of all things.
constexpr double kStays = 0.30, kPushed = 0.30;  // the others go somewhere else
constexpr double kToFloor = 0.15;                // of those
constexpr double kTipped = 0.35;                 // of the tall things among those
constexpr double kTippedInPlace = 0.15;          // of the tall things that are pushed

constexpr double kPush = 0.08, kPushInside = 0.03;  // [m] at most, on furniture and in it
constexpr double kSpare = 0.01;                     // [m] between neighbours
constexpr double kAbove = 0.003;                    // [m] above what a thing is put onto
constexpr double kBesideFurniture = 0.06;           // [m] on the floor
constexpr double kAroundRobot = 0.55;               // [m] free floor around its middle
constexpr int kTries = 40;

bool is_tall(const ObjectModel& model) { return model.height() > 1.2 * model.footprint_radius(); }

// The radius of what it covers of the surface, about the middle of it.
double cover(const ObjectModel& model, bool lying) {
  return lying ? std::hypot(model.height() / 2, scene::girth(model)) : model.footprint_radius();
}

class Mess {
 public:
  Mess(sim::World& world, std::uint64_t seed) : world_(world), scene_(world.scene()), random_(seed) {}

  void make() {
    for (std::size_t i = 0; i < scene_.objects.size(); ++i) {
      const double fate = random_.uniform();
      if (fate < kStays) continue;
      const ObjectModel& model = scene_.model_of(scene_.objects[i]);
      const bool pushed = fate < kStays + kPushed;
      const bool lying = is_tall(model) && random_.uniform() < (pushed ? kTippedInPlace : kTipped);
      const bool on_floor = random_.uniform() < kToFloor;
      for (int n = 0; n < kTries; ++n) {
        const auto spot = pushed ? push(i, lying) : on_floor ? floor(lying, model) : surface(lying, model);
        const double height = lying ? 2 * scene::girth(model) : model.height();
        if (!spot || !clear(i, *spot, cover(model, lying)) ||
            in_furniture(*spot, cover(model, lying), height))
          continue;
        world_.set_object_pose(i, pose_at(*spot, model, lying));
        break;
      }
    }
  }

 private:
  double between(double low, double high) { return low + (high - low) * random_.uniform(); }

  // Somewhere on a support, all of the thing on it; nothing if there is no room for it.
  std::optional<Vector3d> on_support(const Pose& frame, const Support& support, double radius,
                                     double height) {
    const double x = support.size_x / 2 - radius, y = support.size_y / 2 - radius;
    const bool fits = support.clearance < 0.01 || support.clearance > height + scene::kHeadroom;
    if (support.reserved || !fits || x < 0 || y < 0) return std::nullopt;
    return frame * Vector3d(between(-x, x), between(-y, y), 0);
  }

  // On furniture, large surfaces more often than small ones.
  std::optional<Vector3d> surface(bool lying, const ObjectModel& model) {
    std::vector<std::pair<const Region*, const Support*>> all;
    std::vector<double> until;
    for (const Region& region : scene_.regions) {
      if (region.relation != RegionRelation::kOn) continue;
      for (const Support& support : region.supports) {
        all.emplace_back(&region, &support);
        until.push_back((until.empty() ? 0.0 : until.back()) + std::sqrt(support.size_x * support.size_y));
      }
    }
    const double at = between(0.0, until.back());
    const auto chosen = std::lower_bound(until.begin(), until.end(), at) - until.begin();
    const auto& [region, support] = all[static_cast<std::size_t>(chosen)];
    return on_support(scene_.find_fixture(region->fixture)->pose * support->frame, *support,
                      cover(model, lying), lying ? 2 * scene::girth(model) : model.height());
  }

  std::optional<Vector3d> floor(bool lying, const ObjectModel& model) {
    const Vector3d at(between(scene_.floor_x_min, scene_.floor_x_max),
                      between(scene_.floor_y_min, scene_.floor_y_max), 0);
    if ((at - scene_.robot_start).head<2>().norm() < kAroundRobot) return std::nullopt;
    const double radius = cover(model, lying) + kBesideFurniture;
    for (const auto& fixture : scene_.fixtures) {
      const auto box = scene::bounds(fixture.shapes);
      const Vector3d inside = fixture.pose.inverse() * at;
      const Vector3d nearest = inside.cwiseMax(box.lower).cwiseMin(box.upper);
      if ((nearest - inside).head<2>().norm() < radius) return std::nullopt;
    }
    return at;
  }

  // A little aside, on what it stands on.
  std::optional<Vector3d> push(std::size_t object, bool lying) {
    const ObjectModel& model = scene_.model_of(scene_.objects[object]);
    const Vector3d before = world_.object_pose(object).translation();
    const Region* region = scene_.find_region(scene_.objects[object].placement.on);
    const bool inside = region != nullptr && region->relation == RegionRelation::kIn;
    const double most = inside ? kPushInside : kPush;
    const Vector3d at = before + Vector3d(between(-most, most), between(-most, most), 0);
    if (region == nullptr) return at;
    for (const Support& support : region->supports) {
      const Vector3d in = (scene_.find_fixture(region->fixture)->pose * support.frame).inverse() * at;
      const double radius = cover(model, lying);
      const bool on = std::abs(in.x()) < support.size_x / 2 - radius &&
                      std::abs(in.y()) < support.size_y / 2 - radius && std::abs(in.z()) < 0.02;
      if (on && !support.reserved) return at;
    }
    return std::nullopt;
  }

  // Of what furniture keeps for itself (cutlery lies across two bars), and of all other things, wherever they
  // are now.
  bool clear(std::size_t object, const Vector3d& at, double radius) const {
    const double height = scene_.model_of(scene_.objects[object]).height();
    for (const Region& region : scene_.regions) {
      for (const Support& support : region.supports) {
        const Vector3d in = (scene_.find_fixture(region.fixture)->pose * support.frame).inverse() * at;
        if (support.reserved && std::abs(in.x()) < support.size_x / 2 + radius &&
            std::abs(in.y()) < support.size_y / 2 + radius && std::abs(in.z()) < height)
          return false;
      }
    }
    for (std::size_t other = 0; other < scene_.objects.size(); ++other) {
      if (other == object) continue;
      const auto& model = scene_.model_of(scene_.objects[other]);
      const Pose pose = world_.object_pose(other);
      const bool lies = pose.linear()(2, 2) < 0.7;
      const Vector3d middle = pose * Vector3d(0, 0, lies ? model.height() / 2 : 0);
      const bool same_height = middle.z() < at.z() + height && at.z() < middle.z() + model.height();
      if (same_height && (middle - at).head<2>().norm() < radius + cover(model, lies) + kSpare) return false;
    }
    return true;
  }

  // Whether it would stand or lie in what is built onto furniture: a rack, an armrest, a tap.
  bool in_furniture(const Vector3d& at, double radius, double height) const {
    for (const auto& fixture : scene_.fixtures) {
      const Vector3d in = fixture.pose.inverse() * at;
      for (const auto& shape : fixture.shapes) {
        const auto box = scene::bounds({shape});
        if (box.upper.z() < in.z() + kAbove || box.lower.z() > in.z() + height) continue;
        const Vector2d nearest = in.cwiseMax(box.lower).cwiseMin(box.upper).head<2>();
        if ((nearest - in.head<2>()).norm() < radius) return true;
      }
    }
    return false;
  }

  // Lying: on its +x side, its middle over the spot.
  Pose pose_at(const Vector3d& spot, const ObjectModel& model, bool lying) {
    Pose pose = Pose::Identity();
    pose.linear() = AngleAxisd(between(-std::numbers::pi, std::numbers::pi), Vector3d::UnitZ()).matrix();
    pose.translation() = spot + Vector3d(0, 0, kAbove);
    if (!lying) return pose;
    pose.linear() = pose.linear() * AngleAxisd(std::numbers::pi / 2, Vector3d::UnitY()).matrix();
    pose.translation().z() += scene::bounds(model.shapes).upper.x();
    pose.translation() -= pose.linear() * Vector3d(0, 0, model.height() / 2);
    return pose;
  }

  sim::World& world_;
  const Scene& scene_;
  inference::Random random_;
};

}  // namespace

void make_untidy(sim::World& world, std::uint64_t seed) { Mess(world, seed).make(); }

}  // namespace goalnet::tools
