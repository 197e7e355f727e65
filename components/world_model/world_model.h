// From poses, joint positions and perceived states to symbolic facts, in the vocabulary of the
// demonstrations.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "components/core/predicate.h"
#include "components/robot/kinematics.h"
#include "components/robot/robot_model.h"
#include "components/scene/scene.h"
#include "components/world_model/device_states.h"
#include "components/world_model/grasping.h"
#include "components/world_model/nearness.h"
#include "components/world_model/observation.h"
#include "components/world_model/params.h"
#include "components/world_model/support.h"

namespace goalnet::world_model {

// One thread. Feed it observations, then update(); the result depends on nothing else. It remembers the last
// update (hysteresis, speeds). `scene` and `robot` must outlive it.
//
//   (On X Y)             stands on a surface or another object
//   (In X Y)             inside a container or hollow object; (In X Fridge) besides (In X FridgeLeft)
//   (Near Robot X)
//   (Grasping Robot X)   with (Held X LeftHand|RightHand|Tray)
//   (state X Value)
//   (IsGraspable X), (IsSqueezeable X)
class WorldModel {
 public:
  WorldModel(const scene::Scene& scene, const robot::RobotModel& robot, Params params = {});

  // Observations. What makes no sense (numbers that are not finite, unknown names, sizes that differ) is left
  // out; the return value counts it. So are poses and robot joints older than the last. Joints of doors and
  // switches alone say nothing about where the robot is: complete() and time_ns() are about its own.
  std::size_t observe(const ObservedPoses& poses);
  std::size_t observe(const ObservedJoints& joints);
  std::size_t observe(const std::vector<ObservedState>& states);

  // Everything that has been observed by now as facts.
  const WorldState& update();

  // Both kinds of observation have come at least once.
  bool complete() const { return poses_time_ns_ && joints_time_ns_; }
  // [ns] the moment that the facts describe: the older of the two observations.
  std::int64_t time_ns() const;
  const WorldState& world() const { return world_; }
  // [ns] of the last message about the robot's own joints; 0: none yet.
  std::int64_t joints_time_ns() const { return joints_time_ns_.value_or(0); }

 private:
  struct Tracked {
    std::optional<std::int64_t> seen_ns;
    scene::Pose pose = scene::Pose::Identity();
    scene::Pose before = scene::Pose::Identity();          // at the update before ...
    scene::Pose before_on_tray = scene::Pose::Identity();  // ... and in the frame of the tray
    bool has_before = false;
  };
  struct JointMoment {
    std::int64_t time_ns = 0;
    std::vector<double> positions;  // in the order of RobotModel::joints
  };
  const std::vector<double>& joints_at(std::int64_t time_ns) const;
  void view_robot();
  void view_objects();
  void collect_facts();

  const scene::Scene& scene_;
  const robot::RobotModel& robot_;
  const Params params_;
  robot::Kinematics kinematics_;
  Support support_;
  Nearness nearness_;
  Grasping grasping_;
  DeviceStates devices_;

  std::vector<Predicate> unfit_;  // what does not go where, whatever is done
  std::map<std::string, std::size_t> object_index_;
  std::map<std::string, std::size_t> joint_index_;
  std::vector<Tracked> tracked_;
  std::deque<JointMoment> joint_history_;
  std::optional<std::int64_t> poses_time_ns_, joints_time_ns_;
  std::optional<std::int64_t> updated_ns_;

  std::vector<robot::Pose> links_;
  scene::Pose base_ = scene::Pose::Identity();
  int base_link_ = -1, tray_link_ = -1;
  std::vector<int> tool_links_;
  std::vector<HandView> hands_;
  TrayView tray_;
  std::vector<ObjectView> objects_;
  WorldState world_;
};

}  // namespace goalnet::world_model
