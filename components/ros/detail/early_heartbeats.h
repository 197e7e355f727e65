// Heartbeats of discovery that a newcomer on Cyclone DDS could not understand yet, to be sent again once it
// can. Pure; knows no DDS library and no sockets.
//
// Fast DDS answers the announcement of a participant with its own and, right behind it, with the heartbeats
// of the writers that tell of our endpoints. Cyclone DDS takes in announcements in another thread than
// heartbeats: it does not know those writers yet and drops them. Fast DDS repeats them after a second. Until
// then the newcomer sees a participant without endpoints, and a tool of ROS 2 looks for half a second.
// Cyclone DDS acknowledges to each of these writers on its own as soon as it knows that one: on a busy
// machine some time may pass between the first and the last.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "components/ros/detail/rtps_message.h"

namespace goalnet::ros::detail {

// Not thread-safe. Bounded.
class EarlyHeartbeats {
 public:
  struct Datagram {
    std::vector<std::uint8_t> bytes;
    std::vector<UdpAddress> to;
    bool operator==(const Datagram&) const = default;
  };

  // A message of ours to these addresses: kept if it is such a heartbeat.
  void sent(std::span<const std::uint8_t> message, std::span<const UdpAddress> to);
  // A message that came for participant `own`: what its sender is to get again, once for each writer.
  std::vector<Datagram> received(std::span<const std::uint8_t> message, const rtps_message::Prefix& own);

  // Quick looks, to be asked first: could sent() or received() do anything with it?
  static bool is_to_cyclone(std::span<const std::uint8_t> message);
  static bool is_from_cyclone(std::span<const std::uint8_t> message);

 private:
  using Writer = std::array<std::uint8_t, 4>;
  struct Newcomer {
    std::vector<std::pair<Writer, Datagram>> datagrams;
    std::set<Writer> told;
  };
  std::map<rtps_message::Prefix, Newcomer> newcomers_;
};

}  // namespace goalnet::ros::detail
