// USER_DATA of endpoints: "key=value;" pairs, of which ROS 2 defines the type hash.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "components/ros/context.h"

namespace goalnet::ros::detail {

// "typehash=RIHS01_...;" in Jazzy, nothing in Humble.
std::string endpoint_user_data(Distro distro, const std::string& type_hash);

// What stands behind "key="; "" where the key is missing or its pair does not end with a semicolon.
std::string user_data_value(std::span<const std::uint8_t> user_data, std::string_view key);

// The type hash ("RIHS01_" and 64 hexadecimal digits) in what somebody announced; "" where there is none that
// is well formed. Other pairs (rmw_cyclonedds adds serviceid and clientid) are skipped.
std::string type_hash_of(std::span<const std::uint8_t> user_data);

}  // namespace goalnet::ros::detail
