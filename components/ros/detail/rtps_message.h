// RTPS 2.3 messages as datagrams, for those who look at some of their parts. Knows no DDS library.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

namespace goalnet::ros::detail {

struct UdpAddress {
  std::array<std::uint8_t, 4> ip{};
  std::uint16_t port = 0;
  bool operator==(const UdpAddress&) const = default;
};

namespace rtps_message {

using Prefix = std::array<std::uint8_t, 12>;  // names a participant

inline constexpr std::size_t kHeader = 20, kVendor = 6, kPrefix = 8;
enum Submessage : std::uint8_t { kAckNack = 0x06, kHeartbeat = 0x07, kInfoDestination = 0x0e, kData = 0x15 };

// The flags of data, and what it begins with: flags, offset of the inline QoS, reader, writer, number.
enum DataFlag : std::uint8_t { kLittleEndian = 0x01, kInlineQos = 0x02, kHasData = 0x04, kHasKey = 0x08 };
inline constexpr std::size_t kOctetsToInlineQos = 2, kWriterId = 8, kDataHead = 20;

inline Prefix prefix_at(std::span<const std::uint8_t> bytes, std::size_t at) {
  Prefix prefix;
  std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(at), prefix.size(), prefix.begin());
  return prefix;
}

struct Reader {
  std::span<const std::uint8_t> bytes;
  bool little;
  std::uint32_t number(std::size_t at, std::size_t size) const {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < size; ++i) value = value << 8 | bytes[little ? at + size - 1 - i : at + i];
    return value;
  }
};

// Calls visit(kind, flags, body) for one submessage after the other until it returns false. A body is cut
// where the message ends.
template <class Visit>
void for_each_submessage(std::span<const std::uint8_t> message, Visit visit) {
  for (std::size_t at = kHeader; message.size() >= at + 4;) {
    const bool little = (message[at + 1] & 1) != 0;
    const std::size_t length = Reader{message, little}.number(at + 2, 2);
    const auto body = message.subspan(at + 4, std::min(length, message.size() - at - 4));
    if (!visit(message[at], message[at + 1], body)) return;
    if (length == 0 && message[at] != 0) return;  // it reaches to the end
    at += 4 + length;
  }
}

inline constexpr std::uint16_t kEndOfParameters = 1;

// Calls visit(id, value) for each of a list of parameters. Returns what follows the list; nothing if it does
// not end.
template <class Visit>
std::span<const std::uint8_t> for_each_parameter(std::span<const std::uint8_t> bytes, bool little,
                                                 Visit visit) {
  const Reader reader{bytes, little};
  for (std::size_t at = 0; at + 4 <= bytes.size();) {
    const std::uint32_t id = reader.number(at, 2);
    const std::size_t length = reader.number(at + 2, 2);
    at += 4;
    if (id == kEndOfParameters) return bytes.subspan(at);
    if (length > bytes.size() - at) break;
    visit(id, bytes.subspan(at, length));
    at += length;
  }
  return {};
}

}  // namespace rtps_message
}  // namespace goalnet::ros::detail
