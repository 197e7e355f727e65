// A robot's two files: text that begins with "<" is a URDF, other text the YAML beside the URDF of the
// default robot. Needs GOALNET_CONFIG_DIR or the working directory at the root of the project.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "components/core/config_path.h"
#include "components/robot/joint_order.h"
#include "components/robot/kinematics.h"
#include "components/robot/robot_model.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace goalnet;
  static const std::string folder = config_path("robots");
  const std::string text(reinterpret_cast<const char*>(data), size);
  if (text.starts_with("<")) {
    const auto urdf = robot::parse_urdf(text, "fuzz.urdf");
    if (!urdf) {
      if (!urdf.error().message.starts_with("fuzz.urdf")) std::abort();
    } else if (robot::joints_depth_first(**urdf).size() + 1 != (*urdf)->links_.size()) {
      std::abort();
    }
    return 0;
  }
  const auto model = robot::parse_robot(text, "fuzz.yaml", folder);
  if (!model) {
    if (model.error().message.empty()) std::abort();
    return 0;
  }
  const robot::Kinematics kinematics(*model);
  std::vector<robot::Pose> poses;
  kinematics.forward(model->home(), poses);
  for (const robot::Pose& pose : poses)
    if (!pose.matrix().allFinite()) std::abort();
  return 0;
}
