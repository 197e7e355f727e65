// Finding each other at once: what arrives while a participant is being made is not lost, and newcomers who
// lose our answer get another.
#include <gtest/gtest.h>
#include <sched.h>

#include <random>
#include <thread>

#include "components/ros/detail/announcements.h"
#include "components/ros/detail/early_heartbeats.h"
#include "components/ros/detail/participant.h"
#include "tests/unit/ros/fake_participant.h"
#include "tests/unit/ros/support.h"

namespace goalnet::ros {
namespace {

using namespace std::chrono_literals;
using detail::Announcement;
using detail::Newcomers;
using detail::read_announcement;
using Bytes = FakeParticipant::Bytes;
using SteadyClock = std::chrono::steady_clock;

const int kDomain = own_domain();

std::array<std::uint8_t, 12> prefix_of(const Context& context) {
  std::array<std::uint8_t, 12> prefix;
  const Gid gid = context.participant()->gid();
  std::copy_n(gid.begin(), prefix.size(), prefix.begin());
  return prefix;
}

TEST(Announcements, AreReadFromRealisticMessages) {
  const FakeParticipant fake(kDomain);
  Bytes message = fake.announcement();
  auto read = read_announcement(message);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->participant, fake.prefix());
  ASSERT_EQ(read->addresses.size(), 1u);
  EXPECT_EQ(read->addresses[0].ip, (std::array<std::uint8_t, 4>{127, 0, 0, 1}));
  // After a timestamp and with inline QoS, as Fast DDS sends it.
  Bytes stamped(message.begin(), message.begin() + 20);
  stamped.insert(stamped.end(), {0x09, 1, 8, 0, 1, 2, 3, 4, 5, 6, 7, 8});
  Bytes data(message.begin() + 20, message.end());
  data[1] |= 0x02;
  const Bytes inline_qos = {0x0f, 0x80, 4, 0, 1, 2, 3, 4, 1, 0, 0, 0};
  data.insert(data.begin() + 24, inline_qos.begin(), inline_qos.end());
  const auto length = static_cast<std::uint16_t>(data.size() - 4);
  data[2] = static_cast<std::uint8_t>(length);
  data[3] = static_cast<std::uint8_t>(length >> 8);
  stamped.insert(stamped.end(), data.begin(), data.end());
  read = read_announcement(stamped);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->addresses.size(), 1u);
}

TEST(Announcements, AllElseIsNone) {
  const FakeParticipant fake(kDomain);
  const Bytes good = fake.announcement();
  Bytes other_vendor = good;
  other_vendor[7] = 0x10;
  EXPECT_FALSE(read_announcement(other_vendor));
  Bytes other_writer = good;
  other_writer[20 + 4 + 10] = 3;
  EXPECT_FALSE(read_announcement(other_writer));
  Bytes farewell = good;
  farewell[21] = 0x09;  // a key, no data
  EXPECT_FALSE(read_announcement(farewell));
  EXPECT_FALSE(read_announcement({}));
  // Cut anywhere, and with any byte changed, it is read or not, within its bounds.
  std::mt19937 random(3);
  for (std::size_t size = 0; size < good.size(); ++size) {
    const auto read = read_announcement(std::span(good).first(size));
    EXPECT_LE(read ? read->addresses.size() : 0, 4u);
    Bytes changed = good;
    for (int i = 0; i < 20; ++i) {
      changed[size] = static_cast<std::uint8_t>(random());
      const auto again = read_announcement(changed);
      EXPECT_LE(again ? again->addresses.size() : 0, 4u);
    }
  }
}

TEST(Newcomers, AreAnsweredAFewTimesButNotAtFirst) {
  Newcomers newcomers;
  Announcement one;
  const auto start = SteadyClock::now();
  EXPECT_FALSE(newcomers.answer(one, start)) << "Fast DDS answers the first";
  EXPECT_FALSE(newcomers.answer(one, start + 1ms)) << "the same, by another interface";
  int answers = 0;
  for (int i = 1; i <= 20; ++i) answers += newcomers.answer(one, start + i * 100ms);
  EXPECT_EQ(answers, 5);
  Announcement late;
  late.participant[0] = 9;
  EXPECT_FALSE(newcomers.answer(late, start));
  EXPECT_FALSE(newcomers.answer(late, start + 10s)) << "an old acquaintance has heard of us";
}

TEST(Newcomers, AFloodIsAnsweredAHundredTimesASecond) {
  Newcomers newcomers;
  const auto start = SteadyClock::now();
  int answers = 0;
  for (int round = 0; round < 5; ++round) {
    for (int i = 0; i < 1500; ++i) {
      Announcement one;
      one.participant[0] = static_cast<std::uint8_t>(i);
      one.participant[1] = static_cast<std::uint8_t>(i >> 8);
      answers += newcomers.answer(one, start + round * 100ms);
    }
  }
  EXPECT_EQ(answers, 100);
}

