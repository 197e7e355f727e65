// How Cyclone DDS says that a participant or an endpoint is gone, put in the words that Fast DDS 2.9
// understands. Pure; knows no DDS library and no sockets.
//
// Both end what they have announced with a message that has a key instead of data. Fast DDS writes the key
// into the inline QoS (PID_KEY_HASH) and sends no payload; Cyclone DDS sends it as the payload, as a list of
// parameters. Fast DDS 2.9 takes no key of more than 16 bytes from a payload, this one has 28, and drops the
// message: a tool on Cyclone DDS that has left would count as present for ten seconds more, be written to,
// and its endpoints as matched for ever while its process lives.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace goalnet::ros::detail {

// The message with each such farewell in Fast DDS's words; empty if there is none in it.
std::vector<std::uint8_t> translated_farewells(std::span<const std::uint8_t> message);

}  // namespace goalnet::ros::detail
