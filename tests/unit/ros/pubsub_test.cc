// Publishers and subscriptions over real DDS: inside one participant, between participants, hostile samples.
#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "components/ros/node.h"
#include "sensor_msgs/msg/JointState.h"
#include "std_msgs/msg/Int32.h"
#include "std_msgs/msg/String.h"
#include "tests/unit/ros/support.h"

namespace goalnet::ros {
namespace {

using namespace std::chrono_literals;
using std_msgs::msg::Int32;
using std_msgs::msg::String;

Int32 number(int value) {
  Int32 message;
  message.data(value);
  return message;
}

TEST(PubSub, OneProcessDeliversSynchronouslyAndInOrderOfPublication) {
  auto context = make_context(own_domain());
  EventLoop loop;
  Node writer(*context, loop, plain("writer"));
  Node reader(*context, loop, plain("reader"));
  std::vector<int> seen;
  auto a = writer.advertise<Int32>("/a", Qos::standard());
  auto b = writer.advertise<Int32>("/b", Qos::standard());
  auto on_a =
      reader.subscribe<Int32>("/a", Qos::standard(), [&](const Int32& m) { seen.push_back(m.data()); });
  auto on_b =
      reader.subscribe<Int32>("/b", Qos::standard(), [&](const Int32& m) { seen.push_back(-m.data()); });
  ASSERT_EQ(a->subscriber_count(), 1u) << "endpoints of one participant match at once";
  ASSERT_EQ(b->subscriber_count(), 1u);

  std::vector<int> expected;
  for (int i = 1; i <= 2000; ++i) {
    // All is queued when publish() returns: one run_pending() must see exactly these, in this order.
    ASSERT_TRUE(b->publish(number(i)));
    ASSERT_TRUE(a->publish(number(i)));
    ASSERT_TRUE(a->publish(number(i + 1)));
    expected.insert(expected.end(), {-i, i, i + 1});
    ASSERT_TRUE(loop.run_pending());
    ASSERT_EQ(seen.size(), expected.size()) << "delivery was not synchronous at " << i;
  }
  EXPECT_EQ(seen, expected);
}

TEST(PubSub, QueueKeepsTheNewestOfABurst) {
  auto context = make_context(own_domain());
  EventLoop loop;
  Node node(*context, loop, plain("node"));
  std::vector<int> seen;
  auto out = node.advertise<Int32>("burst", Qos::standard().keep_last(1000));
  auto in = node.subscribe<Int32>("burst", Qos::standard().keep_last(3),
                                  [&](const Int32& m) { seen.push_back(m.data()); });
  for (int i = 0; i < 100; ++i) out->publish(number(i));
  while (loop.run_pending()) {
  }
  EXPECT_THAT(seen, testing::ElementsAre(97, 98, 99));
}

TEST(PubSub, TwoParticipantsMatchQuickly) {
  auto first = make_context(own_domain());
  EventLoop loop;
  Node writer(*first, loop, plain("writer"));
  auto out = writer.advertise<String>("/chatter", Qos::standard());
  const auto start = std::chrono::steady_clock::now();
  auto second = make_context(own_domain());
  Node reader(*second, loop, plain("reader"));
  std::string seen;
  auto in =
      reader.subscribe<String>("/chatter", Qos::sensor_data(), [&](const String& m) { seen = m.data(); });
  ASSERT_TRUE(out->wait_for_subscribers(1, 2s));
  ASSERT_TRUE(in->wait_for_publishers(1, 2s));
  EXPECT_LT(std::chrono::steady_clock::now() - start, 1s);
  String message;
  message.data("grüß dich");
  out->publish(message);
  EXPECT_TRUE(loop.run_for(2s, [&] { return !seen.empty(); }));
  EXPECT_EQ(seen, "grüß dich");
}

TEST(PubSub, LatecomersGetLatchedMessages) {
  auto context = make_context(own_domain());
  EventLoop loop;
  Node node(*context, loop, plain("node"));
  auto out = node.advertise<Int32>("/latched", Qos::latched());
  out->publish(number(1));
  out->publish(number(2));
  auto other = make_context(own_domain());
  Node late(*other, loop, plain("late"));
  std::vector<int> seen;
  auto in =
      late.subscribe<Int32>("/latched", Qos::latched(), [&](const Int32& m) { seen.push_back(m.data()); });
  EXPECT_TRUE(loop.run_for(2s, [&] { return !seen.empty(); }));
  EXPECT_THAT(seen, testing::ElementsAre(2));
}

TEST(PubSub, MalformedSamplesAreDroppedAndReported) {
  auto context = make_context(own_domain());
  EventLoop loop;
  Node node(*context, loop, plain("node"));
  const auto& type = idl::type_support<sensor_msgs::msg::JointState>();
  EndpointOptions raw = EndpointOptions::of(type, "rt/joint_states", Qos::standard(), node.full_name());
  raw.support = nullptr;
  auto hostile = Writer::create(context->participant(), raw);
  ASSERT_TRUE(hostile);
  auto good = node.advertise<sensor_msgs::msg::JointState>("/joint_states", Qos::standard());
  int seen = 0;
  auto in = node.subscribe<sensor_msgs::msg::JointState>("/joint_states", Qos::standard(),
                                                         [&](const auto&) { ++seen; });
  const std::vector<std::vector<std::uint8_t>> samples = {
      {},                                                                           // nothing
      {0, 1, 0},                                                                    // no encapsulation
      {0, 3, 0, 0, 1, 2, 3, 4},                                                     // parameter list
      {0, 1, 0, 0, 1, 0, 0, 0},                                                     // ends in the stamp
      {0, 1, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 0xff, 0xff, 0xff, 0xff},                 // frame_id of 4 GiB
      {0, 1, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0, 0xff, 0, 0, 0, 0, 0, 0, 0},  // not UTF-8
      {0, 1, 0, 0, 1, 0, 0,    0,    2,    0,    0, 0, 1, 0,
       0, 0, 0, 0, 0, 0, 0xff, 0xff, 0xff, 0x7f, 0, 0, 0, 0},  // 2^31 names
      {0, 1, 0, 0, 1, 0, 0, 0, 2, 0, 0,    0,    1,    0,
       0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xff, 0xff, 0xff, 0x3f}};  // 2^30 positions
  for (const auto& sample : samples) (*hostile)->write_raw(sample);
  while (loop.run_pending()) {
  }
  EXPECT_EQ(seen, 0);
  EXPECT_GE(in->dropped(), samples.size() - 1) << "an empty payload may never reach a reader";
  good->publish({});
  while (loop.run_pending()) {
  }
  EXPECT_EQ(seen, 1) << "good messages still arrive";
}

TEST(PubSub, AFloodIsBounded) {
  auto context = make_context(own_domain());
  EventLoop loop;
  Node node(*context, loop, plain("node"));
  auto out = node.advertise<Int32>("/flood", Qos::standard());
  int seen = 0;
  auto in = node.subscribe<Int32>("/flood", Qos::standard(), [&](const Int32&) { ++seen; });
  std::jthread flood([&] {
    for (int i = 0; i < 10'000; ++i) out->publish(number(i));
  });
  flood.join();
  while (loop.run_pending()) {
  }
  EXPECT_EQ(seen, 10) << "exactly the depth of the queue waits";
}

TEST(PubSub, ImmediateCallbacksComeInTheWritersThread) {
  auto context = make_context(own_domain());
  EventLoop loop;
  Node node(*context, loop, plain("node"));
  std::thread::id where;
  auto out = node.advertise<Int32>("/cancel", Qos::standard());
  auto in =
      node.subscribe<Int32>("/cancel", Qos::standard(),
                            [&](const Int32&) { where = std::this_thread::get_id(); }, {.immediate = true});
  out->publish(number(1));
  EXPECT_EQ(where, std::this_thread::get_id());
}

TEST(PubSub, AnArrivalIsToldAtOnceAndBeforeItsTurnInTheLoop) {
  auto context = make_context(own_domain());
  EventLoop loop;
  Node node(*context, loop, plain("node"));
  std::vector<int> arrived, handled;
  auto out = node.advertise<Int32>("/goal", Qos::standard());
  auto in = node.subscribe<Int32>(
      "/goal", Qos::standard(),
      [&](const Int32& message) {
        handled.push_back(message.data());
        EXPECT_EQ(arrived, (std::vector<int>{1, 2}));
      },
      {}, [&](const Int32& message) { arrived.push_back(message.data()); });
  out->publish(number(1));
  out->publish(number(2));
  EXPECT_EQ(arrived, (std::vector<int>{1, 2}));
  EXPECT_TRUE(handled.empty());
  while (loop.run_pending()) {
  }
  EXPECT_EQ(handled, (std::vector<int>{1, 2}));
}

TEST(PubSub, DestroyedSubscriptionsAreSilent) {
  auto context = make_context(own_domain());
  EventLoop loop;
  Node node(*context, loop, plain("node"));
  int seen = 0;
  auto out = node.advertise<Int32>("/gone", Qos::standard());
  auto in = node.subscribe<Int32>("/gone", Qos::standard(), [&](const Int32&) { ++seen; });
  out->publish(number(1));
  in.reset();
  EXPECT_EQ(out->subscriber_count(), 0u);
  while (loop.run_pending()) {
  }
  EXPECT_EQ(seen, 0);
}

}  // namespace
}  // namespace goalnet::ros
