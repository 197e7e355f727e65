// Checks of the URDF tree and the order of its joints, shared by the model and its kinematics.
#pragma once

#include <string>
#include <vector>

#include <urdf_model/model.h>
#include <urdf_world/types.h>

#include "components/core/outcome.h"

namespace goalnet::robot {

// Parses URDF text. Fails with kInvalidRequest on malformed XML, missing links, loops, non-finite numbers,
// more than `kMaxLinks` links or a size above 4 MB.
Expected<urdf::ModelInterfaceSharedPtr> parse_urdf(const std::string& xml, const std::string& file_name);

// All joints of the tree, depth first, children in alphabetical order of their joints' names in the URDF.
std::vector<urdf::JointConstSharedPtr> joints_depth_first(const urdf::ModelInterface& model);

bool is_actuated(const urdf::Joint& joint);

inline constexpr std::size_t kMaxLinks = 256;

}  // namespace goalnet::robot
