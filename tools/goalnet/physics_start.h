// Brings a simulated room into the state in which a recorded demonstration begins.
#pragma once

#include <string>
#include <vector>

#include "components/core/predicate.h"
#include "components/scene/scene.h"
#include "sim/world.h"

namespace goalnet::tools {

// (On …) or (In …).
bool is_place(const Predicate& fact);

// The places and states among `facts` that the room has names for: (On …), (In …) and (state …).
FactSet known_facts(const FactSet& facts, const scene::Scene& scene);

enum class Contents { kAsTheyAre, kAsSaid };

// Puts things where `start` has them, opens and closes doors, turns knobs and sets states. What `start` says
// nothing of stays where it is, but for devices: those are as `start` says, or off; and so is what things
// hold and are with `Contents::kAsSaid`. Hands stay empty. Let physics come to rest afterwards, and compare:
// not everything that was recorded can be (a thing inside itself, three things in the place of one).
void arrange(sim::World& world, const FactSet& start, Contents contents = Contents::kAsTheyAre);

}  // namespace goalnet::tools
