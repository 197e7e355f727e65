// The robot's URDF as links for the simulation: fixed joints are merged into the link that carries them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "components/core/outcome.h"
#include "components/robot/robot_model.h"
#include "sim/articulated_body.h"

namespace goalnet::sim {

// Where a URDF link went: rigid on `link` (-1: on the base, immovable) at `pose`.
struct MergedLink {
  int link = -1;
  scene::Pose pose = scene::Pose::Identity();
};

struct RobotLinks {
  std::vector<LinkSpec> links;               // in the order of RobotModel::joints
  std::map<std::string, MergedLink> merged;  // every URDF link
};

// Fails with kInvalidRequest for meshes and for moving links without mass.
Expected<RobotLinks> make_robot_links(const robot::RobotModel& model);

// The URDF's collision (or visual) geometry of one link as shapes, in the frame of that link.
Expected<std::vector<scene::Shape>> shapes_of_link(const urdf::Link& link, bool visual);

}  // namespace goalnet::sim
