// What a household goal really asks for, before planning.
#pragma once

#include <string>
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

// Why no plan reaches the goal, if some part of it does not fit into or onto another by its size: "X does not
// fit into Y"; empty if nothing of the kind is known.
std::string misfit(const Goal& goal, const FactSet& facts);

}  // namespace goalnet::planner
