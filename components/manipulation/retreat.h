// Out of where an arm works, and into the posture in which the base drives.
#pragma once

#include "components/manipulation/phases.h"

namespace goalnet::manipulation {

// All arms into the posture for driving. Where one finds no way into it, between boards or under a door, the
// robot first comes out: the base straight back or aside with the arm as it is, or the hand straight out.
void add_tuck(Phases& phases, const Workbench& bench);

// For lines by which a hand comes away: the things right beside it and what it holds may be brushed aside.
// For want of anything better.
Tolerances brushing(const Workbench& bench, std::size_t arm);

// Whether a hand that has taken hold of a thing in one of the ways to do so would get out with it again: up
// as the way says, and then out straight, by the base or by the arm. `along`: arm positions from
// reach.tool.front() on at `start`, as find_stand() gives them. For Search's accept.
bool gets_out(Workbench& bench, const std::string& object, const Configuration& start, const Reach& reach,
              const std::vector<ArmPositions>& along);

}  // namespace goalnet::manipulation
