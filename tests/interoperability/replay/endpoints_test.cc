// What a node of ours makes in DDS against what real nodes make: every row of *_endpoints_table.txt, and
// ros_discovery_info byte by byte.
#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>

#include "components/ros/detail/participant.h"
#include "tests/interoperability/replay/captures.h"
#include "tests/interoperability/replay/golden_nodes.h"
#include "tests/support/endpoint_watcher.h"
#include "tests/unit/ros/support.h"

namespace goalnet::ros {
namespace {

using testing::UnorderedElementsAreArray;

const int kDomain = own_domain();

struct Endpoints : testing::Test {
  void SetUp() override {
    if (!std::filesystem::exists(captures_folder()))
      GTEST_SKIP() << "no reference data at " << captures_folder();
  }
};

Gid gid_of(Context& context) { return context.participant()->gid(); }

// Equal but for the GUID prefix, which differs from run to run, and for padding, which is uninitialised
// memory.
Bytes with_prefix(Bytes payload, const Bytes& from, const Gid& to) {
  for (std::size_t i = 0; i + 12 <= payload.size(); ++i) {
    if (std::equal(from.begin(), from.begin() + 12, payload.begin() + static_cast<std::ptrdiff_t>(i)))
      std::copy_n(to.begin(), 12, payload.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return payload;
}

// The payload of a node's ros_discovery_info that lists the most.
Bytes fullest_graph(const std::vector<CapturedSample>& samples, const std::string& node) {
  Bytes fullest;
  for (const auto& sample : samples) {
    if (sample.topic == "ros_discovery_info" && sample.from(node) && sample.payload.size() > fullest.size())
      fullest = sample.payload;
  }
  return fullest;
}

// Each row equal, entity ids included: rmw_fastrtps makes the same endpoints in the same order.
template <class Golden>
void expect_humble_rows(const std::string& name) {
  EndpointWatcher watcher(kDomain);
  EventLoop loop;
  Golden golden(kDomain, Distro::kHumble, loop);
  const auto expected = load_endpoint_rows(kHumbleCaptures, name);
  ASSERT_GT(expected.size(), 15u);
  std::vector<std::string> rows;
  for (const auto& one : watcher.endpoints_of(gid_of(golden.context()), expected.size()))
    rows.push_back(one.row());
  EXPECT_THAT(rows, UnorderedElementsAreArray(expected)) << name;

  const Bytes captured = fullest_graph(load_captures(kHumbleCaptures), name);
  ASSERT_GT(captured.size(), 500u);
  const Bytes prefix(captured.begin() + 4, captured.begin() + 16);
  const auto graph = golden.context().participant()->graph();
  const Bytes reference = with_prefix(captured, prefix, gid_of(golden.context()));
  const Bytes ours = graph.encode(Distro::kHumble, 0);
  const Bytes other_padding = graph.encode(Distro::kHumble, 0xff);
  ASSERT_GE(reference.size(), ours.size());
  ASSERT_LT(reference.size() - ours.size(), 4u);
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const bool padding = ours[i] != other_padding[i];
    ASSERT_TRUE(padding || ours[i] == reference[i]) << name << " byte " << i;
  }
}

TEST_F(Endpoints, HumbleNodeIsEqualRowByRow) { expect_humble_rows<GoldenNode>("/golden/golden_node"); }
TEST_F(Endpoints, HumbleLifecycleNodeIsEqualRowByRow) {
  expect_humble_rows<GoldenLifecycleNode>("/golden/golden_lc");
}
TEST_F(Endpoints, HumbleActionClientIsEqualRowByRow) { expect_humble_rows<GoldenClient>("/golden_client"); }

// Cyclone numbers its endpoints in another order and announces more; all else is equal.
template <class Golden>
void expect_jazzy_rows(const std::string& name) {
  EndpointWatcher watcher(kDomain);
  EventLoop loop;
  Golden golden(kDomain, Distro::kJazzy, loop);
  std::vector<std::string> expected, rows;
  for (const auto& row : load_endpoint_rows(kJazzyCaptures, name)) expected.push_back(vendor_free_row(row));
  ASSERT_GT(expected.size(), 15u);
  std::map<Gid, std::string> row_of;
  for (const auto& one : watcher.endpoints_of(gid_of(golden.context()), expected.size())) {
    rows.push_back(one.vendor_free_row());
    row_of[one.gid] = one.topic;
  }
  EXPECT_THAT(rows, UnorderedElementsAreArray(expected)) << name;

  // ros_discovery_info lists the same endpoints below the same names, in the same layout.
  const auto captured =
      detail::decode_graph(fullest_graph(load_captures(kJazzyCaptures), name), Distro::kJazzy);
  ASSERT_TRUE(captured);
  ASSERT_EQ(captured->nodes.size(), 1u);
  const Bytes payload = golden.context().participant()->graph().encode(Distro::kJazzy);
  const auto ours = detail::decode_graph(payload, Distro::kJazzy);
  ASSERT_TRUE(ours);
  ASSERT_EQ(ours->nodes.size(), 1u);
  EXPECT_EQ(ours->nodes[0].name, captured->nodes[0].name);
  EXPECT_EQ(ours->nodes[0].node_namespace, captured->nodes[0].node_namespace);
  EXPECT_EQ(ours->nodes[0].readers.size(), captured->nodes[0].readers.size());
  EXPECT_EQ(ours->nodes[0].writers.size(), captured->nodes[0].writers.size());
  std::vector<std::string> listed, announced;
  for (const auto* gids : {&ours->nodes[0].readers, &ours->nodes[0].writers}) {
    for (const Gid& gid : *gids) listed.push_back(row_of[gid]);
  }
  for (const auto& [gid, topic] : row_of) {
    if (topic != "ros_discovery_info") announced.push_back(topic);
  }
  EXPECT_THAT(listed, UnorderedElementsAreArray(announced))
      << "all but the endpoints of ros_discovery_info itself";
}

TEST_F(Endpoints, JazzyNodeIsEqual) { expect_jazzy_rows<GoldenNode>("/golden/golden_node"); }
TEST_F(Endpoints, JazzyLifecycleNodeIsEqual) { expect_jazzy_rows<GoldenLifecycleNode>("/golden/golden_lc"); }
TEST_F(Endpoints, JazzyActionClientIsEqual) { expect_jazzy_rows<GoldenClient>("/golden_client"); }

TEST_F(Endpoints, ComeAndGoAsTheyAreMadeAndDestroyed) {
  EndpointWatcher watcher(kDomain);
  auto context = make_context(kDomain);
  EventLoop loop;
  auto node = std::make_unique<Node>(*context, loop, plain("robot"));
  const auto becomes = [&](const std::string& topic, std::size_t count) {
    for (int i = 0; i < 500 && watcher.count_on(topic) != count; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return watcher.count_on(topic) == count;
  };
  auto out = node->advertise<std_msgs::msg::String>("/chatter");
  auto in = node->subscribe<std_msgs::msg::String>("/chatter", Qos::standard(), [](const auto&) {});
  EXPECT_TRUE(becomes("rt/chatter", 2));
  out.reset();
  EXPECT_TRUE(becomes("rt/chatter", 1));
  in.reset();
  EXPECT_TRUE(becomes("rt/chatter", 0));
  EXPECT_EQ(watcher.count_on("rt/rosout"), 1u);
  node.reset();
  EXPECT_TRUE(becomes("rt/rosout", 0));
  EXPECT_TRUE(becomes("rq/robot/get_parametersRequest", 0));
}

}  // namespace
}  // namespace goalnet::ros
