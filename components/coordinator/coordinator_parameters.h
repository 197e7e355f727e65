// The coordinator's parameters as a ROS 2 node declares them.
#pragma once

#include <string>

#include "components/coordinator/params.h"
#include "components/core/outcome.h"
#include "components/ros/node.h"

namespace goalnet::coordinator {

struct NodeParams {
  CoordinatorParams core;
  std::string domain;  // PDDL file
};

// Errors: kInvalidRequest, naming the parameter.
Expected<NodeParams> declare_parameters(ros::Node& node);

}  // namespace goalnet::coordinator
