// Parameters as rcl_interfaces messages.
#pragma once

#include "components/core/outcome.h"
#include "components/ros/parameters.h"
#include "rcl_interfaces/msg/Parameter.h"
#include "rcl_interfaces/msg/ParameterDescriptor.h"
#include "rcl_interfaces/msg/ParameterValue.h"

namespace goalnet::ros {

rcl_interfaces::msg::ParameterValue to_message(const ParameterValue& value);
rcl_interfaces::msg::Parameter to_message(const Parameter& parameter);
rcl_interfaces::msg::ParameterDescriptor to_message(const std::string& name,
                                                    const ParameterDescriptor& descriptor,
                                                    const ParameterValue& value);

// kInvalidRequest for a type number that ROS 2 does not know.
Expected<ParameterValue> from_message(const rcl_interfaces::msg::ParameterValue& message);

}  // namespace goalnet::ros
