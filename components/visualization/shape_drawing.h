// The room and what is in it.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "components/scene/scene.h"
#include "components/visualization/drawing.h"

namespace goalnet::visualization {

// Poses of objects and of moving parts by name [map frame], as /object_poses has them.
using Poses = std::map<std::string, Pose, std::less<>>;

// Groups "fixtures" (always), "parts" and "objects" (those that have a pose), from the shapes of the scene.
// An id is the shape's place in the scene.
void draw_shapes(const scene::Scene& scene, const Poses& poses, std::vector<Drawing>& out);

// Where to write about something: above its highest point. False for what the scene does not have, or what
// was not seen.
bool place_above(const scene::Scene& scene, const Poses& poses, const std::string& name,
                 Eigen::Vector3d& place);

}  // namespace goalnet::visualization
