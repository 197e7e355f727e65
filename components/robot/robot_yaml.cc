// Reads the robot's YAML file. Every message names the file and the line.
#include <cmath>
#include <filesystem>
#include <limits>
#include <set>
#include <sstream>

#include <yaml-cpp/yaml.h>

#include "components/core/read_file.h"
#include "components/robot/joint_order.h"
#include "components/robot/robot_model.h"

namespace goalnet::robot {
namespace {

// Thrown and caught in this file only: yaml-cpp throws anyway, and one catch keeps the reading readable.
struct Problem {
  int line;
  std::string what;
};

int line_of(const YAML::Node& node) { return node.Mark().line >= 0 ? node.Mark().line + 1 : 1; }

YAML::Node need(const YAML::Node& map, const std::string& key) {
  if (!map.IsMap()) throw Problem{line_of(map), "expected a map with '" + key + "' in it"};
  YAML::Node value = map[key];
  if (!value || value.IsNull()) throw Problem{line_of(map), "'" + key + "' is missing"};
  return value;
}

std::string text(const YAML::Node& map, const std::string& key) {
  const auto node = need(map, key);
  if (!node.IsScalar()) throw Problem{line_of(node), "'" + key + "' must be a word"};
  return node.Scalar();
}

double number(const YAML::Node& node, const std::string& what) {
  double value = 0;
  if (!node.IsScalar() || !YAML::convert<double>::decode(node, value) || !std::isfinite(value)) {
    throw Problem{line_of(node), "'" + what + "' must be a finite number"};
  }
  return value;
}

double number(const YAML::Node& map, const std::string& key, double lowest, double highest) {
  const auto node = need(map, key);
  const double value = number(node, key);
  if (value < lowest || value > highest) {
    std::ostringstream out;
    out << "'" << key << "' is " << value << ", outside " << lowest << " .. " << highest;
    throw Problem{line_of(node), out.str()};
  }
  return value;
}

YAML::Node sequence(const YAML::Node& map, const std::string& key, std::size_t least, std::size_t most) {
  const auto node = need(map, key);
  if (!node.IsSequence() || node.size() < least || node.size() > most) {
    throw Problem{line_of(node), "'" + key + "' must be a list of " + std::to_string(least) +
                                     (most == least ? "" : " to " + std::to_string(most)) + " entries"};
  }
  return node;
}

// Reads names of joints and links, checking that the URDF has them and that no joint has two purposes.
class Reader {
 public:
  Reader(const YAML::Node& root, RobotModel& model) : root_(root), model_(model) {}

  void read() {
    read_joints();
    read_base();
    if (root_["lift"]) model_.lift = claim(root_, "lift", root_["lift"]);
    read_arms();
    read_tray();
    read_home();
  }

 private:
  void read_joints() {
    const auto accelerations = need(root_, "accelerations");
    for (const auto& source : joints_depth_first(*model_.urdf)) {
      if (!is_actuated(*source)) continue;
      Joint joint;
      joint.name = source->name;
      const bool continuous = source->type == urdf::Joint::CONTINUOUS;
      joint.kind = continuous                               ? JointKind::kContinuous
                   : source->type == urdf::Joint::PRISMATIC ? JointKind::kPrismatic
                                                            : JointKind::kRevolute;
      const double inf = std::numeric_limits<double>::infinity();
      joint.limits.lower = continuous ? -inf : source->limits->lower;
      joint.limits.upper = continuous ? inf : source->limits->upper;
      joint.limits.velocity = source->limits->velocity;
      joint.limits.effort = source->limits->effort;
      joint.limits.acceleration = number(accelerations, joint.name, 1e-3, 1e3);
      model_.joints.push_back(joint);
    }
    known_joints(accelerations);
  }

  void read_base() {
    const auto base = need(root_, "base");
    model_.base = {claim(base, "x", need(base, "x")), claim(base, "y", need(base, "y")),
                   claim(base, "yaw", need(base, "yaw")), link(need(base, "link"))};
  }

  void read_arms() {
    const auto arms = need(root_, "arms");
    if (!arms.IsMap() || arms.size() < 1) throw Problem{line_of(arms), "'arms' needs at least one arm"};
    for (const auto& entry : arms) {
      const auto& node = entry.second;
      Arm arm;
      arm.name = entry.first.Scalar();
      arm.base_link = link(need(node, "base_link"));
      arm.tool_link = link(need(node, "tool_link"));
      for (const auto& name : sequence(node, "joints", 6, 8))
        arm.joints.push_back(claim(node, "joints", name));
      const auto gripper = need(node, "gripper");
      for (const auto& name : sequence(gripper, "fingers", 1, 4)) {
        arm.gripper.fingers.push_back(claim(gripper, "fingers", name));
      }
      const auto fingers = arm.gripper.fingers.size();
      for (const auto& name : sequence(gripper, "links", fingers, fingers))
        arm.gripper.links.push_back(link(name));
      arm.gripper.open = number(gripper, "open", -1.0, 1.0);
      arm.gripper.closed = number(gripper, "closed", -1.0, 1.0);
      arm.gripper.max_force = number(gripper, "max_force", 0.1, 1e4);
      arm.gripper.pad_width = number(gripper, "pad_width", 1e-3, 0.5);
      arm.gripper.tip = number(gripper, "tip", 0.0, 0.5);
      check_chain(node, arm);
      model_.arms.push_back(arm);
    }
  }

