// The robot as KDL sees it, built from the same urdfdom parse as everything else.
#pragma once

#include <kdl/chain.hpp>
#include <kdl/frames.hpp>
#include <kdl/tree.hpp>

#include "components/robot/kinematics.h"
#include "components/robot/robot_model.h"

namespace goalnet::robot {

KDL::Frame to_kdl(const Pose& pose);
Pose from_kdl(const KDL::Frame& frame);

// The whole tree; segment names are link names, joint names as in the URDF.
KDL::Tree kdl_tree(const RobotModel& model);

// The chain between two links. Fails with kInvalidRequest if one is not below the other.
Expected<KDL::Chain> kdl_chain(const RobotModel& model, const std::string& from, const std::string& to);

}  // namespace goalnet::robot
