// plain_writer default|ours DOMAIN SECONDS: Fast DDS without components/ros, writing topics that cyclone_peer
// churns on. `default` has Fast DDS's own participant configuration, on UDP so that its death leaves no
// shared memory behind; `ours` has that of components/ros. It reads nothing: a reader of its own would, if it
// is quick, open the address whose being unopened ends the process.
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>

#include <chrono>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include "components/ros/detail/message_type.h"
#include "components/ros/detail/participant.h"
#include "std_msgs/msg/String.h"

namespace goalnet::ros {
namespace {

namespace dds = eprosima::fastdds::dds;

int run(const std::string& configuration, int domain, double seconds) {
  detail::ParticipantSettings settings;
  settings.domain_id = domain;
  const bool ours = configuration == "ours";
  dds::DomainParticipantQos qos = ours ? detail::participant_qos(settings) : dds::PARTICIPANT_QOS_DEFAULT;
  if (!ours) {
    qos.transport().use_builtin_transports = false;
    qos.transport().user_transports = {std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>()};
  }
  auto* participant =
      dds::DomainParticipantFactory::get_instance()->create_participant(settings.domain_id, qos);
  const auto& support = idl::type_support<std_msgs::msg::String>();
  dds::TypeSupport(new detail::MessageType(support.dds_name)).register_type(participant);
  auto* publisher = participant->create_publisher(dds::PUBLISHER_QOS_DEFAULT);
  std::vector<dds::DataWriter*> writers;
  for (const char* name : {"rt/instruction", "rt/instruction_status_text", "rt/executor_command"}) {
    auto* topic = participant->create_topic(name, support.dds_name, dds::TOPIC_QOS_DEFAULT);
    writers.push_back(publisher->create_datawriter(topic, detail::writer_qos(Qos::latched(), "")));
  }
  std_msgs::msg::String message;
  message.data("hello");
  detail::Outgoing out;
  out.support = &support;
  out.message = &message;
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (std::chrono::steady_clock::now() < end) {
    for (auto* writer : writers) writer->write(&out);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  participant->delete_contained_entities();
  dds::DomainParticipantFactory::get_instance()->delete_participant(participant);
  return 0;
}

}  // namespace
}  // namespace goalnet::ros

int main(int argc, char** argv) {
  if (argc != 4) return 13;
  return goalnet::ros::run(argv[1], std::atoi(argv[2]), std::atof(argv[3]));
}