  void check_chain(const YAML::Node& node, const Arm& arm) {
    std::vector<std::string> chain;
    auto current = model_.urdf->getLink(arm.tool_link);
    while (current && current->name != arm.base_link && current->parent_joint) {
      if (is_actuated(*current->parent_joint)) chain.insert(chain.begin(), current->parent_joint->name);
      current = current->getParent();
    }
    if (!current || current->name != arm.base_link || chain != arm.joints) {
      throw Problem{line_of(node), "the joints of arm '" + arm.name + "' must be exactly those between '" +
                                       arm.base_link + "' and '" + arm.tool_link + "', in that order"};
    }
  }

  void read_tray() {
    const auto node = root_["tray"];
    if (!node || node.IsNull()) return;
    Tray tray;
    tray.link = link(need(node, "link"));
    for (const auto& slot : sequence(node, "slots", 1, 16)) {
      const auto p = sequence(slot, "position", 3, 3);
      const auto s = sequence(slot, "size", 2, 2);
      tray.slots.push_back({{number(p[0], "position"), number(p[1], "position"), number(p[2], "position")},
                            {number(s[0], "size"), number(s[1], "size")}});
    }
    model_.tray = tray;
  }

  void read_home() {
    const auto node = need(root_, "home");
    for (auto& joint : model_.joints) {
      const double low = std::isfinite(joint.limits.lower) ? joint.limits.lower : -1e3;
      const double high = std::isfinite(joint.limits.upper) ? joint.limits.upper : 1e3;
      joint.home = number(node, joint.name, low, high);
    }
    known_joints(node);
  }

  void known_joints(const YAML::Node& map) {
    for (const auto& entry : map) {
      if (model_.index_of(entry.first.Scalar()) < 0) {
        throw Problem{line_of(entry.first), "the URDF has no actuated joint '" + entry.first.Scalar() + "'"};
      }
    }
  }

  std::string claim(const YAML::Node&, const std::string& purpose, const YAML::Node& node) {
    if (!node.IsScalar() || model_.index_of(node.Scalar()) < 0) {
      throw Problem{line_of(node), "'" + purpose + "' must name an actuated joint of the URDF" +
                                       (node.IsScalar() ? ", not '" + node.Scalar() + "'" : "")};
    }
    if (!claimed_.insert(node.Scalar()).second) {
      throw Problem{line_of(node), "joint '" + node.Scalar() + "' is used twice"};
    }
    return node.Scalar();
  }

  std::string link(const YAML::Node& node) {
    if (!node.IsScalar() || !model_.urdf->getLink(node.Scalar())) {
      throw Problem{line_of(node), std::string("the URDF has no link '") +
                                       (node.IsScalar() ? node.Scalar() : std::string("?")) + "'"};
    }
    return node.Scalar();
  }

  const YAML::Node& root_;
  RobotModel& model_;
  std::set<std::string> claimed_;
};

}  // namespace

Expected<RobotModel> parse_robot(const std::string& yaml_text, const std::string& file_name,
                                 const std::string& directory) {
  const auto bad = [&](int line, const std::string& what) {
    return fail(Outcome::kInvalidRequest, file_name + ":" + std::to_string(line) + ": " + what);
  };
  if (yaml_text.size() > (1u << 20)) return bad(1, "larger than 1 MB; this is no description of a robot");
  RobotModel model;
  model.file = file_name;
  try {
    const YAML::Node root = YAML::Load(yaml_text);
    if (!root.IsMap()) return bad(1, "expected a map with name, urdf, base, arms, accelerations and home");
    model.name = text(root, "name");
    const auto urdf_path = std::filesystem::path(directory) / text(root, "urdf");
    auto xml = read_file(urdf_path, 4 << 20);
    if (!xml) return bad(line_of(root["urdf"]), "the URDF " + xml.error().message);
    model.urdf_xml = std::move(*xml);
    auto parsed = parse_urdf(model.urdf_xml, urdf_path.string());
    if (!parsed) return tl::unexpected<Error>(parsed.error());
    model.urdf = *parsed;
    Reader(root, model).read();
  } catch (const Problem& problem) {
    return bad(problem.line, problem.what);
  } catch (const YAML::Exception& e) {
    return bad(e.mark.line >= 0 ? e.mark.line + 1 : 1, std::string("malformed YAML: ") + e.msg);
  } catch (const std::exception& e) {
    return bad(1, e.what());
  }
  return model;
}

}  // namespace goalnet::robot
