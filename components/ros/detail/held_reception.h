// Keeps what arrives in the socket until the participant listens.
//
// Fast DDS 2.9 announces a new participant before it listens: the sockets are open and read, but what arrives
// before its enable() ends is thrown away. Peers answer an unknown participant at once and only once; whoever
// is interrupted in that moment, as on a busy machine, misses the answer and meets them at their next
// periodic announcement, up to three seconds later. So the receiving threads wait here until the participant
// is made; the kernel keeps the datagrams.
#pragma once

#include <fastdds/dds/domain/qos/DomainParticipantQos.hpp>

#include <condition_variable>
#include <memory>
#include <mutex>

namespace goalnet::ros::detail {

// Thread-safe.
class ReceptionGate {
 public:
  void open();
  // Waits until it is open, at most half a second: a participant that could not be made closes its sockets,
  // and that waits for whoever waits here.
  void pass();

 private:
  std::mutex mutex_;
  std::condition_variable opened_;
  bool open_ = false;
};

// Puts the gate before all transports of `qos` but TCP, and lets an Introduction hear what goes through them.
// Open it as soon as the participant is made.
std::shared_ptr<ReceptionGate> hold_reception(eprosima::fastdds::dds::DomainParticipantQos& qos);

}  // namespace goalnet::ros::detail
