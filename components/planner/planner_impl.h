// What a Planner is made of: the stages that a question passes through, and their memory.
// Internal to the planner.
#pragma once

#include <string>
#include <vector>

#include "components/planner/grounder.h"
#include "components/planner/normal_form.h"
#include "components/planner/one_action.h"
#include "components/planner/optimal_search.h"
#include "components/planner/planner.h"
#include "components/planner/satisficing_search.h"
#include "components/planner/task_filter.h"

namespace goalnet::planner {

struct Planner::Impl {
  Impl(const Domain& the_domain, const std::stop_token& stop)
      : domain(the_domain),
        compiled(the_domain, stop),
        prepared(!stop.stop_requested()),
        index(compiled),
        one_action(compiled),
        grounder(compiled),
        scratch(the_domain) {}

  Expected<Plan> solve(const Problem& problem, const SolveOptions& options);

  const Domain& domain;
  CompiledDomain compiled;
  bool prepared;
  ProblemIndex index;
  OneAction one_action;
  Grounder grounder;
  Arena goal_memory;
  GroundTask task;
  RelaxedTask relaxed;
  LmCut lm_cut;
  RelaxedPlanner relaxed_planner;
  std::int64_t first_estimate = 0;  // LM-cut of the initial state in the whole task
  TaskFilter filter;                // the task narrowed down to plans below a bound
  GroundTask focused;
  RelaxedTask focused_relaxed;
  LmCut focused_lm_cut;
  std::vector<Word> focused_initial;
  OptimalSearch optimal;
  SatisficingSearch satisficing;
  Problem scratch;  // for solve(WorldState, Goal)
  std::vector<GoalLiteral> literals;
  std::vector<Word> initial;
  std::vector<std::int32_t> best;  // actions of the best plan so far
  bool exhausted = false;          // the search proved that there is no (better) plan

 private:
  Action name_of(std::int32_t schema, const ObjectId* binding) const;
  std::int64_t cost_of(const std::vector<std::int32_t>& actions) const;
  Expected<Plan> stopped(const Budget& budget, const SolveOptions& options) const;
  void name_actions(Plan& plan) const;
  void tell(Plan plan, const SolveOptions& options) const;
  Expected<Plan> finish(Plan plan, bool found, Budget& budget, const SolveOptions& options);
  Expected<Plan> search(const Problem& problem, const SolveOptions& options, Budget& budget);
  std::string unreachable_message() const;
  std::string exclusive_goals_message(Budget& budget) const;
  std::string literal_text(Literal literal) const;
  // How much of the task a bound leaves: nothing (no plan below it), a part, all that is reachable.
  enum class Focus { kNone, kPart, kAll };
  Focus focus_on(std::int64_t bound, Plan& plan, Budget& budget);
  std::int64_t dearest_action() const;
  class Improvement;
  void improve(Plan& plan, bool& found, const SolveOptions& options, Budget& budget);
};

}  // namespace goalnet::planner
