// Tells newcomers of us again, with a copy of our own last announcement (announcements.h says whom and why).
#pragma once

#include <mutex>
#include <span>
#include <vector>

#include "components/ros/detail/announcements.h"

namespace goalnet::ros::detail {

// Thread-safe.
class Introduction {
 public:
  Introduction();
  ~Introduction();
  Introduction(const Introduction&) = delete;

  // Every RTPS message that our participant sends, and every one that it receives.
  void sent(std::span<const std::uint8_t> message);
  void received(std::span<const std::uint8_t> message);

 private:
  int socket_ = -1;  // without one nothing is sent
  std::mutex mutex_;
  std::vector<std::uint8_t> own_;  // our last announcement
  std::array<std::uint8_t, 12> participant_{};
  Newcomers newcomers_;
};

}  // namespace goalnet::ros::detail
