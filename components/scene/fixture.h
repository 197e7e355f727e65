// Furniture and devices: things that stand where they stand, with parts that move on joints.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "components/scene/grasp.h"
#include "components/scene/shape.h"

namespace goalnet::scene {

enum class JointKind { kRevolute, kPrismatic };

// A one-axis joint of a fixture. Position 0: the part's frame coincides with `origin`.
struct Joint {
  std::string name;  // as in /joint_states
  JointKind kind = JointKind::kRevolute;
  Pose origin = Pose::Identity();                   // in the frame of the parent part (or fixture)
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  // unit vector in the frame of `origin`
  double lower = 0.0;                               // [rad or m]
  double upper = 0.0;                               // [rad or m]
  double friction = 0.0;                            // [N m or N] dry friction: the least that moves it
  double damping = 0.0;                             // [N m s/rad or N s/m]
  double return_force = 0.0;  // [N m or N] pushes back towards `rest` (buttons); 0: stays where it is left
  double rest = 0.0;          // [rad or m]
};

// What the hand does with a moving part.
enum class PartUse { kNone, kDoor, kKnob, kButton };

struct Part {
  std::string name;           // FridgeLeftDoor, SinkKnob, MicrowaveButton, ...
  std::string action_object;  // how plans call it: open Microwave moves MicrowaveDoor; else equal to name
  int parent = -1;  // index of a part of the same fixture that stands before it; -1: the fixture itself
  Joint joint;
  double mass = 1.0;  // [kg]
  double friction = 0.6;
  std::vector<Shape> shapes;  // in the part's frame
  PartUse use = PartUse::kNone;
  std::vector<Grasp> grasps;  // handle or knob, in the part's frame
  // Buttons: the finger tip presses here, along +x of this frame (in the part's frame).
  std::optional<Pose> push;
  // Joint positions [rad or m] that count as done: door open / closed, knob on / off, button pressed /
  // released.
  double on_position = 0.0;
  double off_position = 0.0;
};

// Frame: origin on the floor in the middle of the front face; +x points into the fixture, away from a robot
// that stands in front of it; +y to that robot's left; z up.
struct Fixture {
  std::string name;              // Sink, Stove, Fridge, Microwave, Counter_1, ...
  Pose pose = Pose::Identity();  // in the map frame
  double friction = 0.6;
  std::vector<Shape> shapes;  // immovable, in the fixture's frame
  std::vector<Part> parts;    // parents before children
};

}  // namespace goalnet::scene
