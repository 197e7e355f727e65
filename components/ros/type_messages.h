// Type descriptions as messages, for ~/get_type_description.
#pragma once

#include "idl/type_description.h"
#include "type_description_interfaces/msg/TypeDescription.h"
#include "type_description_interfaces/srv/GetTypeDescription.h"

namespace goalnet::ros {

type_description_interfaces::msg::TypeDescription to_message(const idl::TypeDescription& type);

// Answers a request: not successful for an unknown name or a hash that is not ours.
void describe_type(const type_description_interfaces::srv::GetTypeDescription_Request& request,
                   type_description_interfaces::srv::GetTypeDescription_Response& response);

}  // namespace goalnet::ros
