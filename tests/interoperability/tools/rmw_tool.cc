// What one run of a ROS 2 command-line tool does on the wire, with Fast DDS set up as rmw_fastrtps_cpp sets
// it up and without components/ros's participant: a process that appears, works at once, and is gone. Prints
// "FIRST <ms>", the time from its start to what it waited for.
//   rmw_tool pub DOMAIN TOPIC TEXT          ros2 topic pub -1 TOPIC std_msgs/msg/String
//   rmw_tool echo DOMAIN TOPIC              ros2 topic echo --once, on a latched topic of std_msgs/msg/String
//   rmw_tool call DOMAIN SERVICE A B        ros2 service call SERVICE example_interfaces/srv/AddTwoInts
//   rmw_tool nodes DOMAIN SECONDS NAME      ros2 node list --no-daemon --spin-time SECONDS, in Jazzy's
//   layout; "found"
// ROS_LOCALHOST_ONLY=1 is obeyed as in Humble, ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST as in Jazzy.
#include <fastdds/rtps/common/WriteParams.h>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastdds/rtps/transport/shared_mem/SharedMemTransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>

#include "components/ros/detail/graph.h"
#include "components/ros/detail/message_type.h"
#include "example_interfaces/srv/AddTwoInts_service.h"
#include "std_msgs/msg/String.h"

namespace goalnet::ros {
namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;
using eprosima::fastrtps::types::ReturnCode_t;
using example_interfaces::srv::AddTwoInts;
using std_msgs::msg::String;
using SteadyClock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr auto kPatience = 10s;
const auto kStart = SteadyClock::now();

int finished(const char* what) {
  std::printf("FIRST %.1f\n%s\n",
              std::chrono::duration<double, std::milli>(SteadyClock::now() - kStart).count(), what);
  return 0;
}

int missed(const char* what) {
  std::fprintf(stderr, "rmw_tool: no %s\n", what);
  return 1;
}

bool is(const char* variable, const char* value) {
  const char* set = std::getenv(variable);
  return set != nullptr && std::string(set) == value;
}

// RMW_TOOL_UDP_ONLY=1: without shared memory. What a killed process of Fast DDS 2.9 leaves locked there stops
// the next one for ever, in the making of its participant (docs/design/020).
void choose_transports(dds::DomainParticipantQos& qos) {
  if (is("RMW_TOOL_UDP_ONLY", "1")) {
    qos.transport().use_builtin_transports = false;
    qos.transport().user_transports = {std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>()};
  }
  const bool humble = is("ROS_LOCALHOST_ONLY", "1");
  if (!humble && !is("ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST")) return;
  auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
  auto shared_memory = std::make_shared<eprosima::fastdds::rtps::SharedMemTransportDescriptor>();
  if (humble) {
    udp->interfaceWhiteList.emplace_back("127.0.0.1");
  } else {
    udp->maxInitialPeersRange = shared_memory->maxInitialPeersRange = 32;
    auto& builtin = qos.wire_protocol().builtin;
    builtin.metatrafficUnicastLocatorList.push_back(rtps::Locator_t());
    rtps::Locator_t peer;
    rtps::IPLocator::setIPv4(peer, "127.0.0.1");
    builtin.initialPeersList.push_back(peer);
  }
  qos.transport().use_builtin_transports = false;
  qos.transport().user_transports = {udp, shared_memory};
}

class Tool {
 public:
  explicit Tool(int domain) {
    auto qos = dds::PARTICIPANT_QOS_DEFAULT;
    qos.name("/");
    const char user_data[] = "enclave=/;";  // with its NUL, as rmw_fastrtps has it
    qos.user_data().data_vec({user_data, user_data + sizeof user_data});
    qos.wire_protocol().builtin.readerHistoryMemoryPolicy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
    qos.wire_protocol().builtin.writerHistoryMemoryPolicy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
    choose_transports(qos);
    participant_ = dds::DomainParticipantFactory::get_instance()->create_participant(domain, qos);
    publisher_ = participant_->create_publisher(dds::PUBLISHER_QOS_DEFAULT);
    subscriber_ = participant_->create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT);
  }
  ~Tool() {
    participant_->delete_contained_entities();
    dds::DomainParticipantFactory::get_instance()->delete_participant(participant_);
  }
  Tool(const Tool&) = delete;

  dds::DataWriter* writer(const std::string& topic, const std::string& type, bool latched, int depth) {
    auto qos = dds::DATAWRITER_QOS_DEFAULT;
    fill(qos, latched, depth);
    qos.publish_mode().kind = dds::SYNCHRONOUS_PUBLISH_MODE;
    return publisher_->create_datawriter(make_topic(topic, type), qos);
  }
  dds::DataReader* reader(const std::string& topic, const std::string& type, bool latched, int depth) {
    auto qos = dds::DATAREADER_QOS_DEFAULT;
    fill(qos, latched, depth);
    return subscriber_->create_datareader(make_topic(topic, type), qos);
  }

 private:
  template <class Qos>
  static void fill(Qos& qos, bool latched, int depth) {
    qos.reliability().kind = dds::RELIABLE_RELIABILITY_QOS;
    qos.durability().kind = latched ? dds::TRANSIENT_LOCAL_DURABILITY_QOS : dds::VOLATILE_DURABILITY_QOS;
    if (depth > 0) {
      qos.history().kind = dds::KEEP_LAST_HISTORY_QOS;
      qos.history().depth = depth;
    } else {
      qos.history().kind = dds::KEEP_ALL_HISTORY_QOS;
    }
    qos.endpoint().history_memory_policy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
    qos.data_sharing().off();
  }
  dds::Topic* make_topic(const std::string& name, const std::string& type) {
    dds::TypeSupport support(new detail::MessageType(type));
    support.register_type(participant_);
    return participant_->create_topic(name, type, dds::TOPIC_QOS_DEFAULT);
  }

