// What a planner answers.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "components/core/predicate.h"

namespace goalnet::planner {

struct Statistics {
  std::int64_t ground_actions = 0;  // actions the goal could need
  std::int64_t ground_facts = 0;    // facts tracked during the search
  std::int64_t evaluated = 0;       // states whose heuristic was computed
  std::int64_t expanded = 0;
  std::int64_t generated = 0;
  std::int64_t symmetries = 0;  // generators of the symmetry group used
  std::int64_t peak_bytes = 0;  // memory of the search's tables
  double grounding_seconds = 0;
  double search_seconds = 0;
  std::string method;  // "nothing to do", "one action", "relaxed plan", "A*", "greedy"
};

struct Plan {
  std::vector<Action> actions;
  std::int64_t cost = 0;         // number of actions, or total cost where the problem minimises it
  std::int64_t lower_bound = 0;  // no plan is cheaper than this; equals cost where optimal
  bool optimal = false;
  Statistics statistics;
};

}  // namespace goalnet::planner
