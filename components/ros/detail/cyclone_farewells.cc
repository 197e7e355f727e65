#include "components/ros/detail/cyclone_farewells.h"

#include <algorithm>

#include "components/ros/detail/rtps_message.h"

namespace goalnet::ros::detail {
namespace {

using namespace rtps_message;
using Bytes = std::span<const std::uint8_t>;

constexpr std::uint16_t kParticipantGuid = 0x50, kEndpointGuid = 0x5a, kKeyHash = 0x70;
constexpr std::size_t kGuid = 16;

// Announces participants, writers or readers.
bool of_discovery(Bytes data) {
  static constexpr std::uint8_t kWriters[][4] = {{0, 1, 0, 0xc2}, {0, 0, 3, 0xc2}, {0, 0, 4, 0xc2}};
  return std::any_of(std::begin(kWriters), std::end(kWriters), [&](const auto& writer) {
    return std::equal(std::begin(writer), std::end(writer), data.begin() + kWriterId);
  });
}

void append(std::vector<std::uint8_t>& out, std::size_t number, bool little) {
  const auto low = static_cast<std::uint8_t>(number), high = static_cast<std::uint8_t>(number >> 8);
  out.insert(out.end(), {little ? low : high, little ? high : low});
}

// Whose farewell this is; empty if it is none that needs to be translated.
Bytes who_leaves(std::uint8_t flags, Bytes data) {
  const bool little = (flags & kLittleEndian) != 0;
  if ((flags & (kInlineQos | kHasData | kHasKey)) != (kInlineQos | kHasKey) || data.size() < kDataHead ||
      Reader{data, little}.number(kOctetsToInlineQos, 2) != kDataHead - 4 || !of_discovery(data)) {
    return {};
  }
  const Bytes key = for_each_parameter(data.subspan(kDataHead), little, [](std::uint32_t, Bytes) {});
  if (key.size() < 4 || key[0] != 0 || (key[1] != 2 && key[1] != 3)) return {};  // a list of parameters
  Bytes guid;
  for_each_parameter(key.subspan(4), key[1] == 3, [&](std::uint32_t id, Bytes value) {
    if ((id == kParticipantGuid || id == kEndpointGuid) && value.size() == kGuid) guid = value;
  });
  return guid;
}

// The submessage without its payload, the key in the inline QoS.
void append_translated(std::vector<std::uint8_t>& out, std::uint8_t flags, Bytes data, Bytes guid) {
  const bool little = (flags & kLittleEndian) != 0;
  const Bytes inline_qos = data.subspan(kDataHead);
  const Bytes key = for_each_parameter(inline_qos, little, [](std::uint32_t, Bytes) {});
  const Bytes kept = inline_qos.first(inline_qos.size() - key.size());
  out.insert(out.end(), {kData, static_cast<std::uint8_t>(flags & ~kHasKey)});
  append(out, kDataHead + 4 + kGuid + kept.size(), little);
  out.insert(out.end(), data.begin(), data.begin() + kDataHead);
  append(out, kKeyHash, little);
  append(out, kGuid, little);
  out.insert(out.end(), guid.begin(), guid.end());
  out.insert(out.end(), kept.begin(), kept.end());
}

}  // namespace

std::vector<std::uint8_t> translated_farewells(Bytes message) {
  std::vector<std::uint8_t> out;
  std::size_t copied = 0;  // of `message`
  for_each_submessage(message, [&](std::uint8_t kind, std::uint8_t flags, Bytes body) {
    if (kind != kData) return true;
    const Bytes guid = who_leaves(flags, body);
    if (guid.empty()) return true;
    const auto begin = static_cast<std::size_t>(body.data() - message.data());
    out.insert(out.end(), message.begin() + static_cast<std::ptrdiff_t>(copied),
               message.begin() + static_cast<std::ptrdiff_t>(begin - 4));
    append_translated(out, flags, body, guid);
    copied = begin + body.size();
    return true;
  });
  if (copied > 0) out.insert(out.end(), message.begin() + static_cast<std::ptrdiff_t>(copied), message.end());
  return out;
}

}  // namespace goalnet::ros::detail
