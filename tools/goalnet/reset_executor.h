// `goalnet tell --reset`: ends the fault of a robot's executor.
#pragma once

#include <chrono>
#include <string>

#include "components/core/outcome.h"
#include "components/ros/node.h"

namespace goalnet::tools {

// Asks the executor in the node's namespace to leave its fault, and waits until it has. What a person should
// read of it; kComponentLost where there is no executor within `wait`, kInternal where it stays in its fault.
// Does nothing to an executor that is in no fault.
Expected<std::string> reset_executor(ros::Node& node, ros::EventLoop& loop,
                                     std::chrono::duration<double> wait);

}  // namespace goalnet::tools
