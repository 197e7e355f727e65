// Random small planning problems with everything that ADL offers, and breadth-first search to solve them
// without any cleverness.
#pragma once

#include <cstdint>
#include <optional>
#include <random>
#include <string>

#include "components/planner/problem.h"

namespace goalnet::planner {

struct RandomText {
  std::string domain;
  std::string problem;
};

// The same seed gives the same text.
RandomText random_problem(std::uint64_t seed, bool with_costs);

// Replaces the goal by a few facts, true and false, of a state that `steps` random actions lead to: then
// there is a plan.
void set_reachable_goal(std::uint64_t seed, int steps, Problem& problem);

struct Reference {
  bool solvable = false;
  bool gave_up = false;   // too many states
  std::int64_t cost = 0;  // of a cheapest plan
};

// Uniform-cost search over the interpreter: shares nothing with the planner but the parser.
Reference breadth_first(const Problem& problem, std::size_t most_states);

}  // namespace goalnet::planner
