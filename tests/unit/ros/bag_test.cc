// Recording and replaying over DDS: nothing is lost, quality of service follows the publishers, types need
// not be known.
#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "components/ros/bag/bag_reader.h"
#include "components/ros/bag/player.h"
#include "components/ros/bag/recorder.h"
#include "goalnet_msgs/msg/WorldState.h"
#include "rcl_interfaces/msg/Log.h"
#include "rosgraph_msgs/msg/Clock.h"
#include "std_msgs/msg/String.h"
#include "tests/unit/ros/support.h"

namespace goalnet::ros {
namespace {

using namespace std::chrono_literals;
using goalnet_msgs::msg::WorldState;
using std_msgs::msg::String;
using testing::ElementsAre;
using testing::HasSubstr;

String text(const std::string& data) {
  String message;
  message.data(data);
  return message;
}

TopicSelection select(std::vector<std::string> topics, std::string regex = "", std::string exclude = "") {
  return *TopicSelection::create({std::move(topics), std::move(regex), std::move(exclude), false});
}

struct BagTest : testing::Test {
  std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / ("bag_test_" + std::to_string(getpid()));
  std::unique_ptr<Context> context = make_context(own_domain());
  EventLoop loop;
  Node node{*context, loop, plain("robot")};

  void SetUp() override { std::filesystem::remove_all(folder); }
  void TearDown() override { std::filesystem::remove_all(folder); }

