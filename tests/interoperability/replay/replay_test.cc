// Captured exchanges of real ROS 2 tools with a real node, replayed against our services, action, parameters
// and lifecycle: the requests go in byte by byte under the identities of the real clients; every reply and
// every message that the real nodes sent must come out of ours, in the same order.
#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <deque>

#include "action_msgs/msg/GoalStatusArray.h"
#include "action_msgs/srv/CancelGoal_service.h"
#include "components/ros/detail/graph.h"
#include "components/ros/detail/message_type.h"
#include "rcl_interfaces/msg/Log.h"
#include "rcl_interfaces/msg/ParameterEvent.h"
#include "rcl_interfaces/srv/ListParameters_service.h"
#include "rcl_interfaces/srv/SetParameters_service.h"
#include "tests/interoperability/replay/captured_client.h"
#include "tests/interoperability/replay/captures.h"
#include "tests/interoperability/replay/golden_nodes.h"
#include "tests/unit/ros/support.h"

namespace goalnet::ros {
namespace {

using namespace std::chrono_literals;

const int kReplayDomain = own_domain();

struct Decoded {
  const idl::TypeSupport* support;
  std::shared_ptr<void> message;
};

Decoded decoded(const std::string& type, const Bytes& payload) {
  const auto* support = idl::find_type_support(type);
  EXPECT_NE(support, nullptr) << type;
  Decoded out{support, std::shared_ptr<void>(support->create(), support->destroy)};
  const char* fault = detail::decode(*support, detail::layout_of(*support), payload, out.message.get());
  EXPECT_EQ(fault, nullptr) << type << ": " << fault;
  return out;
}

// Sets what must differ between two runs (times, file names, wording of a refusal) to one value on both
// sides, after looking that it is there at all.
void level(Decoded& one) {
  const std::string type = one.support->ros_name;
  const builtin_interfaces::msg::Time zero;
  const auto as = [&]<class Message>(Message*) -> Message& {
    return *static_cast<Message*>(one.message.get());
  };
  if (type == "example_interfaces/action/Fibonacci_SendGoal_Response") {
    auto& m = as(static_cast<GoldenNode::Fibonacci::SendGoal::Response*>(nullptr));
    EXPECT_GT(m.stamp().sec(), 0);
    m.stamp(zero);
  } else if (type == "action_msgs/msg/GoalStatusArray") {
    for (auto& goal : as(static_cast<action_msgs::msg::GoalStatusArray*>(nullptr)).status_list()) {
      EXPECT_GT(goal.goal_info().stamp().sec(), 0);
      goal.goal_info().stamp(zero);
    }
  } else if (type == "action_msgs/srv/CancelGoal_Response") {
    for (auto& goal : as(static_cast<action_msgs::srv::CancelGoal::Response*>(nullptr)).goals_canceling()) {
      EXPECT_GT(goal.stamp().sec(), 0);
      goal.stamp(zero);
    }
  } else if (type == "rcl_interfaces/msg/ParameterEvent") {
    auto& m = as(static_cast<rcl_interfaces::msg::ParameterEvent*>(nullptr));
    EXPECT_GT(m.stamp().sec(), 0);
    m.stamp(zero);
  } else if (type == "rcl_interfaces/msg/Log") {
    auto& m = as(static_cast<rcl_interfaces::msg::Log*>(nullptr));
    EXPECT_GT(m.stamp().sec(), 0);
    EXPECT_FALSE(m.file().empty());
    EXPECT_FALSE(m.function().empty());
    EXPECT_GT(m.line(), 0u);
    m.stamp(zero);
    m.file("");
    m.function("");
    m.line(0);
  } else if (type == "rcl_interfaces/srv/SetParameters_Response") {
    for (auto& result : as(static_cast<rcl_interfaces::srv::SetParameters::Response*>(nullptr)).results()) {
      EXPECT_NE(result.successful(), !result.reason().empty()) << "a refusal has a reason";
      result.reason("");
    }
  } else if (type == "rcl_interfaces/srv/ListParameters_Response") {
    // rclpy lists in order of declaration, rclcpp and we by name.
    auto& names = as(static_cast<rcl_interfaces::srv::ListParameters::Response*>(nullptr)).result().names();
    std::sort(names.begin(), names.end());
  }
}

void expect_equal(const CapturedSample& captured, const Bytes& ours) {
  SCOPED_TRACE(captured.topic);
  Decoded theirs = decoded(captured.type, captured.payload);
  Decoded mine = decoded(captured.type, ours);
  level(theirs);
  level(mine);
  EXPECT_EQ(detail::encode(*mine.support, mine.message.get()),
            detail::encode(*theirs.support, theirs.message.get()))
      << "of sample " << captured.id.sequence;
}

// Everything the golden nodes publish, by topic, as another participant receives it.
class Listener {
 public:
  explicit Listener(Context& context) : context_(context) {}
  void listen(const std::string& topic, const std::string& type) {
    if (readers_.contains(topic)) return;
    EndpointOptions options;
    options.dds_topic = topic;
    options.dds_type = idl::dds_type_name(type);
    options.qos = Qos::latched().keep_last(1000);
    options.qos.transient_local = topic.ends_with("/status") || topic == "rt/rosout";
    Reader::Callbacks callbacks;
    callbacks.on_payload = [this, topic](Bytes payload, const SampleInfo&) {
      std::lock_guard lock(mutex_);
      arrived_[topic].push_back(std::move(payload));
    };
    readers_[topic] = Reader::create(context_.participant(), options, std::move(callbacks)).value();
    EXPECT_TRUE(readers_[topic]->wait_for_matched(1, 5s)) << topic;
  }
  std::optional<Bytes> next(const std::string& topic) {
    std::lock_guard lock(mutex_);
    auto& queue = arrived_[topic];
    if (queue.empty()) return std::nullopt;
    Bytes payload = std::move(queue.front());
    queue.pop_front();
    return payload;
  }
  std::size_t left() const {
    std::lock_guard lock(mutex_);
    std::size_t sum = 0;
    for (const auto& [topic, queue] : arrived_) sum += queue.size();
    return sum;
  }

