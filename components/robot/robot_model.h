// The robot as data: one urdfdom parse plus a YAML file that says what links and joints are for.
// Simulation, kinematics and execution all start from this one object.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <urdf_model/model.h>
#include <urdf_world/types.h>
#include <Eigen/Geometry>

#include "components/core/outcome.h"

namespace goalnet::robot {

// Limits of one actuated joint. Units: rad or m, and per second, per second squared, Nm or N.
struct JointLimits {
  double lower = 0;  // -infinity for continuous joints
  double upper = 0;  // +infinity for continuous joints
  double velocity = 0;
  double acceleration = 0;
  double effort = 0;
};

enum class JointKind { kRevolute, kContinuous, kPrismatic };

struct Joint {
  std::string name;
  JointKind kind = JointKind::kRevolute;
  JointLimits limits;
  double home = 0;
};

// The three virtual joints that carry the base over the floor.
struct Base {
  std::string x, y, yaw;  // joint names
  std::string link;       // moves with all three
};

struct Gripper {
  std::vector<std::string> fingers;  // prismatic joints; all move alike
  std::vector<std::string> links;    // the links that touch what is held, same order
  double open = 0, closed = 0;       // [m] joint positions
  double max_force = 0;              // [N] of each finger
  double pad_width = 0;              // [m] along x of the tool frame
  double tip = 0;                    // [m] from the tool frame to the finger tips along its z
};

struct Arm {
  std::string name;       // left, right
  std::string base_link;  // the link that joint 1 hangs from
  std::string tool_link;  // between the finger pads: z out of the hand, y the closing direction
  std::vector<std::string> joints;
  Gripper gripper;
};

struct TraySlot {
  Eigen::Vector3d position =
      Eigen::Vector3d::Zero();  // [m] centre on the surface, in the frame of the tray's link
  Eigen::Vector2d size = Eigen::Vector2d::Zero();  // [m] along x and y
};

struct Tray {
  std::string link;
  std::vector<TraySlot> slots;
};

// Immutable after load_robot; safe to read from several threads.
struct RobotModel {
  std::string name;
  std::string file;      // the YAML file, for messages
  std::string urdf_xml;  // as read: what /robot_description publishes
  urdf::ModelInterfaceSharedPtr urdf;
  std::vector<Joint> joints;  // all actuated joints, depth first in the order of the URDF's tree
  Base base;
  std::string lift;  // empty if the robot has none
  std::vector<Arm> arms;
  std::optional<Tray> tray;

  // Place of a joint in `joints`, -1 if there is none of that name.
  int index_of(const std::string& joint) const;
  const Arm* arm(const std::string& arm_name) const;
  // Home configuration in the order of `joints`.
  std::vector<double> home() const;
};

// Reads config/robots/<name>.yaml (a bare name) or the YAML file at a path, and the URDF that it names.
// Fails with kInvalidRequest and one message that says which file, which line or element, and what to do.
Expected<RobotModel> load_robot(const std::string& name_or_path);

// The same from memory; `directory` is where the YAML's urdf entry is looked up.
Expected<RobotModel> parse_robot(const std::string& yaml_text, const std::string& file_name,
                                 const std::string& directory);

}  // namespace goalnet::robot
