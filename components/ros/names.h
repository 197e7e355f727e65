// ROS 2 names: checking, expanding (~ and namespaces) and mapping to DDS topics.
#pragma once

#include <string>
#include <string_view>

#include "components/core/outcome.h"

namespace goalnet::ros {

// Absolute name of `name` as seen from the node `node_name` in `node_namespace` ("/" or "/robot_1"):
// "/x" stays, "x" goes into the namespace, "~/x" and "~" below the node. Fails with kInvalidRequest for what
// ROS 2 does not allow (empty parts, "__", a part that starts with a digit, characters other than A-Z a-z 0-9
// _).
Expected<std::string> expand_name(std::string_view name, std::string_view node_namespace,
                                  std::string_view node_name);

// "/robot_1" from "robot_1", "/robot_1/" or "/robot_1"; "/" from "" or "/".
Expected<std::string> normalize_namespace(std::string_view node_namespace);

Expected<void> check_node_name(std::string_view name);

// DDS topics of an absolute name.
std::string topic_to_dds(std::string_view name);            // /x -> rt/x
std::string service_request_to_dds(std::string_view name);  // /x -> rq/xRequest
std::string service_reply_to_dds(std::string_view name);    // /x -> rr/xReply

// "robot_1.planner" for /robot_1/planner, as loggers are called.
std::string logger_name(std::string_view node_namespace, std::string_view node_name);

}  // namespace goalnet::ros
