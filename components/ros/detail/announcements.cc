#include "components/ros/detail/announcements.h"

#include <algorithm>

namespace goalnet::ros::detail {
namespace {

constexpr std::size_t kMostKnown = 2000;  // then all are forgotten: what strangers can make us remember
constexpr std::size_t kMostAddresses = 4;
constexpr int kMostAnswers = 5;  // to one participant
constexpr int kMostAnswersPerSecond = 100;
constexpr auto kYouth = std::chrono::seconds(3);
constexpr auto kPause = std::chrono::milliseconds(40);  // between two answers to one participant

using namespace rtps_message;
constexpr std::uint8_t kEProsima[] = {0x01, 0x0f};
constexpr std::uint8_t kAnnouncer[] = {0x00, 0x01, 0x00, 0xc2};
constexpr std::uint16_t kMetatrafficUnicastLocator = 0x32;
constexpr std::size_t kLocator = 24;  // kind, port, 16 bytes of address of which IPv4 uses the last four
constexpr std::uint32_t kUdpV4 = 1;

// The payload of the announcing sample: it stands first in the message, or after a timestamp. Farewells have
// a key instead of data.
std::span<const std::uint8_t> announcing_payload(std::span<const std::uint8_t> message) {
  std::span<const std::uint8_t> found;
  int looked_at = 0;
  for_each_submessage(message, [&](std::uint8_t kind, std::uint8_t flags, auto body) {
    if (kind != kData) return ++looked_at < 3;
    const bool ours = body.size() > kDataHead && (flags & kHasData) != 0 &&
                      std::equal(std::begin(kAnnouncer), std::end(kAnnouncer), body.begin() + kWriterId);
    if (!ours) return false;
    const auto rest = body.subspan(kDataHead);
    found = (flags & kInlineQos) == 0
                ? rest
                : for_each_parameter(rest, (flags & kLittleEndian) != 0, [](std::uint32_t, auto) {});
    return false;
  });
  return found;
}

std::vector<UdpAddress> addresses_in(std::span<const std::uint8_t> payload) {
  std::vector<UdpAddress> found;
  if (payload.size() < 4) return found;
  const bool little = payload[1] == 3;  // PL_CDR_LE
  for_each_parameter(payload.subspan(4), little, [&](std::uint32_t id, std::span<const std::uint8_t> value) {
    if (id != kMetatrafficUnicastLocator || value.size() != kLocator || found.size() >= kMostAddresses)
      return;
    const Reader reader{value, little};
    const std::uint32_t port = reader.number(4, 4);
    if (reader.number(0, 4) != kUdpV4 || port == 0 || port > 0xffff) return;
    UdpAddress address{{}, static_cast<std::uint16_t>(port)};
    std::copy_n(value.begin() + 20, 4, address.ip.begin());
    found.push_back(address);
  });
  return found;
}

}  // namespace

std::optional<Announcement> read_announcement(std::span<const std::uint8_t> message) {
  if (message.size() < kHeader ||
      !std::equal(std::begin(kEProsima), std::end(kEProsima), message.begin() + kVendor)) {
    return std::nullopt;
  }
  const auto payload = announcing_payload(message);
  if (payload.empty()) return std::nullopt;
  Announcement announcement;
  announcement.participant = prefix_at(message, kPrefix);
  announcement.addresses = addresses_in(payload);
  return announcement;
}

bool Newcomers::answer(const Announcement& announcement, Clock::time_point now) {
  if (known_.size() >= kMostKnown && !known_.contains(announcement.participant)) known_.clear();
  const auto [entry, is_new] = known_.try_emplace(announcement.participant, Acquaintance{now, now, 0});
  Acquaintance& one = entry->second;
  if (is_new || one.answers >= kMostAnswers || now - one.since > kYouth || now - one.answered < kPause)
    return false;
  if (now - second_ >= std::chrono::seconds(1)) {
    second_ = now;
    answers_this_second_ = 0;
  }
  if (++answers_this_second_ > kMostAnswersPerSecond) return false;
  one.answered = now;
  ++one.answers;
  return true;
}

}  // namespace goalnet::ros::detail
