// A robot in a room: what most components load from the names or files that they are given.
#pragma once

#include <string>

#include "components/core/outcome.h"
#include "components/robot/robot_model.h"
#include "components/scene/scene.h"

namespace goalnet {

struct Setting {
  scene::Scene scene;
  robot::RobotModel robot;
};

// Names in config/scenes and config/robots, or files; an empty robot is the default one. Fails with
// kInvalidRequest and the message of what cannot be loaded.
Expected<Setting> load_setting(const std::string& scene, const std::string& robot);

}  // namespace goalnet
