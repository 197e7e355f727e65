// What the network loses is asked for and sent again, although requests are not heard for a moment after each
// write (detail/qos_dds.cc).
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastdds/rtps/transport/test_UDPv4TransportDescriptor.h>
#include <gtest/gtest.h>
#include <fastdds/dds/subscriber/SampleInfo.hpp>

#include <algorithm>
#include <cstring>
#include <mutex>
#include <numeric>
#include <random>
#include <thread>

#include "tests/unit/ros/bare_participant.h"
#include "tests/unit/ros/support.h"

namespace goalnet::ros {
namespace {

using namespace std::chrono_literals;
namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastdds::rtps;
using eprosima::fastrtps::types::ReturnCode_t;
using SteadyClock = std::chrono::steady_clock;

const int kLossDomain = own_domain();
constexpr std::uint32_t kMessages = 300;

struct Loss : testing::TestWithParam<std::chrono::microseconds> {
  Loss() { talk_by_network_only(true); }
  ~Loss() override { talk_by_network_only(false); }
};

TEST_P(Loss, IsMadeGood) {
  auto losing = std::make_shared<rtps::test_UDPv4TransportDescriptor>();
  std::mutex mutex;
  std::mt19937 random(1);
  bool loses = false;
  losing->messages_filter_ = [&](auto&) {  // of all it sends: data, heartbeats, repetitions
    std::lock_guard lock(mutex);
    return loses && random() % 5 == 0;
  };
  BareParticipant sender(kLossDomain, losing),
      receiver(kLossDomain, std::make_shared<rtps::UDPv4TransportDescriptor>());
  Qos qos = Qos::standard();
  qos.depth = kMessages;  // what is overwritten before it is asked for cannot be repeated
  auto* writer = sender.participant->create_publisher(dds::PUBLISHER_QOS_DEFAULT)
                     ->create_datawriter(sender.topic, detail::writer_qos(qos, ""));
  auto* reader = receiver.participant->create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT)
                     ->create_datareader(receiver.topic, detail::reader_qos(qos, ""));
  const auto matched = [&] {
    dds::PublicationMatchedStatus ours;
    dds::SubscriptionMatchedStatus theirs;
    writer->get_publication_matched_status(ours);
    reader->get_subscription_matched_status(theirs);
    return ours.current_count == 1 && theirs.current_count == 1;
  };
  for (int i = 0; i < 500 && !matched(); ++i) std::this_thread::sleep_for(10ms);
  ASSERT_TRUE(matched());
  {
    std::lock_guard lock(mutex);
    loses = true;
  }

  std::vector<std::uint32_t> seen;
  const auto take = [&] {
    detail::Incoming in;
    dds::SampleInfo info;
    while (reader->take_next_sample(&in, &info) == ReturnCode_t::RETCODE_OK) {
      if (!info.valid_data) continue;
      std::uint32_t number = 0;
      std::memcpy(&number, in.payload.data() + 4, sizeof number);
      seen.push_back(number);
    }
  };
  for (std::uint32_t i = 0; i < kMessages; ++i) {
    std::vector<std::uint8_t> bytes = {0, 1, 0, 0, 0, 0, 0, 0};
    std::memcpy(bytes.data() + 4, &i, sizeof i);
    detail::Outgoing out;
    out.payload = bytes;
    ASSERT_TRUE(writer->write(&out));
    if (GetParam().count() > 0) std::this_thread::sleep_for(GetParam());
    take();
  }
  const auto written = SteadyClock::now();
  while (seen.size() < kMessages && SteadyClock::now() - written < 10s) {
    std::this_thread::sleep_for(1ms);
    take();
  }
  std::printf("all were there %.0f ms after the last was written\n",
              std::chrono::duration<double, std::milli>(SteadyClock::now() - written).count());
  std::vector<std::uint32_t> all(kMessages);
  std::iota(all.begin(), all.end(), 0u);
  EXPECT_EQ(seen, all);
}

// At once; a thousand and three hundred a second, one within and one beyond that moment.
INSTANTIATE_TEST_SUITE_P(Pauses, Loss, testing::Values(0us, 1000us, 3000us));

}  // namespace
}  // namespace goalnet::ros
