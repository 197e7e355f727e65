#include "components/setting/setting.h"

#include <utility>

namespace goalnet {

Expected<Setting> load_setting(const std::string& scene_name, const std::string& robot_name) {
  auto scene = scene::load_scene(scene_name);
  if (!scene) return tl::unexpected<Error>(std::move(scene.error()));
  auto robot = robot::load_robot(robot_name.empty() ? "default" : robot_name);
  if (!robot) return tl::unexpected<Error>(std::move(robot.error()));
  return Setting{std::move(*scene), std::move(*robot)};
}

}  // namespace goalnet
