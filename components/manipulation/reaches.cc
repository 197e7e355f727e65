// Ways to reach things with the hands, from the affordances of the scene.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "components/manipulation/grasp_candidates.h"
#include "components/manipulation/place_candidates.h"
#include "components/manipulation/shape_grasps.h"
#include "components/manipulation/skills.h"

namespace goalnet::manipulation {

bool has_free_hand(const Workbench& bench) {
  return std::ranges::any_of(bench.held(), [](const auto& hand) { return !hand; });
}

bool is_worktop(const scene::Scene& scene, const scene::Region& region) {
  constexpr double kWide = 1.0, kRises = 0.08;  // [m]
  const scene::Support& top = region.supports.front();
  const auto* fixture = scene.find_fixture(region.fixture);
  if (region.relation != scene::RegionRelation::kOn || top.size_y < kWide || fixture == nullptr) return false;
  // Not between the arms of a couch: what stands close to one is hard to take from its side.
  const double height = top.frame.translation().z();
  return std::ranges::none_of(fixture->shapes, [&](const scene::Shape& shape) {
    const bool rises = scene::bounds({shape}).upper.z() > height + kRises;
    const double across = (top.frame.inverse() * shape.pose).translation().y();
    return rises && std::abs(across) > top.size_y / 2;
  });
}

const scene::Region* region_around(const Workbench& bench, const Pose& object) {
  for (const auto& region : bench.scene().regions) {
    for (const auto& support : region.supports) {
      const Eigen::Vector3d p = support_pose(bench.scene(), region, support).inverse() * object.translation();
      if (std::abs(p.x()) < support.size_x / 2 && std::abs(p.y()) < support.size_y / 2 && p.z() > -0.03 &&
          p.z() < std::max(support.clearance, 0.15)) {
        return &region;
      }
    }
  }
  return nullptr;
}

std::vector<Reach> grasp_reaches(Workbench& bench, const std::string& object, bool by_shape) {
  std::vector<Reach> out;
  const auto* model = bench.scene().find_model_of(object);
  const Pose* pose = bench.world().object(object);
  if (model == nullptr || pose == nullptr) return out;
  const auto* region = region_around(bench, *pose);
  const bool inside = region != nullptr && region->relation == scene::RegionRelation::kIn;
  const auto* fixture = region ? bench.scene().find_fixture(region->fixture) : nullptr;
  const int body = bench.checker().body(object);
  for (std::size_t arm = 0; arm < bench.arm_count(); ++arm) {
    if (bench.held()[arm]) continue;
    const auto& gripper = bench.model().arms[arm].gripper;
    const auto candidates =
        by_shape ? shape_grasps(*model, *pose, gripper) : grasp_candidates(model->grasps, gripper);
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const auto& c = candidates[i];
      Reach reach;
      reach.arm = arm;
      const Pose tool = *pose * c.tool;
      if (inside && fixture != nullptr) {
        const Eigen::Vector3d out_of = -fixture->pose.linear().col(0) * 0.25;
        const Pose raised = moved(tool, {0, 0, 0.03});
        reach.tool = {backed(tool, bench.params().approach_distance), tool, raised, moved(raised, out_of)};
      } else {
        reach.tool = {backed(tool, bench.params().approach_distance), tool,
                      moved(tool, {0, 0, bench.params().lift_height})};
      }
      reach.tolerances.allow_all(bench.checker().hand_parts(arm), body);
      reach.opening = c.opening;
      reach.width = c.width;
      reach.preference = c.preference;
      reach.tag = arm * 10'000 + i + (by_shape ? kByShape : 0);
      out.push_back(std::move(reach));
    }
  }
  return out;
}

std::vector<Reach> front_reaches(Workbench& bench, const std::string& place) {
  std::vector<Reach> out;
  const auto& scene = bench.scene();
  const auto regions = regions_of(scene, place);
  std::string fixture_name = regions.empty() ? place : regions.front()->fixture;
  if (const auto ref = scene.find_part(place)) fixture_name = ref.fixture->name;
  const auto* fixture = scene.find_fixture(fixture_name);
  if (fixture == nullptr) return out;
  // Points just before the front edge: before each support (long worktops at several places), else the
  // middle.
  std::vector<Eigen::Vector3d> points;
  for (const auto* region : regions) {
    const auto& support = region->supports.front();
    const int n = std::max(1, static_cast<int>(support.size_y / 0.5));
    for (int i = 0; i < n; ++i) {
      const double y = n == 1 ? 0.0 : -support.size_y / 2 + support.size_y * (i + 0.5) / n;
      const Eigen::Vector3d p = support.frame * Eigen::Vector3d(0, y, 0);
      points.emplace_back(-0.20, p.y(), std::clamp(p.z() + 0.2, 0.9, 1.25));
    }
  }
  if (points.empty()) points.emplace_back(-0.20, 0.0, 1.05);
  for (std::size_t arm = 0; arm < bench.arm_count(); ++arm) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      Reach reach;
      reach.arm = arm;
      Pose tool = Pose::Identity();
      tool.translation() = points[i];
      tool.linear() << 0, 0, 1, 0, 1, 0, -1, 0, 0;  // z ahead, y sideways
      reach.tool = {fixture->pose * tool};
      if (reach.tool.front().translation().z() > 0.0) out.push_back(reach);
    }
  }
  return out;
}

