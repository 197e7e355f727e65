// The motion that is being carried out, as lines.
#pragma once

#include <string>
#include <vector>

#include "components/robot/kinematics.h"
#include "components/robot/robot_model.h"
#include "components/visualization/drawing.h"

namespace goalnet::visualization {

// Joint positions over time: one row for each point, in the order of `joints` [rad, m].
struct PlannedMotion {
  std::vector<std::string> joints;
  std::vector<std::vector<double>> points;
};

// Group "path": the way of the base on the floor (id 0) and of each hand (1, 2, ...), where they move by more
// than 2 cm. `q`: where the other joints are, in the order of RobotModel::joints. The robot's root frame
// counts as map.
void draw_path(const robot::RobotModel& robot, const robot::Kinematics& kinematics, std::vector<double> q,
               const PlannedMotion& motion, std::vector<Drawing>& out);

}  // namespace goalnet::visualization
