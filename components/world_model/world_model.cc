#include "components/world_model/world_model.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "components/scene/fit.h"
#include "components/world_model/geometry.h"

namespace goalnet::world_model {
namespace {

// Joint positions are kept a while, so that poses find the joints of their own moment.
constexpr std::size_t kJointHistory = 16;
// [ns] updates closer together than this do not tell speeds.
constexpr std::int64_t kShortest = 1'000'000;

// "left" -> "LeftHand".
std::string hand_name(std::string arm) {
  if (!arm.empty()) arm[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(arm[0])));
  return arm + "Hand";
}

}  // namespace

WorldModel::WorldModel(const scene::Scene& scene, const robot::RobotModel& robot, Params params)
    : scene_(scene),
      robot_(robot),
      params_(std::move(params)),
      kinematics_(robot),
      support_(scene, params_),
      nearness_(scene, params_),
      grasping_(scene, robot, params_),
      devices_(scene),
      tracked_(scene.objects.size()),
      hands_(robot.arms.size()),
      objects_(scene.objects.size()) {
  for (std::size_t i = 0; i < scene.objects.size(); ++i) object_index_[scene.objects[i].name] = i;
  for (std::size_t i = 0; i < robot.joints.size(); ++i) joint_index_[robot.joints[i].name] = i;
  base_link_ = kinematics_.link_index(robot.base.link);
  for (const robot::Arm& arm : robot.arms) tool_links_.push_back(kinematics_.link_index(arm.tool_link));
  if (robot.tray && !robot.tray->slots.empty()) {
    tray_link_ = kinematics_.link_index(robot.tray->link);
    tray_.lower.setConstant(std::numeric_limits<double>::infinity());
    tray_.upper = -tray_.lower;
    for (const robot::TraySlot& slot : robot.tray->slots) {
      tray_.lower = tray_.lower.cwiseMin(slot.position.head<2>() - 0.5 * slot.size);
      tray_.upper = tray_.upper.cwiseMax(slot.position.head<2>() + 0.5 * slot.size);
    }
  }
  std::set<std::string> names(scene.symbols.begin(), scene.symbols.end());
  for (const scene::Object& object : scene.objects) names.insert(object.name);
  world_.objects.assign(names.begin(), names.end());
  for (auto& [thing, place] : scene::unfit_pairs(scene)) unfit_.push_back({"Unfit", thing, place});
}

std::size_t WorldModel::observe(const ObservedPoses& poses) {
  if (poses_time_ns_ && poses.time_ns < *poses_time_ns_) return poses.objects.size();
  std::size_t ignored = 0;
  for (const ObservedPose& observed : poses.objects) {
    const auto found = object_index_.find(observed.name);
    if (found == object_index_.end()) {
      // Moving parts of fixtures come along; they are known by their joints.
      if (!scene_.find_part(observed.name)) ++ignored;
      continue;
    }
    if (!is_finite(observed.pose)) {
      ++ignored;
      continue;
    }
    tracked_[found->second].pose = observed.pose;
    tracked_[found->second].seen_ns = poses.time_ns;
  }
  poses_time_ns_ = poses.time_ns;
  return ignored;
}

std::size_t WorldModel::observe(const ObservedJoints& joints) {
  if (joints.names.size() != joints.positions.size()) return joints.names.size();
  // Doors may be told of by somebody whose clock or pace differs: only the robot's joints have an order here.
  const bool late = joints_time_ns_ && joints.time_ns < *joints_time_ns_;
  bool moved = false;
  JointMoment moment{joints.time_ns,
                     joint_history_.empty() ? robot_.home() : joint_history_.back().positions};
  std::size_t ignored = 0;
  for (std::size_t i = 0; i < joints.names.size(); ++i) {
    if (!std::isfinite(joints.positions[i])) {
      ++ignored;
      continue;
    }
    const auto found = joint_index_.find(joints.names[i]);
    if (found == joint_index_.end()) {
      devices_.set_joint(joints.names[i], joints.positions[i]);
    } else if (late) {
      ++ignored;
    } else {
      moment.positions[found->second] = joints.positions[i];
      moved = true;
    }
  }
  if (!moved) return ignored;
  joint_history_.push_back(std::move(moment));
  if (joint_history_.size() > kJointHistory) joint_history_.pop_front();
  joints_time_ns_ = joints.time_ns;
  return ignored;
}

std::size_t WorldModel::observe(const std::vector<ObservedState>& states) {
  return devices_.set_states(states);
}

std::int64_t WorldModel::time_ns() const {
  return complete() ? std::min(*poses_time_ns_, *joints_time_ns_) : 0;
}

const std::vector<double>& WorldModel::joints_at(std::int64_t time_ns) const {
  const auto nearest = std::min_element(
      joint_history_.begin(), joint_history_.end(), [&](const JointMoment& a, const JointMoment& b) {
        return std::abs(a.time_ns - time_ns) < std::abs(b.time_ns - time_ns);
      });
  return nearest->positions;
}

