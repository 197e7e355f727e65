#include "components/manipulation/place_candidates.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "components/scene/fit.h"

namespace goalnet::manipulation {
namespace {

constexpr double kAbove = 0.002;  // [m] let go this high above the surface: touching earlier would push
constexpr double kFingerThickness = 0.014;  // [m]
constexpr double kFingers = 0.006;          // [m] finger tips stay this high above it
// [m] above the surface on the way in from the front; low under a low ceiling
constexpr double kRaised[] = {0.03, 0.012};

struct Spot {
  Pose pose;  // map frame, on the surface
  double preference;
  bool covered = false;  // by a board or the like: what is tall cannot come from above
};

void add_grid(const scene::Support& support, const Pose& frame, double radius, double base,
              std::vector<Spot>& spots) {
  const double half_x = support.size_x / 2 - radius - 0.005, half_y = support.size_y / 2 - radius - 0.005;
  // A burner is smaller than a pot: its middle is always a spot.
  const int nx = half_x > 0.04 ? 1 + static_cast<int>(half_x * 2 / 0.09) : 0;
  const int ny = half_y > 0.04 ? 1 + static_cast<int>(half_y * 2 / 0.11) : 0;
  for (int i = 0; i <= nx; ++i) {
    for (int j = 0; j <= ny; ++j) {
      const double x = nx == 0 ? 0.0 : -half_x + 2 * half_x * i / nx;
      const double y = ny == 0 ? 0.0 : -half_y + 2 * half_y * j / ny;
      Spot spot{frame, base, support.clearance > 0.01};
      spot.pose.translation() += frame.linear() * Eigen::Vector3d(x, y, 0);
      // In small places the middle is best (a door may hit what stands before it); on worktops the near part
      // is.
      const double want_x = support.size_x > 0.5 && support.clearance < 0.01 ? -0.12 : -0.04;
      spot.preference += 2.0 * std::abs(x - want_x) + (support.size_y < 1.0 ? 1.0 * std::abs(y) : 0.0);
      spots.push_back(spot);
    }
  }
}

}  // namespace

const scene::FillRule* outlet_near(const scene::Scene& scene, const scene::Fixture& fixture,
                                   const Eigen::Vector3d& point, double distance) {
  const Eigen::Vector3d at = fixture.pose.inverse() * point;
  for (const auto& rule : scene.rules.fills) {
    if (rule.fixture == fixture.name && rule.part.empty() && (rule.outlet - at).head<2>().norm() < distance)
      return &rule;
  }
  return nullptr;
}

double let_go_height(const Workbench& bench, std::size_t arm, const Pose& turn) {
  const auto& gripper = bench.model().arms[arm].gripper;
  const Pose tool = turn * bench.held()[arm]->object_in_tool.inverse();  // in the object's frame, upright
  const double outside = 0.5 * bench.opening_of(bench.now(), arm) + kFingerThickness;
  double lowest = kAbove;
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-1.0, 1.0}) {
      const Eigen::Vector3d corner(x * gripper.pad_width, y * outside, gripper.tip);
      lowest = std::min(lowest, (tool * corner).z() - kFingers);
    }
  }
  return kAbove - lowest;
}

std::optional<Pose> other_end(const scene::ObjectModel& model) {
  constexpr double kLevel = 0.003;  // [m] between parts that it would stand on
  constexpr double kWide = 0.7;     // of its width that those must have
  constexpr double kFlat = 0.5;     // of its width, its height: what is lower has an up side
  const auto box = scene::bounds(model.shapes);
  const Eigen::Vector3d size = box.upper - box.lower;
  if (model.cavity || size.z() < kFlat * size.head<2>().maxCoeff()) return std::nullopt;
  std::vector<scene::Shape> top;
  for (const auto& shape : model.shapes)
    if (scene::bounds({shape}).upper.z() > box.upper.z() - kLevel) top.push_back(shape);
  const auto end = scene::bounds(top);
  if (((end.upper - end.lower).head<2>().array() < kWide * size.head<2>().array()).any()) return std::nullopt;
  const Eigen::Vector3d middle = 0.5 * (box.lower + box.upper);
  return Pose(Eigen::Translation3d(middle) * Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX()) *
              Eigen::Translation3d(-middle));
}

