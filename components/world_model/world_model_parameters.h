// The world model's parameters as a ROS 2 node declares them.
#pragma once

#include "components/ros/node.h"
#include "components/world_model/world_model_node.h"

namespace goalnet::world_model {

struct DeclaredParams {
  NodeParams node;
  std::string scene;  // name or file
  std::string robot;
};

// Fails with kInvalidRequest, naming the parameter that is wrong.
Expected<DeclaredParams> declare_parameters(ros::Node& node);

}  // namespace goalnet::world_model
