// /instruction_status and the report it carries.
#pragma once

#include "components/coordinator/port.h"
#include "goalnet_msgs/msg/InstructionStatus.h"

namespace goalnet::coordinator {

goalnet_msgs::msg::InstructionStatus to_message(const Report& report, TimeNs now);

// An unknown stage reads as waiting.
Report from_message(const goalnet_msgs::msg::InstructionStatus& message);

}  // namespace goalnet::coordinator
