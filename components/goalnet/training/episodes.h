// Demonstrations as training sequences: a state, the goal a person pursued from it, and so on until nothing
// is left.
#pragma once

#include <string>
#include <vector>

#include "components/core/predicate.h"
#include "components/goalnet/demonstration.h"
#include "components/goalnet/goal_model.h"
#include "components/goalnet/lexicon.h"

namespace goalnet::inference::training {

// states, goals and pursued are equally long. goals[t] is what to learn at states[t] (the last one is empty:
// stop); pursued[t] is what was done there, leading to states[t + 1] (differs from goals[t] where the model's
// own choice was followed).
struct Episode {
  std::string id, scenario, sentence;
  Grounding grounding;
  std::vector<WorldState> states;
  std::vector<Goal> goals, pursued;
};

// Of what one action changed, what it was done for: added facts, and only without any of them removed ones.
Goal intention(const Goal& step);

// The fewest goals that give the same actions: a stretch of actions that is the natural way to its last one
// becomes the intention of that last action. With `compress` off every action keeps its own added and removed
// facts.
// `things` completes each state's objects: demonstrations list only what their facts mention.
Episode make_episode(const Demonstration& demonstration, const Lexicon& things, bool compress);

}  // namespace goalnet::inference::training
