// What real ROS 2 nodes and tools sent each other, from ../shared/data/ros2.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "components/ros/context.h"
#include "components/ros/endpoint.h"

namespace goalnet::ros {

using Bytes = std::vector<std::uint8_t>;

struct CapturedSample {
  std::string node;                 // full name of the sender
  std::string topic;                // DDS name
  std::string type;                 // ROS name, pkg/msg/Type
  SampleId id;                      // of the writer
  std::optional<SampleId> related;  // from the inline QoS
  Bytes payload;                    // with encapsulation; without the header below
  Bytes header;                     // of services by rmw_cyclonedds: 16 bytes between the two

  bool is_request() const { return topic.starts_with("rq/"); }
  bool is_reply() const { return topic.starts_with("rr/"); }
  Bytes as_sent() const;
  bool from(const std::string& full_name) const { return node == full_name; }
};

// One set of captures: Humble with rmw_fastrtps_cpp ("hf"), Jazzy with rmw_cyclonedds_cpp ("jc").
struct CaptureSet {
  std::string prefix;
  Distro distro;
};
inline const CaptureSet kHumbleCaptures{"hf", Distro::kHumble};
inline const CaptureSet kJazzyCaptures{"jc", Distro::kJazzy};

std::filesystem::path captures_folder();

// All samples in order of time. Throws what nlohmann_json throws for a damaged file.
std::vector<CapturedSample> load_captures(const CaptureSet& set);

// Rows of *_endpoints_table.txt that belong to `node`, without the padding between columns.
std::vector<std::string> load_endpoint_rows(const CaptureSet& set, const std::string& node);

Bytes from_hex(const std::string& text);

}  // namespace goalnet::ros
