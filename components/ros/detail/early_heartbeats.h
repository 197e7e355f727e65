// Heartbeats of discovery that a newcomer on Cyclone DDS could not understand yet, to be sent again once it
// can. Pure; knows no DDS library and no sockets.
//
// Fast DDS answers the announcement of a participant with its own and, right behind it, with the heartbeats
// of the writers that tell of our endpoints. Cyclone DDS takes in announcements in another thread than
// heartbeats: it does not know those writers yet and drops them. Fast DDS repeats them after a second. Until
// then the newcomer sees a participant without endpoints, and a tool of ROS 2 looks for half a second.
// Once it sends heartbeats or acknowledgments of its own to us, it knows our writers.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "components/ros/detail/rtps_message.h"

namespace goalnet::ros::detail {

// Not thread-safe. Bounded.
class EarlyHeartbeats {
 public:
  struct Datagram {
    std::vector<std::uint8_t> bytes;
    std::vector<UdpAddress> to;
  };

  // A message of ours to these addresses: kept if it is such a heartbeat.
  void sent(std::span<const std::uint8_t> message, std::span<const UdpAddress> to);
  // A message that came for participant `own`: what its sender is to get again, once.
  std::vector<Datagram> received(std::span<const std::uint8_t> message, const rtps_message::Prefix& own);

  // Quick looks, to be asked first: could sent() or received() do anything with it?
  static bool is_to_cyclone(std::span<const std::uint8_t> message);
  static bool is_from_cyclone(std::span<const std::uint8_t> message);

 private:
  struct Newcomer {
    std::vector<Datagram> datagrams;
    bool told = false;
  };
  std::map<rtps_message::Prefix, Newcomer> newcomers_;
};

}  // namespace goalnet::ros::detail
