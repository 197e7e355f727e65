// What manipulation knows of the world at one moment: the scene's models plus what is perceived. No DDS.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "components/core/predicate.h"
#include "components/robot/kinematics.h"

namespace goalnet::manipulation {

using robot::Pose;

struct WorldView {
  std::int64_t time_ns = 0;              // [ns] of the newest part
  std::vector<double> robot;             // [rad or m] measured, order of RobotModel::joints
  std::vector<double> robot_command;     // [rad or m] last positions commanded; empty: as measured
  std::map<std::string, double> joints;  // [rad or m] fixture joints by name
  std::map<std::string, Pose> objects;   // in the map frame
  FactSet facts;                         // may be empty: only used to learn what the hands hold at the start

  double joint(const std::string& name) const {
    const auto found = joints.find(name);
    return found == joints.end() ? 0.0 : found->second;
  }
  const Pose* object(const std::string& name) const {
    const auto found = objects.find(name);
    return found == objects.end() ? nullptr : &found->second;
  }
};

// What one hand holds. `object_in_tool` is refreshed from perception before each motion.
struct HeldObject {
  std::string name;
  Pose object_in_tool = Pose::Identity();
};

}  // namespace goalnet::manipulation
