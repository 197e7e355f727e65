#include "components/robot/robot_model.h"

#include <filesystem>

#include "components/core/config_path.h"
#include "components/core/read_file.h"

namespace goalnet::robot {
namespace {

// A bare name is a file in config/robots.
std::filesystem::path resolve(const std::string& name_or_path) {
  if (name_or_path.find('/') != std::string::npos || name_or_path.ends_with(".yaml")) return name_or_path;
  return config_path("robots/" + name_or_path + ".yaml");
}

}  // namespace

int RobotModel::index_of(const std::string& joint) const {
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (joints[i].name == joint) return static_cast<int>(i);
  }
  return -1;
}

const Arm* RobotModel::arm(const std::string& arm_name) const {
  for (const auto& a : arms) {
    if (a.name == arm_name) return &a;
  }
  return nullptr;
}

std::vector<double> RobotModel::home() const {
  std::vector<double> q;
  q.reserve(joints.size());
  for (const auto& joint : joints) q.push_back(joint.home);
  return q;
}

Expected<RobotModel> load_robot(const std::string& name_or_path) {
  const auto path = resolve(name_or_path);
  const auto text = read_file(path, 1 << 20);
  if (!text) {
    return fail(Outcome::kInvalidRequest, "robot '" + name_or_path + "': " + text.error().message +
                                              "; give a name from config/robots or the path of a YAML file");
  }
  return parse_robot(*text, path.string(), path.parent_path().string());
}

}  // namespace goalnet::robot
