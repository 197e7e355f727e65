// What other participants see of us: nodes, endpoints, type hashes, names that come and go; the environment.
#include <fastrtps/utils/IPLocator.h>
#include <gmock/gmock-more-matchers.h>
#include <gtest/gtest.h>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/domain/DomainParticipantListener.hpp>

#include <cstdlib>
#include <map>
#include <mutex>

#include "components/ros/detail/graph.h"
#include "components/ros/detail/graph_peers.h"
#include "components/ros/detail/participant.h"
#include "components/ros/service.h"
#include "std_msgs/msg/String.h"
#include "std_srvs/srv/Trigger_service.h"
#include "tests/unit/ros/support.h"

namespace goalnet::ros {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

// A bare Fast DDS participant that only listens to discovery, as a ROS 2 tool does.
struct Watcher : dds::DomainParticipantListener {
  std::mutex mutex;
  std::map<std::string, std::string> user_data;  // of endpoints, by topic
  std::string participant_name, participant_data;
  int participants = 0;
  dds::DomainParticipant* participant = nullptr;

  explicit Watcher(int domain) {
    participant = dds::DomainParticipantFactory::get_instance()->create_participant(
        domain, dds::PARTICIPANT_QOS_DEFAULT, this, dds::StatusMask::none());
  }
  ~Watcher() override { dds::DomainParticipantFactory::get_instance()->delete_participant(participant); }

