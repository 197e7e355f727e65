// Who says in Cyclone DDS's words that he is gone is gone (detail/cyclone_farewells.h).
#include <gtest/gtest.h>

#include <random>

#include "components/ros/detail/cyclone_farewells.h"
#include "tests/unit/ros/fake_participant.h"
#include "tests/unit/ros/support.h"

namespace goalnet::ros {
namespace {

using namespace std::chrono_literals;
using detail::translated_farewells;
using Bytes = FakeParticipant::Bytes;

constexpr std::uint8_t kCyclone = 0x10;
const int kFarewellDomain = own_domain();

TEST(Farewells, HaveTheKeyInTheInlineQosAndNoPayload) {
  const FakeParticipant fake(kFarewellDomain, 0, kCyclone);
  const Bytes before = fake.farewell(), after = translated_farewells(before);
  ASSERT_EQ(before.size(), 20u + 4 + 20 + 12 + 28);
  ASSERT_EQ(after.size(), 20u + 4 + 20 + 20 + 12);
  EXPECT_TRUE(std::equal(after.begin(), after.begin() + 20, before.begin())) << "header";
  EXPECT_EQ(Bytes(after.begin() + 20, after.begin() + 24), (Bytes{0x15, 0x03, 52, 0}));
  EXPECT_TRUE(std::equal(after.begin() + 24, after.begin() + 44, before.begin() + 24)) << "writer, number";
  Bytes inline_qos = {0x70, 0, 16, 0};
  inline_qos.insert(inline_qos.end(), fake.prefix().begin(), fake.prefix().end());
  inline_qos.insert(inline_qos.end(), {0, 0, 1, 0xc1, 0x71, 0, 4, 0, 0, 0, 0, 3, 1, 0, 0, 0});
  EXPECT_EQ(Bytes(after.begin() + 44, after.end()), inline_qos);
}

TEST(Farewells, OfEndpointsAndAmongOtherSubmessages) {
  const FakeParticipant fake(kFarewellDomain, 0, kCyclone);
  Bytes message = fake.farewell();
  message[24 + 9] = 0, message[24 + 10] = 4;  // of the writer that announces readers
  message[message.size() - 24] = 0x5a;        // its key is that of an endpoint
  const Bytes alone = translated_farewells(message);
  ASSERT_FALSE(alone.empty());
  const Bytes timestamp = {0x09, 1, 8, 0, 9, 8, 7, 6, 5, 4, 3, 2};
  message.insert(message.begin() + 20, timestamp.begin(), timestamp.end());
  message.insert(message.end(), timestamp.begin(), timestamp.end());
  Bytes expected = alone;
  expected.insert(expected.begin() + 20, timestamp.begin(), timestamp.end());
  expected.insert(expected.end(), timestamp.begin(), timestamp.end());
  EXPECT_EQ(translated_farewells(message), expected);
}

TEST(Farewells, AllElseIsLeftAsItIs) {
  const FakeParticipant fake(kFarewellDomain, 0, kCyclone);
  EXPECT_TRUE(translated_farewells(fake.announcement()).empty());
  Bytes of_topic = fake.farewell();
  of_topic[24 + 11] = 0x03;
  EXPECT_TRUE(translated_farewells(of_topic).empty());
  EXPECT_TRUE(translated_farewells(translated_farewells(fake.farewell())).empty());
  EXPECT_TRUE(translated_farewells({}).empty());
  // Cut anywhere, and with any byte changed, it is translated or not, within its bounds.
  std::mt19937 random(5);
  const Bytes good = fake.farewell();
  for (std::size_t size = 0; size < good.size(); ++size) {
    EXPECT_LE(translated_farewells(std::span(good).first(size)).size(), good.size() + 20);
    Bytes changed = good;
    for (int i = 0; i < 20; ++i) {
      changed[size] = static_cast<std::uint8_t>(random());
      EXPECT_LE(translated_farewells(changed).size(), good.size() + 20);
    }
  }
}

// Whoever is known gets no answer to a second announcement; whoever has left is a stranger, and gets one.
TEST(Farewells, AreTakenAtOnce) {
  auto context = make_context(kFarewellDomain);
  FakeParticipant peer(kFarewellDomain, 0, kCyclone);
  std::this_thread::sleep_for(2500ms);  // until our own first announcements are over
  const auto answered = [&] {
    while (!peer.received().empty()) {
    }
    peer.announce();
    for (int i = 0; i < 10; ++i) {
      const auto announcement = detail::read_announcement(peer.received());
      if (announcement) return true;
    }
    return false;
  };
  EXPECT_TRUE(answered());
  peer.leave();
  std::this_thread::sleep_for(200ms);
  EXPECT_TRUE(answered()) << "its farewell was not understood";
}

}  // namespace
}  // namespace goalnet::ros
