#include "components/ros/detail/held_reception.h"

#include <fastdds/rtps/network/SenderResource.h>
#include <fastdds/rtps/transport/ChainingTransport.h>
#include <fastdds/rtps/transport/ChainingTransportDescriptor.h>
#include <fastdds/rtps/transport/TCPTransportDescriptor.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <limits>
#include <vector>

#include "components/ros/detail/cyclone_farewells.h"
#include "components/ros/detail/introduction.h"

namespace goalnet::ros::detail {
namespace {

namespace rtps_transport = eprosima::fastdds::rtps;
using eprosima::fastrtps::rtps::Locator_t;
using eprosima::fastrtps::rtps::LocatorsIterator;
using eprosima::fastrtps::rtps::octet;

// Fast DDS's base class has no virtual destructor; nobody owns an iterator through it.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wnon-virtual-dtor"
// Notes where a message goes, as the transport below goes through its destinations: it can do so only once.
class NotingIterator final : public LocatorsIterator {
 public:
  explicit NotingIterator(LocatorsIterator& inner) : inner_(inner) {}
  LocatorsIterator& operator++() override {
    ++inner_;
    return *this;
  }
  bool operator==(const LocatorsIterator& other) const override { return inner_ == other; }
  bool operator!=(const LocatorsIterator& other) const override { return inner_ != other; }
  const Locator_t& operator*() const override {
    const Locator_t& locator = *inner_;
    UdpAddress address{{}, static_cast<std::uint16_t>(locator.port)};
    std::copy_n(locator.address + 12, 4, address.ip.begin());
    if (locator.kind == LOCATOR_KIND_UDPv4 &&
        std::find(addresses_.begin(), addresses_.end(), address) == addresses_.end())
      addresses_.push_back(address);
    return locator;
  }
  const std::vector<UdpAddress>& addresses() const { return addresses_; }

 private:
  LocatorsIterator& inner_;
  mutable std::vector<UdpAddress> addresses_;
};
#pragma GCC diagnostic pop

struct HeldDescriptor : rtps_transport::ChainingTransportDescriptor {
  HeldDescriptor(std::shared_ptr<TransportDescriptorInterface> lower, std::shared_ptr<ReceptionGate> the_gate,
                 std::shared_ptr<Introduction> the_introduction)
      : ChainingTransportDescriptor(std::move(lower)),
        gate(std::move(the_gate)),
        introduction(std::move(the_introduction)) {}
  rtps_transport::TransportInterface* create_transport() const override;

  // After so many bytes a reliable writer adds a heartbeat to all readers. Fast DDS 2.9 counts what the
  // participant has repeated since it was made, not since the last such heartbeat: beyond the size of a
  // socket's buffer each sample that one reader asks for would be followed by a heartbeat to every reader
  // (docs/design/076-no-flood.md). Periodic heartbeats do the work.
  std::uint32_t min_send_buffer_size() const override { return std::numeric_limits<std::int32_t>::max(); }

  std::shared_ptr<ReceptionGate> gate;
  std::shared_ptr<Introduction> introduction;
};

class HeldTransport : public rtps_transport::ChainingTransport {
 public:
  explicit HeldTransport(const HeldDescriptor& descriptor)
      : ChainingTransport(descriptor), descriptor_(descriptor) {}

  rtps_transport::TransportDescriptorInterface* get_configuration() override { return &descriptor_; }

  bool send(eprosima::fastrtps::rtps::SenderResource* lower, const octet* buffer, std::uint32_t size,
            LocatorsIterator* begin, LocatorsIterator* end,
            const std::chrono::steady_clock::time_point& timeout) override {
    if (!EarlyHeartbeats::is_to_cyclone({buffer, size})) {
      descriptor_.introduction->sent({buffer, size}, {});
      return lower->send(buffer, size, begin, end, timeout);
    }
    NotingIterator noting(*begin);
    const bool sent = lower->send(buffer, size, &noting, end, timeout);
    descriptor_.introduction->sent({buffer, size}, noting.addresses());
    return sent;
  }

  void receive(rtps_transport::TransportReceiverInterface* next, const octet* buffer, std::uint32_t size,
               const Locator_t& local, const Locator_t& remote) override {
    if (!passed_.load(std::memory_order_acquire)) {
      descriptor_.gate->pass();
      passed_.store(true, std::memory_order_release);
    }
    const auto translated = EarlyHeartbeats::is_from_cyclone({buffer, size})
                                ? translated_farewells({buffer, size})
                                : std::vector<std::uint8_t>();
    if (translated.empty()) {
      next->OnDataReceived(buffer, size, local, remote);
    } else {
      next->OnDataReceived(translated.data(), static_cast<std::uint32_t>(translated.size()), local, remote);
    }
    descriptor_.introduction->received({buffer, size});  // after Fast DDS's own answer
  }

 private:
  HeldDescriptor descriptor_;
  std::atomic<bool> passed_{false};
};

rtps_transport::TransportInterface* HeldDescriptor::create_transport() const {
  return new HeldTransport(*this);
}

}  // namespace

void ReceptionGate::open() {
  {
    std::lock_guard lock(mutex_);
    open_ = true;
  }
  opened_.notify_all();
}

void ReceptionGate::pass() {
  std::unique_lock lock(mutex_);
  opened_.wait_for(lock, std::chrono::milliseconds(500), [this] { return open_; });
}

std::shared_ptr<ReceptionGate> hold_reception(eprosima::fastdds::dds::DomainParticipantQos& qos) {
  auto gate = std::make_shared<ReceptionGate>();
  auto introduction = std::make_shared<Introduction>();
  for (auto& transport : qos.transport().user_transports) {
    // A user's XML may name TCP, which has connections and cannot be chained.
    if (std::dynamic_pointer_cast<rtps_transport::TCPTransportDescriptor>(transport)) continue;
    transport = std::make_shared<HeldDescriptor>(transport, gate, introduction);
  }
  return gate;
}

}  // namespace goalnet::ros::detail
