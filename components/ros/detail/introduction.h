// Tells newcomers again what they may have missed: of us, with a copy of our own last announcement
// (announcements.h says whom and why), and of our endpoints (early_heartbeats.h).
#pragma once

#include <mutex>
#include <span>
#include <vector>

#include "components/ros/detail/announcements.h"
#include "components/ros/detail/early_heartbeats.h"

namespace goalnet::ros::detail {

// Thread-safe.
class Introduction {
 public:
  Introduction();
  ~Introduction();
  Introduction(const Introduction&) = delete;

  // Every RTPS message that our participant sends, and every one that it receives.
  void sent(std::span<const std::uint8_t> message, std::span<const UdpAddress> to);
  void received(std::span<const std::uint8_t> message);

 private:
  void send(std::span<const std::uint8_t> message, std::span<const UdpAddress> to) const;

  int socket_ = -1;  // without one nothing is sent
  std::mutex mutex_;
  std::vector<std::uint8_t> own_;  // our last announcement
  std::array<std::uint8_t, 12> participant_{};
  Newcomers newcomers_;
  EarlyHeartbeats heartbeats_;
};

}  // namespace goalnet::ros::detail
