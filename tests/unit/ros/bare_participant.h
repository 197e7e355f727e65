// A participant of plain Fast DDS, set up as ours are, but with a transport of the test's own.
#pragma once

#include <fastdds/rtps/transport/TransportDescriptorInterface.h>
#include <fastrtps/xmlparser/XMLProfileManager.h>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>

#include <memory>

#include "components/ros/detail/message_type.h"
#include "components/ros/detail/participant.h"

namespace goalnet::ros {

struct BareParticipant {
  BareParticipant(int domain,
                  std::shared_ptr<eprosima::fastdds::rtps::TransportDescriptorInterface> transport) {
    detail::ParticipantSettings settings;
    settings.domain_id = domain;
    auto qos = detail::participant_qos(settings);
    qos.transport().user_transports = {std::move(transport)};
    participant = factory().create_participant(domain, qos);
    eprosima::fastdds::dds::TypeSupport type(new detail::MessageType("bare"));
    type.register_type(participant);
    topic = participant->create_topic("rt/bare", "bare", eprosima::fastdds::dds::TOPIC_QOS_DEFAULT);
  }
  ~BareParticipant() {
    participant->delete_contained_entities();
    factory().delete_participant(participant);
  }
  BareParticipant(const BareParticipant&) = delete;
  static eprosima::fastdds::dds::DomainParticipantFactory& factory() {
    return *eprosima::fastdds::dds::DomainParticipantFactory::get_instance();
  }
  eprosima::fastdds::dds::DomainParticipant* participant = nullptr;
  eprosima::fastdds::dds::Topic* topic = nullptr;
};

// Otherwise Fast DDS hands messages over inside of the process and nothing can get lost.
inline void talk_by_network_only(bool only) {
  eprosima::fastrtps::LibrarySettingsAttributes settings;
  if (only) settings.intraprocess_delivery = eprosima::fastrtps::INTRAPROCESS_OFF;
  eprosima::fastrtps::xmlparser::XMLProfileManager::library_settings(settings);
}

}  // namespace goalnet::ros
