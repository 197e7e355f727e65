// What a kind of movable thing is like: shape, mass, friction, how to grasp it, what it holds.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "components/scene/grasp.h"
#include "components/scene/shape.h"

namespace goalnet::scene {

// The hollow of a cup, bottle or bag.
struct Cavity {
  Pose mouth = Pose::Identity();  // centre of the opening in the object's frame; z points out of it
  double radius = 0.0;            // [m] of the opening
  double depth = 0.0;             // [m] from the opening to the bottom
  double pour_tilt = 1.2;         // [rad] angle between the mouth's z and up beyond which contents run out
  bool liquid = true;             // holds liquids (a bin or a bag does not)
  bool slot = false;              // a slit along the mouth's x: only what is aligned with it goes in

  bool shallow() const { return depth < 0.5 * radius; }  // carries (a plate) rather than contains (a cup)
};

// Frame: origin in the middle of the footprint on the resting plane (z = 0 is what touches the table), z up.
struct ObjectModel {
  std::string name;  // mug, plate, ...
  std::vector<std::string>
      properties;                 // as in the data: IsGraspable, IsPourable, IsSqueezeable, IsAddable, ...
  double mass = 0.0;              // [kg]
  double friction = 0.0;          // Coulomb coefficient; the product of both partners counts
  double rolling_friction = 0.0;  // [m] small, so that round things come to rest
  std::vector<Shape> shapes;
  std::optional<Eigen::Vector3d> center_of_mass;  // [m]; empty: that of the shapes at equal density
  std::optional<Cavity> cavity;
  std::vector<Grasp> grasps;  // best first
  double grip_force = 0.0;    // [N] enough to hold it and not to crush it

  bool has_property(const std::string& property) const;
  // Footprint radius about z and height above the resting plane [m], from the shapes.
  double footprint_radius() const;
  double height() const;
};

}  // namespace goalnet::scene
