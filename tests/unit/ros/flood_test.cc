// What a participant says of its endpoints: soon again to who has not acknowledged it, and only then
// (docs/design/076-no-flood.md).
#include <gtest/gtest.h>

#include <thread>

#include "components/ros/detail/rtps_message.h"
#include "std_msgs/msg/String.h"
#include "tests/unit/ros/bare_participant.h"
#include "tests/unit/ros/fake_participant.h"
#include "tests/unit/ros/support.h"

namespace goalnet::ros {
namespace {

using namespace std::chrono_literals;
using Bytes = FakeParticipant::Bytes;
using SteadyClock = std::chrono::steady_clock;

const int kFloodDomain = own_domain();

// Heartbeats that come to `peer` in a second from the two writers that tell of endpoints. It acknowledges
// nothing.
int heartbeats_in_a_second(FakeParticipant& peer) {
  int count = 0;
  for (const auto end = SteadyClock::now() + 1s; SteadyClock::now() < end;) {
    const Bytes message = peer.received();
    detail::rtps_message::for_each_submessage(message, [&](std::uint8_t kind, std::uint8_t, auto body) {
      count +=
          kind == detail::rtps_message::kHeartbeat && body.size() >= 8 && body[5] == 0 && body[7] == 0xc2;
      return true;
    });
  }
  return count;
}

TEST(EndpointNews, ComeAgainTenTimesASecond) {
  auto context = make_context(kFloodDomain);
  EventLoop loop;
  Node node(*context, loop, plain("robot"));
  FakeParticipant peer(kFloodDomain);
  peer.announce();
  const int heartbeats = heartbeats_in_a_second(peer);
  EXPECT_GE(heartbeats, 2 * 5) << "a tool of ROS 2 looks for half a second";
  EXPECT_LE(heartbeats, 2 * 14);
}

// Fast DDS alone: once the participant has repeated more than fits a socket's buffer, every bystander gets a
// heartbeat for each sample that a newcomer is told.
TEST(EndpointNews, ForNewcomersAreNotToldToAll) {
  talk_by_network_only(true);
  {
    auto context = make_context(kFloodDomain);
    EventLoop loop;
    Node node(*context, loop, plain("robot"));
    std::vector<std::shared_ptr<Publisher<std_msgs::msg::String>>> many;
    for (int i = 0; i < 150; ++i) {
      many.push_back(
          node.advertise<std_msgs::msg::String>("/a_topic_of_many_" + std::to_string(i), Qos::standard()));
    }
    const auto visit = [&] {
      auto newcomer = make_context(kFloodDomain);
      EventLoop its_loop;
      Node its_node(*newcomer, its_loop, plain("visitor"));
      auto last = its_node.subscribe<std_msgs::msg::String>("/a_topic_of_many_149", Qos::standard(),
                                                            [](const std_msgs::msg::String&) {});
      EXPECT_TRUE(many.back()->wait_for_subscribers(1, 5s));
      std::this_thread::sleep_for(300ms);
    };
    for (int i = 0; i < 4; ++i) visit();
    FakeParticipant bystander(kFloodDomain);
    bystander.announce();
    std::thread one_more(visit);
    EXPECT_LE(heartbeats_in_a_second(bystander), 60);
    one_more.join();
  }
  talk_by_network_only(false);
}

}  // namespace
}  // namespace goalnet::ros
