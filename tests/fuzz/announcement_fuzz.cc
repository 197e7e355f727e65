// Datagrams that look like announcements of DDS participants, and like first and last words of one on Cyclone
// DDS.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "components/ros/detail/announcements.h"
#include "components/ros/detail/cyclone_farewells.h"
#include "components/ros/detail/early_heartbeats.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace goalnet::ros::detail;
  static EarlyHeartbeats early;
  early.sent({data, size}, {});
  for (const auto& datagram : early.received({data, size}, {1, 0x0f})) {
    if (datagram.bytes.size() < 20) std::abort();
  }
  if (translated_farewells({data, size}).size() > size + 20 * (size / 4)) std::abort();
  const auto announcement = read_announcement({data, size});
  if (!announcement) return 0;
  if (announcement->addresses.size() > 4) std::abort();
  for (const UdpAddress& address : announcement->addresses) {
    if (address.port == 0) std::abort();
  }
  static Newcomers newcomers;
  newcomers.answer(*announcement, Newcomers::Clock::now());
  return 0;
}
