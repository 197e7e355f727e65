// What a bag says about one topic.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "components/ros/qos.h"

namespace goalnet::ros {

struct BagTopic {
  std::string name;                 // /world_state
  std::string type;                 // goalnet_msgs/msg/WorldState
  std::string type_hash;            // RIHS01_...; "" if unknown
  std::vector<OfferedQos> offered;  // one for each publisher seen
  std::string definition;           // ros2msg text with all dependencies; "" if unknown
  std::string serialization_format = "cdr";
  std::uint64_t message_count = 0;
};

// One message as it lies in a bag.
struct BagMessage {
  std::size_t topic = 0;              // index into the reader's topics()
  std::uint64_t log_time = 0;         // [ns] when recorded
  std::uint64_t publish_time = 0;     // [ns] when sent; log_time where the storage does not keep it
  std::vector<std::uint8_t> payload;  // with its 4 bytes of encapsulation
};

}  // namespace goalnet::ros
