// Slips in -p: a parameter, or a node, that nobody has would otherwise be silently without effect. Files are
// another matter: what stands there for all nodes may well mean others.
#pragma once

#include <vector>

#include "components/core/outcome.h"
#include "components/ros/arguments.h"
#include "components/ros/node.h"

namespace goalnet::tools {

// Whether every "-p [NODE:]NAME:=VALUE" of `arguments` says something to at least one of `nodes`, all of
// which have declared their parameters. `all`: these are all the nodes there are, so that a NODE among them
// is meant. kInvalidRequest names the nearest.
Expected<void> check_given_parameters(const ros::Arguments& arguments, const std::vector<ros::Node*>& nodes,
                                      bool all);

}  // namespace goalnet::tools
