// When one hand holds what the other works on (a tub to scoop from, a bag to open): how to hold it out, where
// to stand so that both have room, and which way the other hand takes.
#pragma once

#include <functional>
#include <vector>

#include "components/manipulation/phases.h"
#include "components/manipulation/stand_search.h"

namespace goalnet::manipulation {

struct TwoHandSolution {
  ReachSolution work;          // of the working arm; `reach` is an index into `reaches`
  std::vector<Reach> reaches;  // as given for where the held thing will be
  std::size_t holder = 0;      // the arm that holds it out
  ArmPositions held_out{};     // [rad] its posture meanwhile
};

// The ways of the working arm for a pose that the held thing may have (map frame).
using WaysAt = std::function<std::vector<Reach>(const Pose& held)>;

// Where the robot stands first, then further back and turned away. kMotionFailed if nothing works,
// kCancelled.
Expected<TwoHandSolution> find_two_hands(Workbench& bench, std::size_t holder, const WaysAt& ways);

// Adds the way there: back off, go, hold out, approach; returns what the working arm does. Errors are
// find_two_hands's, introduced by `what`.
Expected<Reach> add_way_with_both(Phases& phases, Workbench& bench, std::size_t holder, const WaysAt& ways,
                                  const std::string& what);

}  // namespace goalnet::manipulation
