// The thresholds between geometry and facts. Every relation has two: a tighter one to begin and a looser one
// to end, so that noise at the border does not make a fact flicker.
#pragma once

#include <string>
#include <vector>

namespace goalnet::world_model {

struct Threshold {
  double enter;  // the relation begins when the quantity is at most this
  double exit;   // ... and ends when it exceeds this; exit >= enter
};

struct Params {
  // On, In. The gap between an object's lowest point and the surface below it [m]: objects rest within the
  // collision margins of the simulator (below 1 mm) or the noise of perception (about 1 cm).
  Threshold surface_gap{0.015, 0.030};
  // How far the middle of an object may lie outside the edge of a surface or container [m].
  Threshold edge{0.005, 0.020};
  // An object is put down, not thrown: below this speed relations may begin [m/s].
  double resting_speed = 0.05;

  // Near Robot X: horizontal distance from the base's origin [m], and the direction of X off the robot's
  // front [rad]. The default robot reaches 0.8 m from its shoulders, in front and to both sides; it stands
  // with its front (0.25 m before the origin) up to 0.7 m from furniture, where doors need the room.
  Threshold near_object{0.95, 1.05};  // to the middle of an object
  Threshold near_support{1.15,
                         1.25};  // to the edge of the small support (shelf, burner, basin) that it stands on
  Threshold near_fixture{0.95, 1.05};  // to the nearest point of a fixture
  Threshold near_bearing{1.40, 1.60};
  double small_support = 1.0;  // [m] a support with a longer side (a counter) is judged by the object itself

  // Held: how far the material between the fingers may fall short of each finger pad [m].
  Threshold finger_gap{0.005, 0.012};
  // It moves with the hand: largest shift against the hand between two observations [m].
  double grip_slip = 0.010;
  double grip_time = 0.08;  // [s] for which all this must last before the object counts as held

  // An object that is no longer perceived keeps its place for so long [s]; then nothing is claimed about it.
  double object_timeout = 2.0;

  // One-place facts taken from the properties of object models: those that occur in the demonstrations.
  std::vector<std::string> static_properties{"IsGraspable", "IsSqueezeable"};
};

// A condition with memory.
inline bool with_hysteresis(bool was, double quantity, const Threshold& threshold) {
  return quantity <= (was ? threshold.exit : threshold.enter);  // false for NaN
}

}  // namespace goalnet::world_model
