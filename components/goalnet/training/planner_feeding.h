// State feeding with a real planner: the state after a goal is the state after a plan for it, under the
// benchmark's rules. What took the paper's training thirteen times as long costs microseconds here
// (sym_sim.h, goal_planner.h).
#pragma once

#include "components/goalnet/training/state_feeding.h"

namespace goalnet::inference::training {

// Plans with GoalPlanner and runs the plan in SymSim's rules. Keeps a table of names: one simulator per
// thread.
Simulator planner_simulator();

}  // namespace goalnet::inference::training
