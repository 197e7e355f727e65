// Where the robot could stand to do something, the soonest reached first.
#pragma once

#include <vector>

#include "components/manipulation/stand_search.h"

namespace goalnet::manipulation {

struct StandCandidate {
  Stand stand;
  double cost = 0;  // [s] of getting there, and for how uncomfortable it is
  bool drives = true;
  bool in_the_way = false;  // found out that something is
};

// The present stand at several heights first, then, if the robot may drive, places around what is to be
// reached, within the floor; nothing is asked about collisions.
std::vector<StandCandidate> stand_candidates(const Workbench& bench, const std::vector<Reach>& reaches,
                                             const StandSearchOptions& options);

}  // namespace goalnet::manipulation
