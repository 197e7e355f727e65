#include "components/ros/detail/early_heartbeats.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace goalnet::ros::detail {
namespace {

using namespace rtps_message;

constexpr std::size_t kMostNewcomers = 200;
constexpr std::size_t kMostDatagrams = 8;  // for one participant: there are three or four such writers

bool is_cyclone(std::span<const std::uint8_t> vendor) { return vendor[0] == 0x01 && vendor[1] == 0x10; }

using Writer = std::array<std::uint8_t, 4>;

// Whom a heartbeat comes from, or an acknowledgment goes to. Those that come with every participant have the
// two highest bits of their kind set.
std::optional<Writer> discovery_writer(std::span<const std::uint8_t> body) {
  if (body.size() < 8 || (body[7] & 0xc0) != 0xc0) return std::nullopt;
  return Writer{body[4], body[5], body[6], body[7]};
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
  std::optional<Writer> writer;
  for_each_submessage(message, [&](std::uint8_t kind, std::uint8_t, auto body) {
    if (kind == kHeartbeat) writer = discovery_writer(body);
    return !writer;
  });
  if (!writer) return;
  const Prefix prefix = prefix_at(message, kHeader + 4);
  if (newcomers_.size() >= kMostNewcomers && !newcomers_.contains(prefix)) newcomers_.clear();
  Newcomer& one = newcomers_[prefix];
  if (one.told.contains(*writer) || one.datagrams.size() >= kMostDatagrams) return;
  std::pair kept{*writer, Datagram{{message.begin(), message.end()}, {to.begin(), to.end()}}};
  if (std::find(one.datagrams.begin(), one.datagrams.end(), kept) == one.datagrams.end())
    one.datagrams.push_back(std::move(kept));
}

std::vector<EarlyHeartbeats::Datagram> EarlyHeartbeats::received(std::span<const std::uint8_t> message,
                                                                 const Prefix& own) {
  if (!is_from_cyclone(message)) return {};
  const auto one = newcomers_.find(prefix_at(message, kPrefix));
  if (one == newcomers_.end()) return {};
  std::vector<Datagram> again;
  bool to_us = false;
  for_each_submessage(message, [&](std::uint8_t kind, std::uint8_t, auto body) {
    if (kind == kInfoDestination) to_us = body.size() >= own.size() && prefix_at(body, 0) == own;
    const auto writer = to_us && kind == kAckNack ? discovery_writer(body) : std::nullopt;
    if (!writer || one->second.told.size() >= kMostDatagrams || !one->second.told.insert(*writer).second)
      return true;
    std::erase_if(one->second.datagrams, [&](auto& kept) {
      if (kept.first != *writer) return false;
      again.push_back(std::move(kept.second));
      return true;
    });
    return true;
  });
  return again;
}

}  // namespace goalnet::ros::detail
