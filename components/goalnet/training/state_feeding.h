// Training on states that the model's own choices lead to: the paper's state feeding with SymSim, and with a
// planner.
#pragma once

#include <functional>
#include <random>

#include "components/goalnet/goal_model.h"
#include "components/goalnet/training/episodes.h"

namespace goalnet::inference::training {

// The state after a goal was reached. Returns false when it cannot be.
using Simulator = std::function<bool(const Goal& goal, WorldState& state)>;

// The paper's SymSim: writes the predicates into the state, with the few effects that keep it consistent (a
// thing is held, or lies in one place). No action, no precondition: low fidelity, and quick.
bool sym_sim(const Goal& goal, WorldState& state);

// Walks through an episode; at each step, with probability `p`, the model's goal is pursued instead of the
// person's. From then on states are simulated, and what to learn is the person's first goal that does not
// hold yet. Steps the simulator cannot follow keep to the person's goal. The result has at most `extra` more
// steps than the episode.
Episode feed_states(const Episode& episode, bool with_grounding, GoalModel& model, const Simulator& simulator,
                    double p, std::size_t extra, std::mt19937_64& random);

}  // namespace goalnet::inference::training
