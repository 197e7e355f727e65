// Datagrams that look like announcements of DDS participants.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "components/ros/detail/announcements.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace goalnet::ros::detail;
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
