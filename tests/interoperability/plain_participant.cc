// plain_participant DOMAIN: a participant of Fast DDS as it comes, without components/ros, until it is ended.
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <unistd.h>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>

#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv) {
  namespace dds = eprosima::fastdds::dds;
  if (argc != 2) return 13;
  dds::DomainParticipantQos qos = dds::PARTICIPANT_QOS_DEFAULT;
  qos.transport().use_builtin_transports = false;  // its death leaves no shared memory behind
  qos.transport().user_transports = {std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>()};
  if (dds::DomainParticipantFactory::get_instance()->create_participant(
          static_cast<std::uint32_t>(std::atoi(argv[1])), qos) == nullptr) {
    return 39;
  }
  std::puts("up");
  std::fflush(stdout);
  for (;;) pause();
}
