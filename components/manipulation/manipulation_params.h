// Tunables of manipulation. Defaults suit the default robot; the node offers the ones that matter as
// parameters.
#pragma once

namespace goalnet::manipulation {

struct ManipulationParams {
  double margin = 0.012;            // [m] distance kept from obstacles in free motion
  double contact_margin = 0.003;    // [m] the same on the last centimetres of a straight approach
  double drive_margin = 0.03;       // [m] distance kept while driving
  double approach_distance = 0.09;  // [m] straight way of the hand before and after touching something
  double lift_height = 0.07;        // [m] straight up after grasping
  double speed = 0.95;              // 0..1 of the joints' velocity limits
  double acceleration = 0.85;       // 0..1 of their acceleration limits; the rest absorbs rounding
  double upright_tilt = 0.35;       // [rad] how far a vessel with something in it may lean while it is moved
  double loose_tilt = 0.9;          // [rad] the same for other things
  int attempts = 4;                 // different ways tried before an action fails
  double settle_time = 0.15;        // [s] after a motion before its result is looked at
};

}  // namespace goalnet::manipulation
