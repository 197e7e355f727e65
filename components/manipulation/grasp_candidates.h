// From what the scene says about grasping a thing to poses of the tool frame (z out of the hand, y closing).
#pragma once

#include <vector>

#include "components/manipulation/world_view.h"
#include "components/robot/robot_model.h"
#include "components/scene/grasp.h"

namespace goalnet::manipulation {

struct GraspCandidate {
  std::size_t grasp = 0;         // index into the owner's list of grasps
  Pose tool = Pose::Identity();  // tool frame at the moment of closing, in the frame of the owner
  double width = 0;              // [m] what the fingers close upon
  double opening = 0;            // [m] how far apart the fingers should be on the way in
  double preference = 0;         // lower is better: comfortable tilt, middle of the span
};

// All ways to take hold, by increasing preference; deterministic. `turns`: how many directions about an axis.
std::vector<GraspCandidate> grasp_candidates(const std::vector<scene::Grasp>& grasps,
                                             const robot::Gripper& gripper, int turns = 16);

}  // namespace goalnet::manipulation
