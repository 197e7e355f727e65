// A reader leaves while it is sent again what it has missed: Fast DDS 2.9 could stop for ever
// (docs/design/074). The stuck process ends at once, without destructors, which would wait as well.
#include <fastdds/rtps/transport/ChainingTransport.h>
#include <fastdds/rtps/transport/ChainingTransportDescriptor.h>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastdds/rtps/writer/RTPSWriter.h>
#include <gtest/gtest.h>
#include <unistd.h>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>

#include <atomic>
#include <thread>

#include "components/ros/detail/local_writer.h"
#include "components/ros/detail/queued_changes.h"
#include "tests/unit/ros/bare_participant.h"
#include "tests/unit/ros/support.h"

namespace goalnet::ros {
namespace {

using namespace std::chrono_literals;
namespace dds = eprosima::fastdds::dds;
namespace fdds = eprosima::fastdds;
using eprosima::fastrtps::rtps::Locator_t;
using eprosima::fastrtps::rtps::LocatorsIterator;
using eprosima::fastrtps::rtps::octet;
using SteadyClock = std::chrono::steady_clock;

const int kLeavingDomain = own_domain();
constexpr std::uint32_t kDepth = 10;
constexpr std::size_t kSampleBytes =
    30'000;  // two in a datagram: half of the repetitions are sent before the next

struct Network {
  std::atomic<bool> loses{false};
  std::atomic<int> arrived{0};
};

// Loses samples on arrival while it is told to.
class LosingTransport : public fdds::rtps::ChainingTransport {
 public:
  LosingTransport(const fdds::rtps::ChainingTransportDescriptor& descriptor, Network& network)
      : ChainingTransport(descriptor), network_(network) {}
  fdds::rtps::TransportDescriptorInterface* get_configuration() override {
    return low_level_transport_->get_configuration();
  }
  bool send(eprosima::fastrtps::rtps::SenderResource* lower, const octet* buffer, std::uint32_t size,
            LocatorsIterator* begin, LocatorsIterator* end, const SteadyClock::time_point& timeout) override {
    return lower->send(buffer, size, begin, end, timeout);
  }
  void receive(fdds::rtps::TransportReceiverInterface* next, const octet* buffer, std::uint32_t size,
               const Locator_t& local, const Locator_t& remote) override {
    if (size >= kSampleBytes) {
      if (network_.loses) return;
      ++network_.arrived;
    }
    next->OnDataReceived(buffer, size, local, remote);
  }

 private:
  Network& network_;
};

struct LosingDescriptor : fdds::rtps::ChainingTransportDescriptor {
  explicit LosingDescriptor(Network& the_network)
      : ChainingTransportDescriptor(std::make_shared<fdds::rtps::UDPv4TransportDescriptor>()),
        network(the_network) {}
  fdds::rtps::TransportInterface* create_transport() const override {
    return new LosingTransport(*this, network);
  }
  Network& network;
};

bool soon(const std::function<bool()>& is_so) {
  const auto end = SteadyClock::now() + 5s;
  while (!is_so()) {
    if (SteadyClock::now() > end) return false;
    std::this_thread::sleep_for(100us);
  }
  return true;
}

// Does not come back: the exit code is 0 where every round came to its end.
[[noreturn]] void let_readers_leave(int rounds) {
  alarm(60);
  talk_by_network_only(true);
  Network network;
  auto context = make_context(kLeavingDomain);
  Qos qos = Qos::standard();
  qos.depth = kDepth;
  EndpointOptions options;
  options.dds_topic = "rt/bare";
  options.dds_type = "bare";
  options.qos = qos;
  options.heartbeat = 10ms;
  auto writer = Writer::create(context->participant(), options);
  BareParticipant other(kLeavingDomain, std::make_shared<LosingDescriptor>(network));
  auto* subscriber = other.participant->create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT);
  std::vector<std::uint8_t> payload(kSampleBytes);
  payload[1] = 1;
  for (int round = 0; round < rounds; ++round) {
    auto* reader = subscriber->create_datareader(other.topic, detail::reader_qos(qos, ""));
    const auto knows_writer = [&] {
      dds::SubscriptionMatchedStatus status;
      reader->get_subscription_matched_status(status);
      return status.current_count == 1;
    };
    if (!soon([&] { return (*writer)->matched() == 1 && knows_writer(); })) {
      std::fprintf(stderr, "round %d: the reader is not found\n", round);
      std::_Exit(1);
    }
    network.loses = true;
    for (std::uint32_t i = 0; i < kDepth; ++i) (*writer)->write_raw(payload);
    std::this_thread::sleep_for(2ms);
    network.arrived = 0;
    network.loses = false;
    soon([&] { return network.arrived > 0; });
    subscriber->delete_datareader(reader);
    if (!soon([&] { return (*writer)->matched() == 0; })) {
      std::fprintf(stderr, "round %d: the writer is stuck\n", round);
      std::_Exit(1);
    }
  }
  std::_Exit(0);
}

TEST(ReaderLeaves, WhileItIsSentWhatItMissed) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(let_readers_leave(150), testing::ExitedWithCode(0), "");
}

bool keeps_queued_changes(const eprosima::fastrtps::rtps::GUID_t& guid) {
  auto* writer = detail::local_writer(guid);
  return dynamic_cast<detail::QueuedChanges*>(writer->getListener()) != nullptr;
}

// The same can happen to every writer that removes what all readers have.
TEST(ReaderLeaves, NoWriterRemovesWhatIsQueued) {
  auto context = make_context(kLeavingDomain);
  EndpointOptions options;
  options.dds_topic = "rt/bare";
  options.dds_type = "bare";
  for (const Qos& qos : {Qos::standard(), Qos::services(), Qos::latched(), Qos::sensor_data()}) {
    options.qos = qos;
    auto writer = Writer::create(context->participant(), options);
    EXPECT_EQ(keeps_queued_changes(detail::to_guid((*writer)->gid())), qos.reliable && !qos.transient_local);
  }
  // What tells others of writers and readers.
  for (const std::uint8_t kind : {3, 4}) {
    Gid discovery = context->participant()->gid();
    discovery[12] = discovery[13] = 0;
    discovery[14] = kind;
    discovery[15] = 0xc2;
    EXPECT_TRUE(keeps_queued_changes(detail::to_guid(discovery)));
  }
}

}  // namespace
}  // namespace goalnet::ros
