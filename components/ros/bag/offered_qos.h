// Quality of service in bags: as rosbag2 writes it, and what rosbag2 makes of it.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "components/core/outcome.h"
#include "components/ros/context.h"
#include "components/ros/qos.h"

namespace goalnet::ros {

// A YAML list without a newline at its end: words for Jazzy (metadata version 9), rmw's numbers for Humble
// (5).
std::string offered_qos_yaml(std::span<const OfferedQos> offered, Distro distro);

// Reads either. kInvalidRequest for anything else; an empty text is an empty list.
Expected<std::vector<OfferedQos>> parse_offered_qos(const std::string& yaml);

// What to subscribe with, so that all of these publishers are heard: reliable, or transient local, only where
// all of them are.
Qos request_for(std::span<const OfferedQos> offered);

// What to publish with in their place: their profile where all agree on what matters, else the default one.
// History does not travel, so it is the default one or, where known, the deepest.
Qos offer_in_place_of(std::span<const OfferedQos> offered);

}  // namespace goalnet::ros
