// Named places where things can be: surfaces (On) and containers (In).
#pragma once

#include <string>
#include <vector>

#include "components/scene/shape.h"

namespace goalnet::scene {

// A flat rectangle that carries things. z = 0 of the frame is the surface, x and y span it, z up.
struct Support {
  Pose frame = Pose::Identity();  // centre, in the fixture's frame
  double size_x = 0.0;            // [m] full extents
  double size_y = 0.0;            // [m]
  double clearance = 0.0;         // [m] free height above the surface
  bool reserved = false;          // counts for the relation, but nothing should be put there (cutlery rest)
};

// A preferred place, such as "under the tap".
struct Spot {
  std::string name;
  Pose frame = Pose::Identity();  // on the surface, in the fixture's frame
  std::vector<std::string>
      prefer_for;  // model properties that should stand here (HoldsLiquid); empty: anything
};

enum class RegionRelation { kOn, kIn };

struct Region {
  std::string name;  // Sink, Counter_1, StoveFire_1, Microwave, FridgeLeft, ...
  RegionRelation relation = RegionRelation::kOn;
  std::string fixture;  // whose frame the supports use
  std::string within;   // larger place that it belongs to: FridgeLeft is within Fridge; may be empty
  std::string door;     // part that must be open to reach in; may be empty
  std::vector<Support> supports;  // at least one; best first
  std::vector<Spot> spots;
};

}  // namespace goalnet::scene
