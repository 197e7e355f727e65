// Makes a bag whole whose recorder was killed.
#pragma once

#include <string>

#include "components/core/outcome.h"
#include "components/ros/bag/bag_metadata.h"

namespace goalnet::ros {

// Reads the bag files of `directory`, writes each one that is not finished again, with its index, and writes
// metadata.yaml anew for what is there. What is damaged beyond that is kInvalidRequest, and nothing is
// changed.
Expected<BagMetadata> repair_bag(const std::string& directory, Distro distro);

}  // namespace goalnet::ros
