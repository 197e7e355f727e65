// What a household goal really asks for, before planning.
#pragma once

#include <vector>

#include "components/core/predicate.h"

namespace goalnet::planner {

// Demonstrations record where people stood on their way: "(Near Robot Sink)" beside "(On Mug_1 Sink)" is a
// means, not an end. Positive (Near Robot X) is dropped where the goal has any other positive predicate, and
// negative ones always. If only Near goals are left they are visited one after the other: one goal each, in
// the order given, because the robot cannot be near two places at once. (In X Fridge) is kept: the domain
// derives it from the compartments. Returns at least one goal; each is to be planned from where the previous
// one ends.
std::vector<Goal> normalise_household_goal(const Goal& goal);

}  // namespace goalnet::planner
