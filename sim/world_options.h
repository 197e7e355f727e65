// Numbers that shape the physics. Defaults were measured on the kitchen (docs/design and sim/README.md).
#pragma once

#include <cstdint>

namespace goalnet::sim {

struct WorldOptions {
  std::uint64_t seed = 0;       // varies where objects stand; 0: exactly as the scene says
  double physics_step = 0.002;  // [s]
  int solver_iterations = 20;
  double servo_gain = 0.3;  // share of a joint's position error that its servo takes away per physics step
  double grip_stiffness = 4000;  // [N/m] of the finger servos
  double grasp_time = 0.02;      // [s] of two-sided contact until fingers hold
  double grasp_angle = 0.6;      // [rad] how far the two contact normals may be from opposing
  double grasp_least_force = 4;  // [N] that each finger must press with
  double overload_time = 0.03;   // [s] of too much force until a held object slips out
  double held_torque = 4.0;      // [N m] that pads of this size can hold
};

}  // namespace goalnet::sim
