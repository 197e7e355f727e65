// Makes a mess of a simulated room: for finding out how well the robot copes with starts that nobody tidied.
#pragma once

#include <cstdint>

#include "sim/world.h"

namespace goalnet::tools {

// Some things are pushed and turned, some put on other furniture or on the floor, and some of the tall ones
// tipped over. Nothing overlaps, nothing lies where it could not have come to lie. The same seed gives the
// same mess. Let physics come to rest afterwards: round things roll.
void make_untidy(sim::World& world, std::uint64_t seed);

}  // namespace goalnet::tools
