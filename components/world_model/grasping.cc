#include "components/world_model/grasping.h"

#include <algorithm>
#include <limits>

#include "components/world_model/geometry.h"

namespace goalnet::world_model {
namespace {

constexpr double kHandRange = 0.4;  // [m] objects with their origin farther from the tool are not looked at

}  // namespace

Grasping::Grasping(const scene::Scene& scene, const robot::RobotModel& robot, const Params& params)
    : scene_(scene),
      robot_(robot),
      params_(params),
      candidates_(robot.arms.size()),
      held_(robot.arms.size()) {}

std::optional<double> Grasping::finger_gap(std::size_t arm, const HandView& hand, std::size_t object,
                                           const ObjectView& view) const {
  const robot::Gripper& gripper = robot_.arms[arm].gripper;
  const scene::Pose to_object = view.pose.inverse() * hand.tool;
  const double slack = params_.finger_gap.exit;
  const Interval between{-hand.second - slack, hand.first + slack};
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  // Lines from pad to pad, over the area of the pads.
  for (const double across : {-0.4, 0.0, 0.4})
    for (const double along : {-0.8, 0.0, 0.8}) {
      const Eigen::Vector3d start =
          to_object * Eigen::Vector3d(across * gripper.pad_width, 0.0, along * gripper.tip);
      const Eigen::Vector3d direction = to_object.linear().col(1);
      for (const scene::Shape& shape : scene_.model_of(scene_.objects[object]).shapes) {
        if (!shape.solid) continue;
        const auto inside = intersect(shape, start, direction, between);
        if (!inside) continue;
        lowest = std::min(lowest, inside->low);
        highest = std::max(highest, inside->high);
      }
    }
  if (lowest > highest) return std::nullopt;
  return std::max({0.0, hand.first - highest, lowest + hand.second});
}

void Grasping::update(std::int64_t time_ns, const std::vector<HandView>& hands,
                      const std::vector<ObjectView>& objects) {
  for (std::size_t arm = 0; arm < held_.size(); ++arm) {
    const HandView& hand = hands[arm];
    Candidate& candidate = candidates_[arm];
    std::optional<std::size_t> best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; hand.known && i < objects.size(); ++i) {
      if (!objects[i].known || (objects[i].pose.translation() - hand.tool.translation()).norm() > kHandRange)
        continue;
      const auto gap = finger_gap(arm, hand, i, objects[i]);
      if (!gap || !with_hysteresis(held_[arm] == i, *gap, params_.finger_gap) || *gap >= least) continue;
      // Once held, an object is not given up for another one that happens to touch the fingers too.
      best = i;
      least = held_[arm] == i ? -1.0 : *gap;
    }
    if (!best) {
      candidate = {};
      held_[arm].reset();
      continue;
    }
    const Eigen::Vector3d in_hand = hand.tool.inverse() * objects[*best].pose.translation();
    const bool same = candidate.object == best && (in_hand - candidate.in_hand).norm() <= params_.grip_slip;
    if (!same) candidate.since_ns = time_ns;
    candidate.object = best;
    candidate.in_hand = in_hand;
    if (held_[arm] == best) continue;
    held_[arm].reset();
    if (1e-9 * static_cast<double>(time_ns - candidate.since_ns) >= params_.grip_time) held_[arm] = best;
  }
}

}  // namespace goalnet::world_model
