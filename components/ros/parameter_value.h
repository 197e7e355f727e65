// Values of ROS 2 parameters.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace goalnet::ros {

// monostate: not set. The index equals rcl_interfaces/msg/ParameterType.
using ParameterValue =
    std::variant<std::monostate, bool, std::int64_t, double, std::string, std::vector<std::uint8_t>,
                 std::vector<bool>, std::vector<std::int64_t>, std::vector<double>, std::vector<std::string>>;

// "bool", "integer", "double", "string", "byte_array", ...
const char* type_name(const ParameterValue& value);

// As YAML: true, 3, 0.5, "text", [1, 2].
std::string to_string(const ParameterValue& value);

}  // namespace goalnet::ros