std::vector<Reach> part_reaches(Workbench& bench, const scene::Scene::PartRef& ref) {
  std::vector<Reach> out;
  const Pose part = scene::part_pose(*ref.fixture, *ref.part,
                                     [&](const std::string& joint) { return bench.world().joint(joint); });
  const int body = bench.checker().body(ref.part->name);
  for (std::size_t arm = 0; arm < bench.arm_count(); ++arm) {
    if (bench.held()[arm]) continue;
    const auto candidates = grasp_candidates(ref.part->grasps, bench.model().arms[arm].gripper, 24);
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      Reach reach;
      reach.arm = arm;
      const Pose tool = part * candidates[i].tool;
      reach.tool = {backed(tool, bench.params().approach_distance), tool};
      reach.tolerances.allow_all(bench.checker().hand_parts(arm), body);
      reach.opening = candidates[i].opening;
      reach.preference = candidates[i].preference;
      reach.tag = arm * 10'000 + i;
      out.push_back(std::move(reach));
    }
  }
  return out;
}

std::vector<Reach> press_reaches(Workbench& bench, const scene::Scene::PartRef& ref) {
  std::vector<Reach> out;
  if (!ref.part->push) return out;
  const Pose part = scene::part_pose(*ref.fixture, *ref.part,
                                     [&](const std::string& joint) { return bench.world().joint(joint); });
  const Pose push = part * *ref.part->push;
  for (std::size_t arm = 0; arm < bench.arm_count(); ++arm) {
    if (bench.held()[arm]) continue;
    const double tip = bench.model().arms[arm].gripper.tip;
    const double travel = ref.part->on_position + 0.0015;
    for (int turn = 0; turn < 8; ++turn) {
      // The tool's z along the push direction x, at eight turns about it; fingers closed.
      Pose tool = push;
      Eigen::Matrix3d axes;
      axes << push.linear().col(1), push.linear().col(2), push.linear().col(0);
      tool.linear() =
          axes * Eigen::AngleAxisd(turn * std::numbers::pi / 4, Eigen::Vector3d::UnitZ()).toRotationMatrix();
      Reach reach;
      reach.arm = arm;
      reach.tool = {backed(tool, tip + 0.07), backed(tool, tip - travel)};
      reach.tolerances.allow_all(bench.checker().hand_parts(arm), bench.checker().body(ref.part->name));
      for (const int hand : bench.checker().hand_parts(arm)) {
        // The tips end where the button is flush with what carries it.
        reach.tolerances.allow(hand, bench.checker().body(ref.fixture->name), -0.003);
        if (ref.part->parent >= 0) {
          const auto& parent = ref.fixture->parts[static_cast<std::size_t>(ref.part->parent)];
          reach.tolerances.allow(hand, bench.checker().body(parent.name), -0.003);
        }
      }
      reach.opening = 0.0;
      reach.preference = 0.05 * turn;
      reach.tag = arm * 100 + static_cast<std::size_t>(turn);
      out.push_back(std::move(reach));
    }
  }
  return out;
}

std::vector<Reach> spot_reaches(Workbench& bench, const scene::ButtonRule& spot) {
  constexpr double kDeep = 0.001;  // [m] into the surface: felt, and gentle
  std::vector<Reach> out;
  const Pose* thing = bench.world().object(spot.object);
  if (thing == nullptr) return out;
  for (std::size_t arm = 0; arm < bench.arm_count(); ++arm) {
    if (bench.held()[arm]) continue;
    const double tip = bench.model().arms[arm].gripper.tip;
    for (int turn = 0; turn < 12; ++turn) {
      Pose tool = *thing;
      tool.linear() = thing->linear() * Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX()) *
                      Eigen::AngleAxisd(turn * std::numbers::pi / 6, Eigen::Vector3d::UnitZ());
      tool.translation() = *thing * spot.at;
      Reach reach;
      reach.arm = arm;
      reach.tool = {backed(tool, tip + 0.07), backed(tool, tip - kDeep)};
      reach.tolerances.allow_all(bench.checker().hand_parts(arm), bench.checker().body(spot.object));
      reach.opening = 0.0;
      reach.preference = 0.05 * turn;
      reach.tag = arm * 100 + static_cast<std::size_t>(turn);
      out.push_back(std::move(reach));
    }
  }
  return out;
}

}  // namespace goalnet::manipulation
