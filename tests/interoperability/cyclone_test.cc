// goalnet and Cyclone DDS on one network: topics both ways, and many peers that come and go at once, also
// such as make Fast DDS 2.9 abort in its default configuration (abort_test.cc).
#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "components/ros/node.h"
#include "goalnet_msgs/msg/WorldState.h"
#include "sensor_msgs/msg/JointState.h"
#include "std_msgs/msg/String.h"
#include "tests/support/process.h"
#include "tests/unit/ros/support.h"

namespace goalnet::ros {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
using testing_support::Process;

const int kDomain = own_domain();

std::unique_ptr<Process> peer(const std::string& mode, const std::string& seconds,
                              bool separate_ports = false) {
  std::map<std::string, std::string> environment;
  if (separate_ports) environment["CYCLONEDDS_URI"] = kCycloneWithSeparatePorts;
  return std::make_unique<Process>(std::vector<std::string>{testing_support::program("cyclone_peer"), mode,
                                                            std::to_string(kDomain), seconds},
                                   environment);
}

goalnet_msgs::msg::WorldState world() {
  goalnet_msgs::msg::WorldState message;
  message.header().stamp(Time(12'000'000'345).to_msg());
  message.header().frame_id("map");
  message.objects({"Mug_1", "Sink", "Straße"});
  goalnet_msgs::msg::Predicate on;
  on.relation("On");
  on.subject("Mug_1");
  on.object("Sink");
  goalnet_msgs::msg::Predicate graspable;
  graspable.relation("IsGraspable");
  graspable.subject("Mug_1");
  message.facts({on, graspable});
  return message;
}

TEST(Cyclone, ReadsOurTopicsCorrectly) {
  auto context = make_context(kDomain);
  EventLoop loop;
  Node node(*context, loop, plain("robot"));
  auto worlds = node.advertise<goalnet_msgs::msg::WorldState>("/world_state", Qos::latched());
  auto joints = node.advertise<sensor_msgs::msg::JointState>("/joint_states", Qos::standard());
  worlds->publish(world());  // before the reader exists: it is latched
  node.log().warn("the tap {} 100 %", "runs at");
  auto reader = peer("read", "10");
  ASSERT_TRUE(joints->wait_for_subscribers(1, 5s));
  sensor_msgs::msg::JointState state;
  state.header().stamp(Time(1'500'000'000).to_msg());
  state.name({"base_x", "left_arm_1"});
  state.position({-0.25, 1.0 / 3.0});
  // Best effort and volatile: what is sent before the reader knows the writer is lost, so it is sent often.
  auto timer = node.create_timer(20ms, [&] { joints->publish(state); });
  EXPECT_TRUE(loop.run_for(5s, [&] { return reader->out().find("joint_states") != std::string::npos; }));
  EXPECT_TRUE(reader->wait_for_text("world_state", 5s));
  EXPECT_TRUE(reader->wait_for_text("rosout", 5s));
  const std::string out = reader->out();
  EXPECT_THAT(out, HasSubstr("world_state 12.000000345 map objects Mug_1 Sink Straße facts (On Mug_1 Sink) "
                             "(IsGraspable Mug_1)\n"));
  EXPECT_THAT(out, HasSubstr("joint_states 1.500000000 base_x=-0.250000 left_arm_1=0.333333\n"));
  EXPECT_THAT(out, HasSubstr("rosout 30 robot: the tap runs at 100 %\n"));
}

// Larger than a UDP datagram: sent in fragments, latched.
TEST(Cyclone, ReadsLargeMessages) {
  auto context = make_context(kDomain);
  EventLoop loop;
  Node node(*context, loop, plain("robot"));
  auto worlds = node.advertise<goalnet_msgs::msg::WorldState>("/world_state", Qos::latched());
  auto large = world();
  std::string all;
  for (int i = 0; i < 3000; ++i) {
    large.objects().push_back("Object_" + std::to_string(i) + std::string(90, 'x'));
    all += " " + large.objects().back();
  }
  ASSERT_GT(all.size(), 300'000u);
  worlds->publish(large);
  auto reader = peer("read", "10");
  EXPECT_TRUE(reader->wait_for_text("Straße" + all + " facts", 8s));
}

TEST(Cyclone, WritesToOurTopics) {
  auto context = make_context(kDomain);
  EventLoop loop;
  Node node(*context, loop, plain("robot"));
  std::string seen;
  auto in = node.subscribe<std_msgs::msg::String>("/instruction", Qos::standard(),
                                                  [&](const std_msgs::msg::String& m) { seen = m.data(); });
  auto writer = peer("write", "5");
  EXPECT_TRUE(loop.run_for(5s, [&] { return !seen.empty(); }));
  EXPECT_THAT(seen, testing::StartsWith("fill mug "));
}

// In fragments of Cyclone's own size, to one who comes after it was published.
TEST(Cyclone, LatchesLargeMessagesForUs) {
  auto writer = peer("latch", "10");
  ASSERT_TRUE(writer->wait_for_text("ready", 5s)) << writer->err();
  auto context = make_context(kDomain);
  EventLoop loop;
  Node node(*context, loop, plain("robot"));
  std::string seen;
  auto in = node.subscribe<std_msgs::msg::String>("/robot_description", Qos::latched(),
                                                  [&](const std_msgs::msg::String& m) { seen = m.data(); });
  EXPECT_TRUE(loop.run_for(5s, [&] { return !seen.empty(); }));
  ASSERT_EQ(seen.size(), 300'000u);
  for (std::size_t i = 0; i < seen.size(); ++i) ASSERT_EQ(seen[i], static_cast<char>('a' + i % 26)) << i;
}

// Not ten seconds after its process has gone.
TEST(Cyclone, AReaderThatGoesIsNotWrittenTo) {
  auto context = make_context(kDomain);
  EventLoop loop;
  Node node(*context, loop, plain("robot"));
  auto joints = node.advertise<sensor_msgs::msg::JointState>("/joint_states", Qos::standard());
  auto other = peer("undo", "30");
  ASSERT_TRUE(joints->wait_for_subscribers(1, 10s));
  ASSERT_TRUE(other->wait_for_text("undone", 10s));
  loop.run_for(5s, [&] { return joints->subscriber_count() == 0; });
  EXPECT_EQ(joints->subscriber_count(), 0u);
  EXPECT_FALSE(other->ended());
}

TEST(Cyclone, FiftyRoundsOfPeersComingAndGoing) {
  auto context = make_context(kDomain);
  EventLoop loop;
  Node node(*context, loop, plain("robot"));
  auto worlds = node.advertise<goalnet_msgs::msg::WorldState>("/world_state", Qos::latched());
  auto joints = node.advertise<sensor_msgs::msg::JointState>("/joint_states", Qos::standard());
  auto command = node.advertise<std_msgs::msg::String>("/executor_command", Qos::standard());
  int seen = 0;
  auto in = node.subscribe<std_msgs::msg::String>("/instruction", Qos::standard(),
                                                  [&](const std_msgs::msg::String&) { ++seen; });
  worlds->publish(world());
  sensor_msgs::msg::JointState state;
  state.name({"base_x"});
  state.position({1.0});
  auto traffic = node.create_timer(2ms, [&] {
    joints->publish(state);
    worlds->publish(world());
  });
  std::size_t most = 0;
  for (int round = 0; round < 50; ++round) {
    std::vector<std::unique_ptr<Process>> peers;
    for (int i = 0; i < 5; ++i) peers.push_back(peer("churn", "0.25", round % 4 >= 2));
    loop.run_for(320ms, [&] {
      most = std::max(most, joints->subscriber_count());
      return false;
    });
    if (round % 2 == 0) continue;  // killed in the middle of it
    for (auto& one : peers) one->wait(2s);
  }
  EXPECT_GE(most, 3u) << "the peers were really matched with us";
  EXPECT_GT(seen, 20);
}

}  // namespace
}  // namespace goalnet::ros
