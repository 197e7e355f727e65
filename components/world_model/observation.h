// What the world model is told, without DDS types. Times are nanoseconds of one clock.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "components/scene/shape.h"

namespace goalnet::world_model {

struct ObservedPose {
  std::string name;
  scene::Pose pose = scene::Pose::Identity();  // in the map frame
};

struct ObservedPoses {
  std::int64_t time_ns = 0;
  std::vector<ObservedPose> objects;
};

struct ObservedJoints {
  std::int64_t time_ns = 0;
  std::vector<std::string> names;
  std::vector<double> positions;  // [rad or m], one for each name
};

struct ObservedState {
  std::string name;
  std::vector<std::string> values;
};

}  // namespace goalnet::world_model