const WorldState& WorldModel::update() {
  if (!complete()) return world_;
  view_robot();
  view_objects();
  grasping_.update(*poses_time_ns_, hands_, objects_);
  for (const auto& held : grasping_.held())
    if (held) objects_[*held].held = true;
  support_.update(objects_, tray_);
  // On the tray is carried as well.
  for (std::size_t i = 0; i < objects_.size(); ++i)
    if (support_.places()[i].kind == Place::Kind::kTray) objects_[i].held = true;
  nearness_.update(base_, objects_, support_.places());
  collect_facts();
  return world_;
}

void WorldModel::view_robot() {
  kinematics_.forward(joints_at(*poses_time_ns_), links_);
  const std::vector<double>& positions = joints_at(*poses_time_ns_);
  if (base_link_ >= 0) base_ = links_[static_cast<std::size_t>(base_link_)];
  tray_.present = tray_link_ >= 0;
  if (tray_.present) tray_.pose = links_[static_cast<std::size_t>(tray_link_)];
  for (std::size_t arm = 0; arm < hands_.size(); ++arm) {
    const robot::Gripper& gripper = robot_.arms[arm].gripper;
    hands_[arm].known = tool_links_[arm] >= 0 && !gripper.fingers.empty();
    if (!hands_[arm].known) continue;
    hands_[arm].tool = links_[static_cast<std::size_t>(tool_links_[arm])];
    const auto opening = [&](const std::string& finger) {
      const auto found = joint_index_.find(finger);
      return found == joint_index_.end() ? gripper.open : positions[found->second];
    };
    hands_[arm].first = opening(gripper.fingers.front());
    hands_[arm].second = opening(gripper.fingers.back());
  }
}

void WorldModel::view_objects() {
  const std::int64_t now = *poses_time_ns_, elapsed = updated_ns_ ? now - *updated_ns_ : 0;
  const bool tells_speed = elapsed >= kShortest;
  const double seconds = 1e-9 * static_cast<double>(elapsed);
  const scene::Pose to_tray = tray_.pose.inverse();
  for (std::size_t i = 0; i < tracked_.size(); ++i) {
    Tracked& tracked = tracked_[i];
    ObjectView& view = objects_[i];
    view.known =
        tracked.seen_ns && 1e-9 * static_cast<double>(now - *tracked.seen_ns) <= params_.object_timeout;
    view.held = false;
    view.pose = tracked.pose;
    if (!view.known) {
      tracked.has_before = false;
      continue;
    }
    const scene::Pose on_tray = to_tray * tracked.pose;
    if (!tracked.has_before) {
      view.resting = true;  // seen for the first time: taken for standing
    } else if (tells_speed) {
      const double moved = (tracked.pose.translation() - tracked.before.translation()).norm();
      const double against_tray = (on_tray.translation() - tracked.before_on_tray.translation()).norm();
      view.resting = std::min(moved, against_tray) <= params_.resting_speed * seconds;
    }
    if (tells_speed || !tracked.has_before) {
      tracked.before = tracked.pose;
      tracked.before_on_tray = on_tray;
      tracked.has_before = true;
    }
  }
  if (tells_speed || !updated_ns_) updated_ns_ = now;
}

void WorldModel::collect_facts() {
  std::vector<Predicate> facts = unfit_;
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    const std::string& name = scene_.objects[i].name;
    for (const std::string& property : params_.static_properties)
      if (scene_.model_of(scene_.objects[i]).has_property(property)) facts.push_back({property, name, ""});
    const Place& place = support_.places()[i];
    switch (place.kind) {
      case Place::Kind::kNone:
        break;
      case Place::Kind::kRegion: {
        const scene::Region& region = scene_.regions[place.index];
        const std::string relation = region.relation == scene::RegionRelation::kIn ? "In" : "On";
        facts.push_back({relation, name, region.name});
        if (!region.within.empty()) facts.push_back({relation, name, region.within});
        break;
      }
      case Place::Kind::kOnObject:
        facts.push_back({"On", name, scene_.objects[place.index].name});
        if (support_.carries_in_hollow(place.index))
          facts.push_back({"In", name, scene_.objects[place.index].name});
        break;
      case Place::Kind::kInObject:
        facts.push_back({"In", name, scene_.objects[place.index].name});
        break;
      case Place::Kind::kTray:
        facts.push_back({"Grasping", "Robot", name});
        facts.push_back({"Held", name, "Tray"});
        break;
    }
  }
  for (std::size_t arm = 0; arm < hands_.size(); ++arm) {
    const auto& held = grasping_.held()[arm];
    if (!held) continue;
    const bool other_hand =
        std::any_of(grasping_.held().begin(), grasping_.held().begin() + static_cast<long>(arm),
                    [&](const auto& earlier) { return earlier == held; });
    if (other_hand) continue;  // one object counts once, also when both hands touch it
    facts.push_back({"Grasping", "Robot", scene_.objects[*held].name});
    facts.push_back({"Held", scene_.objects[*held].name, hand_name(robot_.arms[arm].name)});
  }
  for (const std::string& name : nearness_.names()) facts.push_back({"Near", "Robot", name});
  devices_.add_facts(facts);
  world_.facts = FactSet(std::move(facts));
}

}  // namespace goalnet::world_model
