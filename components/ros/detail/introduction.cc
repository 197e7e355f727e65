#include "components/ros/detail/introduction.h"

#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstring>

namespace goalnet::ros::detail {

Introduction::Introduction() : socket_(::socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)) {}

Introduction::~Introduction() {
  if (socket_ >= 0) ::close(socket_);
}

void Introduction::sent(std::span<const std::uint8_t> message) {
  const auto announcement = read_announcement(message);
  if (!announcement) return;
  std::lock_guard lock(mutex_);
  own_.assign(message.begin(), message.end());
  participant_ = announcement->participant;
}

void Introduction::received(std::span<const std::uint8_t> message) {
  const auto announcement = read_announcement(message);
  if (!announcement) return;
  std::lock_guard lock(mutex_);
  if (own_.empty() || announcement->participant == participant_) return;
  if (!newcomers_.answer(*announcement, Newcomers::Clock::now())) return;
  for (const UdpAddress& address : announcement->addresses) {
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(address.port);
    std::memcpy(&to.sin_addr, address.ip.data(), address.ip.size());
    // What is lost here is made good by the next announcement.
    (void)::sendto(socket_, own_.data(), own_.size(), MSG_NOSIGNAL, reinterpret_cast<const sockaddr*>(&to),
                   sizeof to);
  }
}

}  // namespace goalnet::ros::detail