Pose support_pose(const scene::Scene& scene, const scene::Region& region, const scene::Support& support) {
  const auto* fixture = scene.find_fixture(region.fixture);
  return (fixture ? fixture->pose : Pose::Identity()) * support.frame;
}

std::vector<const scene::Region*> regions_of(const scene::Scene& scene, const std::string& name) {
  std::vector<const scene::Region*> out;
  for (const auto& region : scene.regions) {
    if (region.name == name) return {&region};
    if (region.within == name) out.push_back(&region);
  }
  return out;
}

std::vector<PlaceCandidate> place_candidates(Workbench& bench, const std::string& object,
                                             const scene::Region& region, int headings) {
  std::vector<PlaceCandidate> out;
  const auto& scene = bench.scene();
  const auto* model = scene.find_model_of(object);
  const auto* fixture = scene.find_fixture(region.fixture);
  if (model == nullptr || fixture == nullptr) return out;
  const double radius = model->footprint_radius();
  std::vector<Spot> spots;
  for (const auto& spot : region.spots) {
    const bool meant = std::any_of(spot.prefer_for.begin(), spot.prefer_for.end(),
                                   [&](const std::string& p) { return model->has_property(p); }) ||
                       (model->cavity && model->cavity->liquid && !model->cavity->shallow() &&
                        outlet_near(scene, *fixture, fixture->pose * spot.frame.translation(), 0.02));
    if (!spot.prefer_for.empty() && !meant) continue;
    // What is meant for a spot goes there, nearly whatever the way costs.
    spots.push_back({fixture->pose * spot.frame, meant ? -20.0 : -0.5, false});
  }
  double later = 0.0;
  for (const auto& support : region.supports) {
    if (support.reserved ||
        (support.clearance > 0.01 && support.clearance < model->height() + scene::kHeadroom))
      continue;
    add_grid(support, support_pose(scene, region, support), radius, later, spots);
    later += 1.0;  // the next shelf
  }
  // Things come from above; in closed places, and under boards if need be, from the front, a little raised.
  const double depth = region.supports.front().size_x / 2;
  for (const auto& spot : spots) {
    PlaceCandidate place;
    const Eigen::Vector3d in_front = fixture->pose.inverse() * spot.pose.translation();
    const Eigen::Vector3d back = -fixture->pose.linear().col(0);
    std::vector<std::vector<Eigen::Vector3d>> approaches;
    const bool closed = region.relation == scene::RegionRelation::kIn;
    if (!closed) approaches = {{Eigen::Vector3d::UnitZ() * 0.10}};
    const Eigen::Vector3d before = back * std::max(0.15, std::min(depth * 2, in_front.x()) + 0.08);
    for (const double raised : kRaised) {
      const Eigen::Vector3d up = Eigen::Vector3d::UnitZ() * raised;
      if (closed || spot.covered) approaches.push_back({up + before, up});
    }
    for (int h = 0; h < headings; ++h) {
      place.object = spot.pose;
      place.object.linear() =
          spot.pose.linear() *
          Eigen::AngleAxisd(2 * std::numbers::pi * h / headings, Eigen::Vector3d::UnitZ()).toRotationMatrix();
      place.object.translation().z() += kAbove;
      Pose probe = place.object;
      probe.translation().z() += 0.004;
      // The surface itself is nearer than the gap, so look for neighbours with a raised object and its own
      // fixture left out.
      if (!bench.checker().object_fits(object, probe, kPlaceGap, {region.fixture}) ||
          !bench.checker().object_fits(object, probe, 0.001, {})) {
        continue;
      }
      for (std::size_t i = 0; i < approaches.size(); ++i) {
        place.approaches = approaches[i];
        place.preference = spot.preference + 1.5 * static_cast<double>(i);
        out.push_back(place);
      }
    }
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const auto& a, const auto& b) { return a.preference < b.preference; });
  return out;
}

}  // namespace goalnet::manipulation