  std::unique_ptr<Recorder> recorder(TopicSelection selection, BagStorage storage = BagStorage::kMcap,
                                     std::size_t most_waiting = std::size_t{1} << 20) {
    RecorderOptions options;
    options.most_waiting = most_waiting;
    options.bag.directory = folder.string();
    options.bag.storage = storage;
    options.selection = std::move(selection);
    auto made = Recorder::create(node, std::move(options));
    if (!made) throw std::runtime_error(made.error().message);
    return std::move(*made);
  }
  void deliver() {
    while (loop.run_pending()) {
    }
  }
  std::unique_ptr<BagReader> open() {
    auto bag = BagReader::open(folder.string());
    if (!bag) throw std::runtime_error(bag.error().message);
    return std::move(*bag);
  }
  std::map<std::string, int> counts() {
    auto bag = open();
    std::map<std::string, int> out;
    BagMessage message;
    for (;;) {
      auto more = bag->next(message);
      if (!more) throw std::runtime_error(more.error().message);
      if (!*more) return out;
      ++out[bag->topics()[message.topic].name];
    }
  }
};

TEST_F(BagTest, RecordsEverythingOnceInBothStorages) {
  for (const BagStorage storage : {BagStorage::kMcap, BagStorage::kSqlite}) {
    std::filesystem::remove_all(folder);
    auto worlds = node.advertise<WorldState>("/world_state", Qos::latched());
    auto texts = node.advertise<String>("/instruction", Qos::standard());
    auto bag = recorder(select({"world_state", "/instruction"}), storage);
    WorldState world;
    world.objects({"Mug_1", "Sink"});
    for (int i = 0; i < 100; ++i) {
      worlds->publish(world);
      texts->publish(text("fill mug " + std::to_string(i)));
      deliver();
    }
    ASSERT_TRUE(bag->close());
    EXPECT_EQ(bag->message_count(), 200u);
    EXPECT_EQ(counts(), (std::map<std::string, int>{{"/instruction", 100}, {"/world_state", 100}}));
    auto reader = open();
    for (const BagTopic& topic : reader->topics()) {
      EXPECT_EQ(topic.offered.size(), 1u) << topic.name;
      EXPECT_EQ(topic.offered[0].qos.transient_local, topic.name == "/world_state");
    }
    EXPECT_THAT(reader->topics()[1].definition, HasSubstr("\n================"));
    EXPECT_THAT(reader->topics()[1].definition, HasSubstr("\nMSG: goalnet_msgs/Predicate\n"));
    EXPECT_THAT(reader->topics()[1].definition, HasSubstr("\nMSG: builtin_interfaces/Time\n"));
  }
}

TEST_F(BagTest, WhatComesFasterThanItIsWrittenIsLeftOutAndCounted) {
  auto texts = node.advertise<String>("/instruction", Qos::standard());
  auto bag = recorder(select({"/instruction"}), BagStorage::kMcap, 10'000);
  const std::string kilobyte(1000, 'a');
  for (int i = 0; i < 30; ++i) texts->publish(text(kilobyte));  // nobody writes meanwhile
  deliver();
  EXPECT_EQ(bag->message_count(), 9u) << "of 1,009 bytes each";
  EXPECT_EQ(bag->left_out(), 21u);
  texts->publish(text(kilobyte));
  deliver();
  EXPECT_EQ(bag->message_count(), 10u) << "room again";
  ASSERT_TRUE(bag->close());
}

TEST_F(BagTest, LatchedMessagesOfBeforeAreRecorded) {
  auto description = node.advertise<String>("/robot_description", Qos::latched());
  description->publish(text("<robot/>"));
  auto bag = recorder(select({}));
  loop.run_for(2s, [&] { return bag->message_count() > 0; });
  ASSERT_TRUE(bag->close());
  EXPECT_EQ(counts()["/robot_description"], 1);
}

TEST_F(BagTest, SubscribesAsThePublishersOffer) {
  auto first = node.advertise<String>("/mixed", Qos::latched());
  auto bag = recorder(select({"/mixed"}));
  first->publish(text("reliable"));
  deliver();
  auto second = node.advertise<String>("/mixed", Qos::sensor_data());
  bag->look_for_topics();
  ASSERT_TRUE(second->wait_for_subscribers());
  second->publish(text("best effort"));
  first->publish(text("reliable again"));
  loop.run_for(2s, [&] { return bag->message_count() >= 3; });
  ASSERT_TRUE(bag->close());
  EXPECT_EQ(counts()["/mixed"], 3);
  EXPECT_EQ(open()->topics()[0].offered.size(), 1u) << "the file knows whom it began with";
  EXPECT_EQ(read_bag_metadata(folder.string())->topics[0].offered.size(), 2u) << "metadata.yaml knows all";
}

TEST_F(BagTest, RecordsTypesItDoesNotKnow) {
  EndpointOptions endpoint;
  endpoint.dds_topic = "rt/strange";
  endpoint.dds_type = "somebody_msgs::msg::dds_::Strange_";
  endpoint.node = node.full_name();
  auto writer = Writer::create(context->participant(), endpoint);
  ASSERT_TRUE(writer);
  endpoint.dds_topic = "rt/no_ros_type";
  endpoint.dds_type = "HelloWorld";
  auto other = Writer::create(context->participant(), endpoint);
  ASSERT_TRUE(other);
  std::vector<std::string> warnings;
  auto log = node.subscribe<rcl_interfaces::msg::Log>("/rosout", Qos::rosout(), [&](const auto& message) {
    if (message.level() >= 30) warnings.push_back(message.msg());
  });
  auto bag = recorder(select({}, "strange|no_ros"));
  const std::vector<std::uint8_t> payload{0, 1, 0, 0, 42, 0, 0, 0};
  EXPECT_TRUE((*writer)->write_raw(payload));
  loop.run_for(2s, [&] { return bag->message_count() > 0 && warnings.size() >= 2; });
  ASSERT_TRUE(bag->close());
  auto reader = open();
  ASSERT_EQ(reader->topics().size(), 1u);
  EXPECT_EQ(reader->topics()[0].type, "somebody_msgs/msg/Strange");
  EXPECT_EQ(reader->topics()[0].definition, "");
  BagMessage message;
  ASSERT_TRUE(*reader->next(message));
  EXPECT_EQ(message.payload, payload);
  EXPECT_THAT(warnings, testing::Contains(HasSubstr("definition is not known")));
  EXPECT_THAT(warnings, testing::Contains(HasSubstr("no type of ROS 2")));
}

TEST_F(BagTest, SelectsTopicsAsAsked) {
  const TopicSelection all = select({}), named = select({"a"}), by_regex = select({}, "^/x"),
                       both = select({"/a"}, "x", "y");
  EXPECT_TRUE(all.selects("/a"));
  EXPECT_FALSE(all.selects("/follow/_action/feedback")) << "hidden";
  EXPECT_TRUE(named.selects("/a"));
  EXPECT_FALSE(named.selects("/b"));
  EXPECT_TRUE(by_regex.selects("/x1"));
  EXPECT_FALSE(by_regex.selects("/ax"));
  EXPECT_TRUE(both.selects("/a"));
  EXPECT_TRUE(both.selects("/ax"));
  EXPECT_FALSE(both.selects("/xy"));
  const auto bad = TopicSelection::create({{}, "(", "", false});
  ASSERT_FALSE(bad);
  EXPECT_THAT(bad.error().message, HasSubstr("no regular expression"));
}

struct ReplayTest : BagTest {
  // A second participant, as another process would have.
  std::unique_ptr<Context> other_context = make_context(own_domain());
  EventLoop other_loop;
  Node other{*other_context, other_loop, plain("player")};

  // "/a" standard with 0..9, "/b" latched with 0..9, each 20 ms apart.
  void record() {
    auto a = node.advertise<String>("/a"), b = node.advertise<String>("/b", Qos::latched());
    auto bag = recorder(select({"/a", "/b"}));
    for (int i = 0; i < 10; ++i) {
      a->publish(text(std::to_string(i)));
      b->publish(text(std::to_string(i)));
      loop.run_for(20ms);
    }
    ASSERT_TRUE(bag->close());
  }
  Expected<std::unique_ptr<Player>> player(PlayerOptions options) {
    return Player::create(other, open(), std::move(options));
  }
};

TEST_F(ReplayTest, PublishesWhatWasRecordedInItsTime) {
  record();
  std::vector<std::string> a;
  auto subscription = node.subscribe<String>("/a", Qos::standard().keep_last(100),
                                             [&](const String& m) { a.push_back(m.data()); });
  auto made = player({.selection = select({}), .rate = 2.0});
  ASSERT_TRUE(made) << made.error().message;
  ASSERT_TRUE(subscription->wait_for_publishers());
  const auto start = std::chrono::steady_clock::now();
  ASSERT_TRUE((*made)->play([] { return false; }));
  const auto took = std::chrono::steady_clock::now() - start;
  EXPECT_GE(took, 500ms + 85ms) << "half a second of delay and 9 times 10 ms";
  loop.run_for(2s, [&] { return a.size() >= 10; });
  EXPECT_THAT(a, ElementsAre("0", "1", "2", "3", "4", "5", "6", "7", "8", "9"));
  EXPECT_EQ((*made)->message_count(), 20u);
  // Who comes late gets what was latched.
  std::vector<std::string> b;
  auto late = node.subscribe<String>("/b", Qos::latched(), [&](const String& m) { b.push_back(m.data()); });
  loop.run_for(5s, [&] { return !b.empty(); });
  EXPECT_EQ(b.back(), "9");
}

TEST_F(ReplayTest, PlaysTheClockAndLoopsUntilStopped) {
  record();
  std::vector<std::int64_t> times;
  auto clock = node.subscribe<rosgraph_msgs::msg::Clock>(
      "/clock", Qos::clock().keep_last(1000),
      [&](const auto& m) { times.push_back(Time(m.clock()).nanoseconds); });
  auto made = player({.selection = select({"/a"}), .rate = 5.0, .clock_hz = 200.0, .loop = true});
  ASSERT_TRUE(made) << made.error().message;
  ASSERT_TRUE(clock->wait_for_publishers());
  ASSERT_TRUE((*made)->play([&] { return (*made)->message_count() >= 25; }));
  loop.run_for(200ms);
  EXPECT_EQ((*made)->message_count(), 25u) << "two rounds and a half";
  ASSERT_GT(times.size(), 3u);
  EXPECT_GT(times.front(), 1'000'000'000'000'000'000)
      << "the recording's time, which is wall-clock time here";
}

TEST_F(ReplayTest, SaysWhatCannotBePlayed) {
  record();
  const auto none = player({.selection = select({"/nothing"})});
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().message, HasSubstr("none of these topics"));
}

}  // namespace
}  // namespace goalnet::ros
