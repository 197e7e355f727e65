// metadata.yaml of a rosbag2 directory, in the version that the chosen distribution reads.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "components/ros/context.h"
#include "components/ros/qos.h"

namespace goalnet::ros {

struct BagTopic {
  std::string name;  // /world_state
  std::string type;  // goalnet_msgs/msg/WorldState
  std::string type_hash;
  Qos qos;
  std::uint64_t message_count = 0;
};

struct BagSummary {
  std::string file;            // name of the MCAP file in the directory
  std::uint64_t start = 0;     // [ns since 1970] first message
  std::uint64_t duration = 0;  // [ns]
  std::vector<BagTopic> topics;
};

// Version 9 for Jazzy, 5 for Humble (which cannot read 9).
std::string bag_metadata(const BagSummary& summary, Distro distro);

// One offered QoS profile as a YAML list: words for Jazzy, rmw's numbers for Humble.
std::string qos_yaml(const Qos& qos, Distro distro);

}  // namespace goalnet::ros
