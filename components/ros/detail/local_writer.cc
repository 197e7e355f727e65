#include "components/ros/detail/local_writer.h"

#include <fastdds/rtps/attributes/WriterAttributes.h>

namespace eprosima::fastrtps::rtps {

// Of Fast DDS; in its library, in none of its installed headers.
class RTPSDomainImpl {
 public:
  static RTPSWriter* find_local_writer(const GUID_t& guid);
};

}  // namespace eprosima::fastrtps::rtps

namespace goalnet::ros::detail {

namespace rtps = eprosima::fastrtps::rtps;

rtps::RTPSWriter* local_writer(const rtps::GUID_t& guid) {
  return rtps::RTPSDomainImpl::find_local_writer(guid);
}

void tell_of_endpoints_again_soon(const rtps::GUID_t& participant) {
  rtps::WriterAttributes attributes;  // of these only the times can be changed later
  attributes.times.heartbeatPeriod = eprosima::fastrtps::Duration_t(0, 100'000'000);
  attributes.times.nackResponseDelay = eprosima::fastrtps::Duration_t(0, 100'000);  // as Fast DDS has it
  attributes.times.nackSupressionDuration = eprosima::fastrtps::Duration_t(0, 10'000);
  for (const rtps::EntityId_t& entity : {rtps::c_EntityId_SEDPPubWriter, rtps::c_EntityId_SEDPSubWriter}) {
    if (auto* writer = local_writer({participant.guidPrefix, entity})) writer->updateAttributes(attributes);
  }
}

}  // namespace goalnet::ros::detail
