// Where and how a two-finger gripper can take hold of something.
#pragma once

#include <string>

#include "components/scene/shape.h"

namespace goalnet::scene {

enum class GraspKind {
  // The fingers close around the frame's z axis, from opposite sides: cups, bottles, bars, door handles.
  // Approach: any direction perpendicular to z whose angle about z (the direction in which the hand comes
  // *from*,
  // 0 = from +x, counter-clockwise) lies in [angle_min, angle_max]; the fingers meet the thing anywhere at
  // z in [low, high].
  kAround,
  // A circular wall of radius `radius` about the frame's z, its top edge in the frame's xy plane; the hand
  // comes from
  // above (along -z, may lean outwards by up to `tilt_max`) and the fingers straddle the wall: closing
  // direction radial.
  // `depth` is how far finger tips may reach below the edge.
  kRim,
  // One direction: the hand comes along the frame's +x and closes along +-y; it may be shifted along z in
  // [low, high].
  kPinch,
};

struct Grasp {
  std::string name;  // unique within its owner: side, handle, rim_top, ...
  GraspKind kind = GraspKind::kAround;
  Pose frame = Pose::Identity();  // in the frame of the object or part
  double width = 0.0;             // [m] what the fingers close upon: diameter, bar or wall thickness
  double open_width = 0.0;        // [m] the widest opening that is free of obstacles on the way in
  double low = 0.0;               // [m]
  double high = 0.0;              // [m]
  double angle_min = 0.0;         // [rad]
  double angle_max = 0.0;         // [rad] >= angle_min; a full turn is angle_min + 2 pi
  double radius = 0.0;            // [m] kRim only
  double depth = 0.0;     // [m] finger tips beyond the grasp point: kRim, kPinch, kAround (past the axis)
  double tilt_max = 0.0;  // [rad] kRim: outwards; kAround: out of the plane perpendicular to z, either way
};

}  // namespace goalnet::scene
