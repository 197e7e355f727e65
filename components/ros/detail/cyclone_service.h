// Services as rmw_cyclonedds does them: a request begins with 16 bytes that name the client and the call, and
// the reply begins with the same 16 bytes. (rmw_fastrtps says the same beside the message, in inline QoS.)
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "components/ros/endpoint.h"

namespace goalnet::ros::detail {

struct CycloneHeader {
  std::uint64_t client = 0;   // a number that the client has chosen for itself
  std::int64_t sequence = 0;  // counted by the client
  bool operator==(const CycloneHeader&) const = default;
};

// Participants of Cyclone DDS bear Eclipse's vendor id in front of their GUID.
bool from_cyclone(const Gid& endpoint);

// A number for ourselves as such a client.
std::uint64_t cyclone_client_number(const Gid& endpoint);

// Takes the header out of a payload as received (4 bytes of encapsulation in front, either byte order). The
// message behind it keeps its alignment. Nothing, and the payload is unchanged, where it is too short.
std::optional<CycloneHeader> take_cyclone_header(std::vector<std::uint8_t>& payload);

// A payload as encoded here (little endian) with the header put in.
std::vector<std::uint8_t> with_cyclone_header(std::span<const std::uint8_t> payload,
                                              const CycloneHeader& header);

}  // namespace goalnet::ros::detail
