// Announcements of DDS participants (SPDP) as datagrams: which newcomers are to be told of us again. Pure;
// knows no DDS library and no sockets.
//
// A Fast DDS participant announces itself some moments before it listens (held_reception.h): the answer of a
// peer, which comes at once and only once, may be lost there, and it would hear of that peer at its next
// periodic announcement, up to three seconds later. ROS 2's tools are such participants. They go on
// announcing themselves for a while (five times, 100 ms apart): these are answered too.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "components/ros/detail/rtps_message.h"

namespace goalnet::ros::detail {

struct Announcement {
  std::array<std::uint8_t, 12> participant{};
  std::vector<UdpAddress> addresses;  // where it hears announcements, at most four
};

// What an RTPS message announces, if it is an announcement of a Fast DDS participant that lives; nothing for
// all else, malformed messages included.
std::optional<Announcement> read_announcement(std::span<const std::uint8_t> message);

// Not thread-safe. Bounded.
class Newcomers {
 public:
  using Clock = std::chrono::steady_clock;

  // Is whoever announces itself now to be told of us again? A few times in its first seconds, never at its
  // first announcement, which Fast DDS answers; all in all at most a hundred times a second.
  bool answer(const Announcement& announcement, Clock::time_point now);

 private:
  struct Acquaintance {
    Clock::time_point since, answered;
    int answers = 0;
  };
  std::map<std::array<std::uint8_t, 12>, Acquaintance> known_;
  Clock::time_point second_{};
  int answers_this_second_ = 0;
};

}  // namespace goalnet::ros::detail