// Header of a message from `vendor`, then a destination, then one submessage that names a writer.
Bytes directed(std::uint8_t vendor, std::uint8_t from, std::uint8_t to_vendor, std::uint8_t to,
               std::uint8_t submessage, std::uint8_t writer_kind, std::uint8_t writer = 3) {
  Bytes message = {'R', 'T', 'P', 'S', 2, 3, 1, vendor, 1, vendor, from, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  message.insert(message.end(), {0x0e, 1, 12, 0, 1, to_vendor, to, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  message.insert(message.end(), {submessage, 1, 28, 0, 0, 0, writer, 0xc7, 0, 0, writer, writer_kind});
  message.resize(message.size() + 20);
  return message;
}

struct EarlyHeartbeatsTest : testing::Test {
  const detail::rtps_message::Prefix own{1, 0x0f, 7};
  const std::vector<detail::UdpAddress> to = {{{127, 0, 0, 1}, 7411}};
  const Bytes heartbeat = directed(0x0f, 7, 0x10, 5, 0x07, 0xc2);
  const Bytes sign = directed(0x10, 5, 0x0f, 7, 0x06, 0xc2);
  detail::EarlyHeartbeats early;
};

TEST_F(EarlyHeartbeatsTest, AreSentAgainOnceTheNewcomerKnowsTheWriter) {
  early.sent(heartbeat, to);
  EXPECT_TRUE(early.received(directed(0x10, 6, 0x0f, 7, 0x06, 0xc2), own).empty()) << "somebody else";
  EXPECT_TRUE(early.received(directed(0x10, 5, 0x0f, 8, 0x06, 0xc2), own).empty()) << "to somebody else";
  EXPECT_TRUE(early.received(directed(0x10, 5, 0x0f, 7, 0x07, 0xc2), own).empty()) << "knows our reader";
  EXPECT_TRUE(early.received(std::span(sign).first(30), own).empty()) << "cut";
  early.sent(heartbeat, to);  // by the other network interface
  const auto again = early.received(sign, own);
  ASSERT_EQ(again.size(), 1u);
  EXPECT_EQ(again[0].bytes, heartbeat);
  EXPECT_EQ(again[0].to, to);
  EXPECT_TRUE(early.received(sign, own).empty()) << "once";
  early.sent(heartbeat, to);
  EXPECT_TRUE(early.received(sign, own).empty()) << "later ones were understood";
}

// A busy newcomer may know the first of our writers long before the second, and may have acknowledged to it
// before the second has said anything.
TEST_F(EarlyHeartbeatsTest, AreSentAgainForEachWriterOnItsOwn) {
  early.sent(heartbeat, to);
  EXPECT_EQ(early.received(sign, own).size(), 1u);
  const Bytes second = directed(0x0f, 7, 0x10, 5, 0x07, 0xc2, 4);
  early.sent(second, to);
  EXPECT_TRUE(early.received(sign, own).empty());
  const auto again = early.received(directed(0x10, 5, 0x0f, 7, 0x06, 0xc2, 4), own);
  ASSERT_EQ(again.size(), 1u);
  EXPECT_EQ(again[0].bytes, second);
}

TEST_F(EarlyHeartbeatsTest, AreKeptOnlyForCycloneAndOnlyThoseOfDiscovery) {
  early.sent(directed(0x0f, 7, 0x0f, 5, 0x07, 0xc2), to);  // to Fast DDS
  early.sent(directed(0x0f, 7, 0x10, 5, 0x07, 0x03), to);  // of a user's writer
  early.sent(directed(0x0f, 7, 0x10, 5, 0x06, 0xc2), to);  // an acknowledgment
  EXPECT_TRUE(early.received(sign, own).empty());
}

TEST_F(EarlyHeartbeatsTest, AreFewForEach) {
  for (int i = 0; i < 1000; ++i) {
    Bytes another = heartbeat;
    another.back() = static_cast<std::uint8_t>(i);
    early.sent(another, to);
  }
  EXPECT_EQ(early.received(sign, own).size(), 8u);
}

// All threads of this process on one processor: whoever is woken interrupts who woke him, as on a busy
// machine.
struct OneProcessor {
  OneProcessor() {
    sched_getaffinity(0, sizeof before, &before);
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(sched_getcpu(), &one);
    sched_setaffinity(0, sizeof one, &one);
  }
  ~OneProcessor() { sched_setaffinity(0, sizeof before, &before); }
  cpu_set_t before;
};

// Somebody answers each new participant once, as fast as he can, as every DDS library does. Fast DDS alone
// loses some of that: it announces before it listens.
TEST(Discovery, TheFirstAnswerIsHeard) {
  const OneProcessor one_processor;
  FakeParticipant peer(kDomain);
  for (int i = 0; i < 12; ++i) {
    std::unique_ptr<Context> context;
    std::thread maker([&] { context = make_context(kDomain); });
    std::optional<Announcement> heard;
    const auto end = SteadyClock::now() + 10s;
    while ((!heard || heard->addresses.empty()) && SteadyClock::now() < end) heard = peer.heard();
    ASSERT_TRUE(heard);
    peer.announce_to(heard->addresses[0]);
    maker.join();
    // Who heard us writes to us: its endpoints for discovery ask ours.
    bool known = false;
    while (!known && SteadyClock::now() < end) {
      const Bytes message = peer.received();
      known = message.size() > 20 && !read_announcement(message);
    }
    EXPECT_TRUE(known) << "participant " << i << " missed the answer";
    context.reset();
    peer.rename();
    while (peer.heard() || !peer.received().empty()) {
    }
  }
}

// Who loses our first answer is told of us again when it announces itself again, and not at our next periodic
// announcement only.
TEST(Discovery, NewcomersAreToldAgain) {
  auto context = make_context(kDomain);
  FakeParticipant peer(kDomain);
  std::this_thread::sleep_for(2500ms);  // until our own first announcements are over
  const auto told = [&] {
    const auto end = SteadyClock::now() + 1s;
    while (SteadyClock::now() < end) {
      const auto announcement = read_announcement(peer.received());
      if (announcement && announcement->participant == prefix_of(*context)) return true;
    }
    return false;
  };
  peer.announce();
  EXPECT_TRUE(told()) << "Fast DDS's own answer";
  while (!peer.received().empty()) {
  }
  std::this_thread::sleep_for(100ms);  // the pause between a Fast DDS participant's first announcements
  peer.announce();
  EXPECT_TRUE(told());
}

}  // namespace
}  // namespace goalnet::ros