  void on_participant_discovery(dds::DomainParticipant*, rtps::ParticipantDiscoveryInfo&& info) override {
    std::lock_guard lock(mutex);
    if (info.status == rtps::ParticipantDiscoveryInfo::DISCOVERED_PARTICIPANT) {
      ++participants;
      participant_name = info.info.m_participantName.to_string();
      participant_data.assign(info.info.m_userData.begin(), info.info.m_userData.end());
    } else if (info.status == rtps::ParticipantDiscoveryInfo::REMOVED_PARTICIPANT) {
      --participants;
    }
  }
  void on_publisher_discovery(dds::DomainParticipant*, rtps::WriterDiscoveryInfo&& info) override {
    remember(info.info.topicName().to_string(), info.info.m_qos.m_userData);
  }
  void on_subscriber_discovery(dds::DomainParticipant*, rtps::ReaderDiscoveryInfo&& info) override {
    remember(info.info.topicName().to_string(), info.info.m_qos.m_userData);
  }
  template <class Data>
  void remember(const std::string& topic, const Data& data) {
    std::lock_guard lock(mutex);
    user_data[topic] = std::string(data.begin(), data.end());
  }
  bool wait_for(const std::function<bool()>& condition) {
    for (int i = 0; i < 400; ++i) {
      {
        std::lock_guard lock(mutex);
        if (condition()) return true;
      }
      std::this_thread::sleep_for(10ms);
    }
    return false;
  }
};

TEST(Graph, JazzyEndpointsCarryTheirTypeHash) {
  Watcher watcher(own_domain());
  auto context = make_context(own_domain(), Distro::kJazzy);
  EventLoop loop;
  Node node(*context, loop, plain("robot"));
  auto out = node.advertise<std_msgs::msg::String>("/chatter", Qos::standard());
  Server<std_srvs::srv::Trigger> server(node, "/do_it", [](const auto&, auto&) {});
  ASSERT_TRUE(watcher.wait_for([&] {
    return watcher.user_data.contains("rt/chatter") && watcher.user_data.contains("rr/do_itReply");
  }));
  ASSERT_TRUE(watcher.wait_for([&] { return watcher.user_data.contains("rq/do_itRequest"); }));
  const auto hash = [](const char* type) {
    return "typehash=" + std::string(idl::find_type(type)->hash) + ";";
  };
  EXPECT_EQ(watcher.user_data["rt/chatter"], hash("std_msgs/msg/String"));
  EXPECT_EQ(watcher.user_data["rq/do_itRequest"], hash("std_srvs/srv/Trigger_Request"));
  EXPECT_EQ(watcher.user_data["rr/do_itReply"], hash("std_srvs/srv/Trigger_Response"));
  EXPECT_EQ(watcher.user_data["ros_discovery_info"], hash("rmw_dds_common/msg/ParticipantEntitiesInfo"));
  EXPECT_TRUE(watcher.user_data.contains("rq/robot/get_type_descriptionRequest"));
  EXPECT_EQ(watcher.participant_name, "/");
  EXPECT_EQ(watcher.participant_data, std::string("enclave=/;\0", 11));
}

TEST(Graph, HumbleHasNoTypeHashAndNoTypeDescription) {
  Watcher watcher(own_domain());
  auto context = make_context(own_domain(), Distro::kHumble);
  EventLoop loop;
  Node node(*context, loop, plain("robot"));
  auto out = node.advertise<std_msgs::msg::String>("/chatter", Qos::standard());
  ASSERT_TRUE(watcher.wait_for([&] { return watcher.user_data.contains("rt/chatter"); }));
  EXPECT_EQ(watcher.user_data["rt/chatter"], "");
  EXPECT_FALSE(watcher.user_data.contains("rq/robot/get_type_descriptionRequest"));
}

// The last ros_discovery_info that a reader of another participant got.
struct GraphReader {
  GraphReader(const std::shared_ptr<detail::Participant>& participant, Distro d) : distro(d) {
    EndpointOptions options;
    options.dds_topic = "ros_discovery_info";
    options.dds_type = "rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_";
    options.qos = Qos::latched().keep_last(100);
    Reader::Callbacks callbacks;
    callbacks.on_payload = [this](std::vector<std::uint8_t> payload, const SampleInfo& info) {
      if (info.from_this_participant) return;
      std::lock_guard lock(mutex);
      const auto message = detail::decode_graph(payload, distro);
      ASSERT_TRUE(message);
      last = *message;
    };
    reader = *Reader::create(participant, options, std::move(callbacks));
  }
  bool wait_for(const std::function<bool(const detail::GraphMessage&)>& condition) {
    for (int i = 0; i < 400; ++i) {
      {
        std::lock_guard lock(mutex);
        if (condition(last)) return true;
      }
      std::this_thread::sleep_for(10ms);
    }
    return false;
  }
  Distro distro;
  std::mutex mutex;
  detail::GraphMessage last;
  std::shared_ptr<Reader> reader;
};

TEST(Graph, NodesAndEndpointsComeAndGo) {
  for (const Distro distro : {Distro::kJazzy, Distro::kHumble}) {
    auto tool = make_context(own_domain(), distro);
    GraphReader reader(tool->participant(), distro);
    auto context = make_context(own_domain(), distro);
    EventLoop loop;
    NodeOptions options = plain("robot");
    options.node_namespace = "/kitchen";
    auto node = std::make_unique<Node>(*context, loop, options);
    auto out = node->advertise<std_msgs::msg::String>("/chatter", Qos::standard());
    const Gid gid = out->gid();
    const auto lists = [&](const detail::GraphMessage& message) {
      return message.nodes.size() == 1 && message.nodes[0].name == "robot" &&
             message.nodes[0].node_namespace == "/kitchen" &&
             std::count(message.nodes[0].writers.begin(), message.nodes[0].writers.end(), gid) == 1;
    };
    EXPECT_TRUE(reader.wait_for(lists)) << to_string(distro);
    out.reset();
    EXPECT_TRUE(reader.wait_for([&](const auto& message) {
      return !message.nodes.empty() && !lists(message);
    })) << to_string(distro);
    node.reset();
    EXPECT_TRUE(reader.wait_for([](const auto& message) { return message.nodes.empty(); }))
        << to_string(distro);
  }
}

TEST(Graph, HostileGraphMessagesAreRefused) {
  detail::Graph graph(Gid{});
  graph.add_node("/", "n");
  auto bytes = graph.encode(Distro::kJazzy);
  const auto with = [&](std::size_t at, std::uint32_t value) {
    auto copy = bytes;
    std::memcpy(copy.data() + at, &value, 4);
    return copy;
  };
  EXPECT_TRUE(detail::decode_graph(bytes, Distro::kJazzy));
  EXPECT_FALSE(detail::decode_graph(with(20, 0xffffffff), Distro::kJazzy)) << "four billion nodes";
  EXPECT_FALSE(detail::decode_graph(with(24, 0x7fffffff), Distro::kJazzy)) << "a namespace of two gigabytes";
  EXPECT_FALSE(detail::decode_graph(with(40, 0x10000000), Distro::kJazzy)) << "readers without end";
}

// The same node in both layouts, written out byte by byte: participant, one node with a reader and two
// writers.
TEST(Graph, GoldenBytesOfBothLayouts) {
  const auto gid = [](std::uint8_t number, std::uint8_t kind) {
    return Gid{0x01, 0x0f, 0xaa, 0xbb, 0xcc, 0xdd, 0xee, 0xff, 0, 0, 0, 0, 0, 0, number, kind};
  };
  detail::Graph graph(gid(0x01, 0xc1));
  graph.add_node("/kitchen", "robot");
  ASSERT_TRUE(graph.add("/kitchen/robot", gid(0x03, 0x03), true));
  ASSERT_TRUE(graph.add("/kitchen/robot", gid(0x04, 0x04), false));
  ASSERT_TRUE(graph.add("/kitchen/robot", gid(0x05, 0x03), true));
  for (const Distro distro : {Distro::kHumble, Distro::kJazzy}) {
    const std::string rest = distro == Distro::kHumble ? "0000000000000000" : "";
    const std::string expected =
        "00010000"  // plain CDR, little endian
        "010faabbccddeeff00000000000001c1" +
        rest +      // the participant
        "01000000"  // one node
        "090000002f6b69746368656e00"
        "000000"  // "/kitchen", padding
        "06000000726f626f7400"
        "0000"  // "robot", padding
        "01000000"
        "010faabbccddeeff0000000000000404" +
        rest +
        "02000000"
        "010faabbccddeeff0000000000000303" +
        rest + "010faabbccddeeff0000000000000503" + rest;
    std::string ours;
    for (const std::uint8_t byte : graph.encode(distro)) {
      char digits[3];
      std::snprintf(digits, sizeof digits, "%02x", byte);
      ours += digits;
    }
    EXPECT_EQ(ours, expected) << to_string(distro);
  }
}

TEST(UserData, TypeHashesAreFoundAmongOtherPairs) {
  const auto hash_in = [](const std::string& text) {
    return detail::type_hash_of({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  };
  const std::string hash = idl::find_type("std_msgs/msg/String")->hash;
  EXPECT_EQ(hash_in(detail::endpoint_user_data(Distro::kJazzy, hash)), hash);
  EXPECT_EQ(hash_in("serviceid= 1.10.6a.1;typehash=" + hash + ";"), hash) << "as rmw_cyclonedds writes it";
  EXPECT_EQ(hash_in(""), "");
  EXPECT_EQ(hash_in("typehash=" + hash), "") << "not ended";
  EXPECT_EQ(hash_in("typehash=" + hash + "0;"), "");
  EXPECT_EQ(hash_in("typehash=RIHS01_xyz;typehash=" + hash + ";"), hash) << "the malformed one is skipped";
  EXPECT_EQ(detail::endpoint_user_data(Distro::kHumble, hash), "");
}

TEST(GraphPeers, RememberForgetAndReportOnce) {
  detail::Graph other(Gid{1, 2, 3});
  other.add_node("/", "a");
  other.add_node("/kitchen", "b");
  detail::GraphPeers peers(Distro::kJazzy);
  EXPECT_FALSE(peers.take(other.encode(Distro::kJazzy)));
  EXPECT_THAT(peers.names(), testing::ElementsAre("/a", "/kitchen/b"));
  peers.add_own("/a");
  const auto clash = peers.take(other.encode(Distro::kJazzy));
  ASSERT_TRUE(clash);
  EXPECT_THAT(*clash, HasSubstr("a node called /a"));
  EXPECT_FALSE(peers.take(other.encode(Distro::kJazzy))) << "said once";
  // Another distribution's layout, both ways, is recognised; rubbish too; each is said once.
  const auto layout = peers.take(other.encode(Distro::kHumble));
  ASSERT_TRUE(layout);
  EXPECT_THAT(*layout, HasSubstr("humble"));
  EXPECT_FALSE(peers.take(other.encode(Distro::kHumble)));
  detail::GraphPeers humble(Distro::kHumble);
  EXPECT_THAT(humble.take(other.encode(Distro::kJazzy)).value_or(""), HasSubstr("jazzy"));
  const std::vector<std::uint8_t> rubbish = {0, 1, 0, 0, 5, 5, 5};
  EXPECT_THAT(peers.take(rubbish).value_or(""), HasSubstr("malformed"));
  EXPECT_FALSE(peers.take(rubbish));
  peers.forget(Gid{1, 2, 3});
  EXPECT_THAT(peers.names(), testing::IsEmpty());
  // A hostile number of participants stays bounded.
  for (int i = 0; i < 3000; ++i) {
    Gid gid{};
    std::memcpy(gid.data(), &i, sizeof i);
    detail::Graph one(gid);
    one.add_node("/", "n");
    peers.take(one.encode(Distro::kJazzy));
  }
  EXPECT_LE(peers.names().size(), 1000u);
}

struct Environment {
  Environment(const char* name, const char* value) : name_(name) { setenv(name, value, 1); }
  ~Environment() { unsetenv(name_); }
  const char* name_;
};

// Where the first announcements go: everybody's port of the multicast address, and the peers' own ports.
TEST(Settings, FirstAnnouncements) {
  using Range = detail::ParticipantSettings::Range;
  const auto peers = [](Range range, const std::string& static_peers) {
    detail::ParticipantSettings settings;
    settings.domain_id = 7;
    settings.range = range;
    settings.static_peers = static_peers;
    std::vector<std::string> found;
    const auto qos = detail::participant_qos(settings);
    for (const auto& locator : qos.wire_protocol().builtin.initialPeersList)
      found.push_back(rtps::IPLocator::toIPv4string(locator) + ":" + std::to_string(locator.port));
    return found;
  };
  using testing::ElementsAre;
  EXPECT_THAT(peers(Range::kSubnet, ""), testing::IsEmpty()) << "Fast DDS's default";
  EXPECT_THAT(peers(Range::kSubnet, "10.0.0.1"), ElementsAre("239.255.0.1:9150", "10.0.0.1:0"));
  testing::internal::CaptureStderr();
  EXPECT_THAT(peers(Range::kSubnet, "nobody.invalid;10.0.0.1"),
              ElementsAre("239.255.0.1:9150", "10.0.0.1:0"));
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("'nobody.invalid' cannot be looked up"));
  EXPECT_THAT(peers(Range::kLocalhost, "10.0.0.1"), ElementsAre("127.0.0.1:0", "10.0.0.1:0"));
  EXPECT_THAT(peers(Range::kLoopback, ""), ElementsAre("239.255.0.1:9150", "127.0.0.1:0"));
}

TEST(Settings, FromTheEnvironment) {
  using Range = detail::ParticipantSettings::Range;
  {
    Environment domain("ROS_DOMAIN_ID", "42");
    Environment distro("GOALNET_ROS_DISTRO", "humble");
    Environment range("ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST");
    const auto settings = detail::read_settings({});
    ASSERT_TRUE(settings);
    EXPECT_EQ(settings->domain_id, 42);
    EXPECT_EQ(settings->distro, Distro::kHumble);
    EXPECT_EQ(settings->range, Range::kLocalhost);
    EXPECT_EQ(detail::read_settings({.domain_id = 7})->domain_id, 7) << "what is given wins";
  }
  {
    Environment range("ROS_AUTOMATIC_DISCOVERY_RANGE", "SUBNET");
    Environment localhost("ROS_LOCALHOST_ONLY", "1");
    EXPECT_EQ(detail::read_settings({})->range, Range::kLocalhost) << "the older variable overrides";
    EXPECT_EQ(detail::read_settings({.distro = Distro::kHumble})->range, Range::kLoopback);
  }
  EXPECT_EQ(detail::read_settings({})->distro, Distro::kJazzy);
  {
    Environment sourced("ROS_DISTRO", "humble");
    EXPECT_EQ(detail::read_settings({})->distro, Distro::kHumble) << "started from a shell with ROS 2 in it";
    Environment chosen("GOALNET_ROS_DISTRO", "jazzy");
    EXPECT_EQ(detail::read_settings({})->distro, Distro::kJazzy) << "who says so wins";
  }
  for (const char* other : {"jazzy", "kilted", "noetic", ""}) {
    Environment sourced("ROS_DISTRO", other);
    EXPECT_EQ(detail::read_settings({})->distro, Distro::kJazzy) << other;
  }
  {
    Environment secure("ROS_SECURITY_ENABLE", "true");
    EXPECT_TRUE(detail::read_settings({})) << "Permissive: as without";
    Environment strategy("ROS_SECURITY_STRATEGY", "Enforce");
    const auto settings = detail::read_settings({});
    ASSERT_FALSE(settings) << "nothing of ours may speak openly where encryption is demanded";
    EXPECT_THAT(settings.error().message, HasSubstr("ROS_SECURITY_ENABLE"));
  }
  const std::pair<const char*, const char*> bad[] = {{"ROS_DOMAIN_ID", "kitchen"},
                                                     {"ROS_DOMAIN_ID", "300"},
                                                     {"GOALNET_ROS_DISTRO", "foxy"},
                                                     {"ROS_LOCALHOST_ONLY", "yes"},
                                                     {"ROS_AUTOMATIC_DISCOVERY_RANGE", "NEAR"}};
  for (const auto& [name, value] : bad) {
    Environment variable(name, value);
    const auto settings = detail::read_settings({});
    ASSERT_FALSE(settings) << name;
    EXPECT_THAT(settings.error().message, HasSubstr(name));
  }
}

TEST(Settings, LocalhostParticipantsFindEachOther) {
  Environment range("ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST");
  auto first = make_context(own_domain());
  auto second = make_context(own_domain());
  EventLoop loop;
  Node a(*first, loop, plain("a"));
  Node b(*second, loop, plain("b"));
  auto out = a.advertise<std_msgs::msg::String>("/chatter", Qos::standard());
  auto in = b.subscribe<std_msgs::msg::String>("/chatter", Qos::standard(), [](const auto&) {});
  EXPECT_TRUE(out->wait_for_subscribers(1, 3s));
}

}  // namespace
}  // namespace goalnet::ros
