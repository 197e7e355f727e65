// ROS 2 parameter files: NODE: {ros__parameters: {name: value, group: {name: value}}}.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "components/core/outcome.h"
#include "components/ros/arguments.h"

namespace goalnet::ros {

// Reads a file of at most 1 MiB. kInvalidRequest with file and line for what is malformed.
Expected<std::vector<ParameterOverride>> read_parameter_file(const std::string& path);

// The same from text; `origin` stands for the file's name in messages.
Expected<std::vector<ParameterOverride>> parse_parameters(const std::string& text, const std::string& origin);

// One value as YAML would read it: 3, 0.5, true, text, [1, 2].
Expected<ParameterValue> parse_parameter_value(const std::string& text, const std::string& origin);

// Does "/**", "/*/planner", "/robot_1/planner" or "planner" mean the node with that full name?
bool matches_node(std::string_view pattern, std::string_view full_name);

}  // namespace goalnet::ros
