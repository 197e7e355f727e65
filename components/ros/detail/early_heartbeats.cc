#include "components/ros/detail/early_heartbeats.h"

#include <utility>

namespace goalnet::ros::detail {
namespace {

using namespace rtps_message;

constexpr std::size_t kMostNewcomers = 200;
constexpr std::size_t kMostDatagrams = 8;  // for one participant: there are three or four such writers

bool is_cyclone(std::span<const std::uint8_t> vendor) { return vendor[0] == 0x01 && vendor[1] == 0x10; }

// Writers that come with every participant have the two highest bits of their kind set.
bool of_discovery(std::span<const std::uint8_t> heartbeat) {
  return heartbeat.size() >= 8 && (heartbeat[7] & 0xc0) == 0xc0;
}

}  // namespace

bool EarlyHeartbeats::is_to_cyclone(std::span<const std::uint8_t> message) {
  return message.size() >= kHeader + 4 + Prefix().size() && message[kHeader] == kInfoDestination &&
         is_cyclone(message.subspan(kHeader + 4));
}

bool EarlyHeartbeats::is_from_cyclone(std::span<const std::uint8_t> message) {
  return message.size() >= kHeader && is_cyclone(message.subspan(kVendor));
}

void EarlyHeartbeats::sent(std::span<const std::uint8_t> message, std::span<const UdpAddress> to) {
  if (!is_to_cyclone(message)) return;
  bool wanted = false;
  for_each_submessage(message, [&](std::uint8_t kind, std::uint8_t, auto body) {
    wanted = kind == kHeartbeat && of_discovery(body);
    return !wanted;
  });
  if (!wanted) return;
  const Prefix prefix = prefix_at(message, kHeader + 4);
  if (newcomers_.size() >= kMostNewcomers && !newcomers_.contains(prefix)) newcomers_.clear();
  Newcomer& one = newcomers_[prefix];
  if (!one.told && one.datagrams.size() < kMostDatagrams)
    one.datagrams.push_back({{message.begin(), message.end()}, {to.begin(), to.end()}});
}

std::vector<EarlyHeartbeats::Datagram> EarlyHeartbeats::received(std::span<const std::uint8_t> message,
                                                                 const Prefix& own) {
  if (!is_from_cyclone(message)) return {};
  const auto one = newcomers_.find(prefix_at(message, kPrefix));
  if (one == newcomers_.end() || one->second.told) return {};
  bool to_us = false, knows_us = false;
  for_each_submessage(message, [&](std::uint8_t kind, std::uint8_t, auto body) {
    if (kind == kInfoDestination) to_us = body.size() >= own.size() && prefix_at(body, 0) == own;
    knows_us = to_us && (kind == kHeartbeat || kind == kAckNack);
    return !knows_us;
  });
  if (!knows_us) return {};
  one->second.told = true;
  return std::exchange(one->second.datagrams, {});
}

}  // namespace goalnet::ros::detail