 private:
  Context& context_;
  mutable std::mutex mutex_;
  std::map<std::string, std::deque<Bytes>> arrived_;
  std::map<std::string, std::shared_ptr<Reader>> readers_;
};

struct Replay : testing::Test {
  void SetUp() override {
    if (!std::filesystem::exists(captures_folder()))
      GTEST_SKIP() << "no reference data at " << captures_folder();
  }
  static bool golden(const CapturedSample& sample) {
    return sample.from("/golden/golden_node") || sample.from("/golden/golden_lc");
  }
  void run(const CaptureSet& set);
};

void Replay::run(const CaptureSet& set) {
  const auto samples = load_captures(set);
  EventLoop loop;
  GoldenNode node(kReplayDomain, set.distro, loop);
  GoldenLifecycleNode lifecycle(kReplayDomain, set.distro, loop);
  auto context = make_context(kReplayDomain, set.distro);
  Listener listener(*context);
  for (const auto& sample : samples) {
    if (golden(sample) && sample.topic.starts_with("rt/") && sample.topic != "rt/chatter") {
      listener.listen(sample.topic, sample.type);
    }
  }
  std::map<std::string, std::unique_ptr<CapturedClient>> clients;  // by node
  std::vector<const CapturedSample*> asked;  // requests whose reply was not looked at yet
  int requests = 0, replies = 0, messages = 0, said = 0;
  for (const auto& sample : samples) {
    const bool to_golden = sample.is_request() || sample.topic == "rt/cmd";
    if (to_golden) {
      auto& client = clients[sample.node];
      if (!client) client = std::make_unique<CapturedClient>(kReplayDomain, sample.id.writer);
      if (sample.is_request()) {
        ++requests;
        asked.push_back(&sample);
        ASSERT_TRUE(client->send(sample)) << sample.topic;
      } else {
        ++said;
        ASSERT_TRUE(client->publish(sample));
      }
    } else if (golden(sample) && sample.is_reply()) {
      ++replies;
      // The request it answers: the oldest open one to this service (captures are in order of time).
      const std::string service = sample.topic.substr(3, sample.topic.size() - 3 - 5);
      const auto request = std::find_if(asked.begin(), asked.end(), [&](const auto* one) {
        return one->topic == "rq/" + service + "Request";
      });
      ASSERT_NE(request, asked.end()) << sample.topic;
      const CapturedClient& client = *clients[(*request)->node];
      const auto count = static_cast<std::size_t>((*request)->id.sequence);
      const auto there = [&] {
        node.end_if_due();
        return client.replies_to(**request).size() >= count;
      };
      ASSERT_TRUE(loop.run_for(20s, there)) << "no reply to " << (*request)->topic;
      auto reply = client.replies_to(**request)[count - 1];
      if (sample.related) {
        EXPECT_EQ(reply.related, *sample.related) << "the very identity that rmw_fastrtps wrote";
      } else {
        ASSERT_GE(reply.payload.size(), 20u);
        const auto header = reply.payload.begin() + 4;
        EXPECT_EQ(Bytes(header, header + 16), sample.header) << "the very header that rmw_cyclonedds wrote";
        reply.payload.erase(header, header + 16);
      }
      expect_equal(sample, reply.payload);
      asked.erase(request);
    } else if (golden(sample) && sample.topic.starts_with("rt/") && sample.topic != "rt/chatter") {
      ++messages;
      if (sample.topic.ends_with("/feedback")) node.step();
      std::optional<Bytes> payload;
      const auto there = [&] {
        node.end_if_due();  // shows in its status
        payload = listener.next(sample.topic);
        return payload.has_value();
      };
      ASSERT_TRUE(loop.run_for(20s, there)) << "nothing on " << sample.topic;
      expect_equal(sample, *payload);
    }
  }
  loop.run_for(200ms);
  EXPECT_TRUE(asked.empty()) << "every request was answered in the capture, and here";
  EXPECT_GE(requests, 28);
  EXPECT_EQ(replies, requests);
  EXPECT_GE(messages, 25);
  EXPECT_EQ(node.heard(), std::vector<std::string>(static_cast<std::size_t>(said), "hi"));
  EXPECT_EQ(listener.left(), 0u) << "nothing is sent that the real nodes do not send";
}

TEST_F(Replay, HumbleExchanges) { run(kHumbleCaptures); }
TEST_F(Replay, JazzyExchanges) { run(kJazzyCaptures); }

// ros_discovery_info of real participants, through DDS into our graph.
TEST_F(Replay, DiscoverySamplesFillTheGraph) {
  for (const CaptureSet& set : {kHumbleCaptures, kJazzyCaptures}) {
    auto context = make_context(kReplayDomain, set.distro);
    std::map<std::string, std::unique_ptr<CapturedClient>> participants;
    std::map<std::string, std::vector<std::string>> said;  // by participant: what it said last
    int compared = 0;
    for (const auto& sample : load_captures(set)) {
      if (sample.topic != "ros_discovery_info") continue;
      const std::string key(sample.id.writer.begin(), sample.id.writer.begin() + 12);
      auto& participant = participants[key];
      if (!participant) participant = std::make_unique<CapturedClient>(kReplayDomain, sample.id.writer);
      ASSERT_TRUE(participant->publish(sample));
      said[key].clear();
      const auto message = detail::decode_graph(sample.payload, set.distro);
      ASSERT_TRUE(message);
      for (const auto& node : message->nodes)
        said[key].push_back(detail::full_name(node.node_namespace, node.name));
      std::vector<std::string> all;
      for (const auto& [other, names] : said) all.insert(all.end(), names.begin(), names.end());
      std::sort(all.begin(), all.end());
      for (int i = 0; i < 300 && context->other_nodes() != all; ++i) std::this_thread::sleep_for(10ms);
      ASSERT_EQ(context->other_nodes(), all);
      if (!all.empty()) ++compared;
    }
    EXPECT_GE(participants.size(), 3u);
    EXPECT_GT(compared, 70);
    participants.clear();
    for (int i = 0; i < 300 && !context->other_nodes().empty(); ++i) std::this_thread::sleep_for(10ms);
    EXPECT_TRUE(context->other_nodes().empty());
  }
}

}  // namespace
}  // namespace goalnet::ros
