// Where liquids, tools and things are with respect to each other: plain geometry behind the device rules.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "components/scene/scene.h"

namespace goalnet::sim {

// Angle between the mouth's z and up [rad]; 0 for models without a cavity.
double mouth_tilt(const scene::ObjectModel& model, const scene::Pose& object);

// On: the footprint's centre lies over a support and the resting plane within `slack` [m] of it. In: the
// same, anywhere in the clear space above the support.
bool in_region(const scene::Scene& scene, const scene::Region& region, const scene::Pose& object,
               double slack = 0.05);

// Outlet of a fill rule in the map frame, on the moving part that carries it.
Eigen::Vector3d outlet_position(const scene::Scene& scene, const scene::FillRule& rule,
                                const std::function<double(const std::string&)>& joint);

// Index of the object whose upright open mouth a stream from `outlet` hits first within `reach` [m] below;
// -1: none.
int vessel_below(const scene::Scene& scene, const std::vector<scene::Pose>& objects,
                 const Eigen::Vector3d& outlet, double reach);

// Whether contents run out of something at this pose, wherever they run to.
bool pours(const scene::ObjectModel& giver, const scene::Pose& pose);

// Tilted so far that contents run over the lip, and the stream from the lip falls into the receiver's upright
// mouth.
bool pours_into(const scene::ObjectModel& giver, const scene::Pose& giver_pose,
                const scene::ObjectModel& receiver, const scene::Pose& receiver_pose);

// Whether a point (map frame) lies in the hollow of an object.
bool inside_cavity(const scene::ObjectModel& model, const scene::Pose& object, const Eigen::Vector3d& point);

// Lowest corner of the object's shapes (map frame), and the end of a tool's +x (spoon's bowl).
Eigen::Vector3d lowest_point(const scene::ObjectModel& model, const scene::Pose& object);
Eigen::Vector3d tool_tip(const scene::ObjectModel& model, const scene::Pose& object);

}  // namespace goalnet::sim
