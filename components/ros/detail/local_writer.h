// The writers below Fast DDS's DataWriters, and those that come with a participant: its public interface has
// no way to them.
#pragma once

#include <fastdds/rtps/common/Guid.h>
#include <fastdds/rtps/writer/RTPSWriter.h>

namespace goalnet::ros::detail {

// nullptr where this process has no such writer.
eprosima::fastrtps::rtps::RTPSWriter* local_writer(const eprosima::fastrtps::rtps::GUID_t& guid);

// How soon the writers that tell of a participant's endpoints ask again whether everybody has heard. Fast
// DDS's second is longer than the half of a second for which ROS 2's tools look
// (docs/design/076-no-flood.md).
void tell_of_endpoints_again_soon(const eprosima::fastrtps::rtps::GUID_t& participant);

}  // namespace goalnet::ros::detail