  dds::DomainParticipant* participant_;
  dds::Publisher* publisher_;
  dds::Subscriber* subscriber_;
};

bool matched(dds::DataWriter* writer) {
  dds::PublicationMatchedStatus status;
  writer->get_publication_matched_status(status);
  return status.current_count > 0;
}

bool matched(dds::DataReader* reader) {
  dds::SubscriptionMatchedStatus status;
  reader->get_subscription_matched_status(status);
  return status.current_count > 0;
}

template <class Condition>
bool wait_for(const Condition& condition, std::chrono::milliseconds step) {
  const auto end = SteadyClock::now() + kPatience;
  while (!condition()) {
    if (SteadyClock::now() > end) return false;
    std::this_thread::sleep_for(step);
  }
  return true;
}

int pub(Tool& tool, const std::string& topic, const std::string& text) {
  const auto& support = idl::type_support<String>();
  auto* writer = tool.writer("rt" + topic, support.dds_name, true, 1);
  // As ros2 topic pub looks: ten times a second. Within a millisecond of this side's match the other side may
  // still be matching, and what is published then is lost to a volatile reader, of any node.
  if (!wait_for([&] { return matched(writer); }, 100ms)) return 1;
  String message;
  message.data(text);
  detail::Outgoing out;
  out.support = &support;
  out.message = &message;
  writer->write(&out);
  finished("published");
  std::this_thread::sleep_for(100ms);  // --keep-alive's default
  return 0;
}

int echo(Tool& tool, const std::string& topic) {
  const auto& support = idl::type_support<String>();
  auto* reader = tool.reader("rt" + topic, support.dds_name, true, 1);
  String message;
  const bool came = wait_for(
      [&] {
        detail::Incoming in;
        in.support = &support;
        in.layout = &detail::layout_of(support);
        in.message = &message;
        dds::SampleInfo info;
        return reader->take_next_sample(&in, &info) == ReturnCode_t::RETCODE_OK && info.valid_data;
      },
      1ms);
  return came ? finished(message.data().c_str()) : 1;
}

int call(Tool& tool, const std::string& service, std::int64_t a, std::int64_t b) {
  const auto& request_type = idl::type_support<AddTwoInts::Request>();
  const auto& response_type = idl::type_support<AddTwoInts::Response>();
  auto* reader = tool.reader("rr" + service + "Reply", response_type.dds_name, false, 10);
  auto* writer = tool.writer("rq" + service + "Request", request_type.dds_name, false, 10);
  // rmw_service_server_is_available: both matched.
  if (!wait_for([&] { return matched(writer) && matched(reader); }, 1ms)) return missed("service");
  AddTwoInts::Request request;
  request.a(a);
  request.b(b);
  detail::Outgoing out;
  out.support = &request_type;
  out.message = &request;
  rtps::WriteParams identity;
  identity.related_sample_identity().writer_guid(reader->guid());
  writer->write(&out, identity);
  AddTwoInts::Response response;
  // Every client of a service hears every reply: none may wait behind those of others.
  const auto mine = [&] {
    dds::SampleInfo info;
    detail::Incoming in;
    in.support = &response_type;
    in.layout = &detail::layout_of(response_type);
    in.message = &response;
    while (reader->take_next_sample(&in, &info) == ReturnCode_t::RETCODE_OK) {
      if (info.valid_data && info.related_sample_identity.writer_guid() == reader->guid()) return true;
    }
    return false;
  };
  return wait_for(mine, 1ms) ? finished(std::to_string(response.sum()).c_str()) : missed("answer");
}

int nodes(Tool& tool, double seconds, const std::string& name) {
  auto* reader =
      tool.reader("ros_discovery_info", "rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_", true, 0);
  const auto end = kStart + std::chrono::duration<double>(seconds);
  while (SteadyClock::now() < end) {
    detail::Incoming in;
    dds::SampleInfo info;
    if (reader->take_next_sample(&in, &info) == ReturnCode_t::RETCODE_OK && info.valid_data) {
      const auto message = detail::decode_graph(in.payload, Distro::kJazzy);
      if (!message) continue;
      for (const auto& node : message->nodes) {
        if (detail::full_name(node.node_namespace, node.name) == name) return finished("found");
      }
    } else {
      std::this_thread::sleep_for(1ms);
    }
  }
  return 1;
}

int run(const std::vector<std::string>& words) {
  if (words.size() < 3) return 13;
  Tool tool(std::atoi(words[1].c_str()));
  if (words[0] == "pub" && words.size() == 4) return pub(tool, words[2], words[3]);
  if (words[0] == "echo") return echo(tool, words[2]);
  if (words[0] == "call" && words.size() == 5)
    return call(tool, words[2], std::atoll(words[3].c_str()), std::atoll(words[4].c_str()));
  if (words[0] == "nodes" && words.size() == 4) return nodes(tool, std::atof(words[2].c_str()), words[3]);
  return 13;
}

}  // namespace
}  // namespace goalnet::ros

int main(int argc, char** argv) { return goalnet::ros::run({argv + 1, argv + argc}); }
