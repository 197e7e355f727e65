// Ways to take hold of a thing that the scene does not list: it lies on its side, or stands with its good
// side to a wall. Found from its shapes.
#pragma once

#include <vector>

#include "components/manipulation/grasp_candidates.h"
#include "components/scene/object_model.h"

namespace goalnet::manipulation {

// Fingers close across the thing along one of its own axes; the hand comes along another of them, from above
// or from a side, never from below. `object`: where it is (map frame). By increasing preference;
// deterministic. `grasp` counts axes, it is no index.
std::vector<GraspCandidate> shape_grasps(const scene::ObjectModel& model, const Pose& object,
                                         const robot::Gripper& gripper);

}  // namespace goalnet::manipulation
