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

void Introduction::sent(std::span<const std::uint8_t> message, std::span<const UdpAddress> to) {
  if (EarlyHeartbeats::is_to_cyclone(message)) {
    std::lock_guard lock(mutex_);
    heartbeats_.sent(message, to);
    return;
  }
  const auto announcement = read_announcement(message);
  if (!announcement) return;
  std::lock_guard lock(mutex_);
  own_.assign(message.begin(), message.end());
  participant_ = announcement->participant;
}

void Introduction::received(std::span<const std::uint8_t> message) {
  if (EarlyHeartbeats::is_from_cyclone(message)) {
    std::lock_guard lock(mutex_);
    for (const auto& datagram : heartbeats_.received(message, participant_))
      send(datagram.bytes, datagram.to);
    return;
  }
  const auto announcement = read_announcement(message);
  if (!announcement) return;
  std::lock_guard lock(mutex_);
  if (own_.empty() || announcement->participant == participant_) return;
  if (newcomers_.answer(*announcement, Newcomers::Clock::now())) send(own_, announcement->addresses);
}

// What is lost here is made good by the next announcement or heartbeat.
void Introduction::send(std::span<const std::uint8_t> message, std::span<const UdpAddress> to) const {
  for (const UdpAddress& one : to) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(one.port);
    std::memcpy(&address.sin_addr, one.ip.data(), one.ip.size());
    (void)::sendto(socket_, message.data(), message.size(), MSG_NOSIGNAL,
                   reinterpret_cast<const sockaddr*>(&address), sizeof address);
  }
}

}  // namespace goalnet::ros::detail
