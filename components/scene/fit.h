// Whether a thing can be in or on a place at all, by sizes alone: what no motion can change.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "components/scene/scene.h"

namespace goalnet::scene {

// [m] that a thing must have all around to go through a mouth, and above it to go under a board.
constexpr double kPlay = 0.004, kHeadroom = 0.03;

// Whether `thing`, upright, or end first if it is long (IsPlacable), goes through the mouth of a deep cavity.
// True for shallow ones and slots: what lies on a plate may reach beyond its rim, and a slot is another
// question.
bool goes_through(const ObjectModel& thing, const Cavity& cavity);

// Whether `thing` stands on any support of the region without touching what is above it.
bool goes_under(const ObjectModel& thing, const Region& region);

// Largest distance of any material from the z axis [m]: what must pass through a round mouth.
double girth(const ObjectModel& model);

// Pairs (thing, place) of a scene that do not fit, each where it is worth saying: things and the regions,
// bins and bags of the scene; besides, what is put in as a whole (ingredients, cutlery) and every vessel. A
// name such as Fridge, which stands for the compartments within it, is there if none of them does.
std::vector<std::pair<std::string, std::string>> unfit_pairs(const Scene& scene);

}  // namespace goalnet::scene
