// How the planner goes on where one action, or a relaxed plan, is not the answer: optimal search below a
// growing bound, and satisficing searches in between.
#include <algorithm>

#include "components/planner/planner_impl.h"

namespace goalnet::planner {

// Optimal search, with satisficing ones in between where they give a first or a better plan sooner.
void Planner::Impl::improve(Plan& plan, bool& found, const SolveOptions& options, Budget& budget) {
  constexpr std::int64_t kFirstNodes = 2000;    // most household problems end before
  constexpr std::int64_t kFirstWork = 600'000;  // nodes times actions: large tasks get fewer nodes, but some
  constexpr std::int64_t kFewestNodes = 50;
  constexpr std::int64_t kNodesWithPlan = 20;  // times as many where a plan is known already
  constexpr std::size_t kLargeTask = 10'000;   // actions
  auto found_at = Budget::Clock::now();
  SearchLimits limits;
  limits.bytes = options.memory_limit;
  bool exclusion_tried = false;
  if (found) {
    shorten_plan(task, initial.data(), budget, &best);
    limits.upper_bound = plan.cost = cost_of(best);
    tell(plan, options);
  }
  const auto satisfice = [&](int turns, Budget& time) {
    if (!found && !exclusion_tried) {  // what no search would find quickly
      exclusion_tried = true;
      if (!exclusive_goals_message(time).empty()) return SatisficingSearch::Result::kExhausted;
    }
    SatisficingOptions some;
    some.upper_bound = limits.upper_bound;
    some.bytes = options.memory_limit / 4;
    some.turns = turns;
    some.best_of_turn = !options.satisficing;
    const auto result =
        satisficing.search(relaxed, relaxed_planner, initial.data(), some, time, plan.statistics);
    if (result == SatisficingSearch::Result::kFound) {
      best = satisficing.plan();
      plan.cost = limits.upper_bound = satisficing.cost();
      plan.statistics.method = satisficing.method();
      if (!found) found_at = Budget::Clock::now();
      found = true;
      tell(plan, options);
    }
    return result;
  };
  const auto make_cheaper = [&](Budget& time) {
    SatisficingOptions some;
    some.upper_bound = limits.upper_bound;
    some.bytes = options.memory_limit / 4;
    const auto result =
        satisficing.improve(relaxed, relaxed_planner, initial.data(), some, time, plan.statistics, [&] {
          best = satisficing.plan();
          plan.cost = limits.upper_bound = satisficing.cost();
          plan.statistics.method = satisficing.method();
          tell(plan, options);
        });
    if (result == SatisficingSearch::Result::kExhausted) plan.lower_bound = plan.cost;
  };
  // A part of the time that is left, in eighths; with a plan, of what the proof limit leaves.
  const auto share = [&](int eighths) {
    auto left = budget.limited() ? budget.deadline() - Budget::Clock::now() : std::chrono::nanoseconds(0);
    if (found && options.proof_limit.count() > 0) {
      const auto proof =
          std::max(options.proof_limit - (Budget::Clock::now() - found_at), std::chrono::nanoseconds(1));
      left = budget.limited() ? std::min<std::chrono::nanoseconds>(left, proof) : proof;
    }
    const bool limited = budget.limited() || (found && options.proof_limit.count() > 0);
    return Budget(options.stop, limited ? std::max(left * eighths / 8, std::chrono::nanoseconds(1)) : left);
  };
  // Where there is no plan yet, optimal search begins, then any plan is sought, and optimal search has the
  // rest: what the one does not find in its part of the time it would hardly find in the other's.
  constexpr int kFirstEighths = 1, kSatisficingEighths = 6, kAll = 8;
  // With a plan, optimal search has a third of the time before the plan is made cheaper.
  constexpr int kBeforeImproving = 3, kImproving = 4;
  constexpr int kNoLimit = 1 << 20;
  const int first_turns = budget.limited() ? kNoLimit : 2;
  if (options.satisficing) {
    exhausted = satisfice(kNoLimit, budget) == SatisficingSearch::Result::kExhausted && !found;
    plan.optimal = found && plan.cost == plan.lower_bound;
    return;
  }
  bool tried = false;
  if (!found && task.actions.size() > kLargeTask) {  // here even the first lower bounds take seconds
    tried = true;
    Budget part = share(kSatisficingEighths);
    if (satisfice(first_turns, part) == SatisficingSearch::Result::kExhausted && !found) {
      exhausted = true;
      return;
    }
  }
  // Plans up to a little above the lower bound first: the fewer actions fit under the bound, the faster the
  // search. The bound grows until a plan is found or nothing was left out.
  const std::int64_t unit = dearest_action();
  for (std::int64_t round = 0; !budget.check(); ++round) {
    const std::int64_t slack = round < 3 ? 1 : std::int64_t{1} << std::min<std::int64_t>(round - 2, 30);
    const std::int64_t bound = std::min(limits.upper_bound, plan.lower_bound + slack * unit);
    const Focus focus = focus_on(bound, plan, budget);
    if (budget.stopped()) break;
    if (focus == Focus::kNone) {  // nothing below the bound
      plan.lower_bound = bound;
      if (bound == limits.upper_bound) break;
      continue;
    }
    SearchLimits here = limits;
    here.upper_bound = bound;
    optimal.start(focused, focused_lm_cut, focused_initial.data(), plan.lower_bound, budget);
    if (budget.stopped()) break;
    auto result = OptimalSearch::Result::kNodeLimit;
    if (!tried) {
      const auto actions = std::max<std::int64_t>(static_cast<std::int64_t>(focused.actions.size()), 1);
      here.nodes = std::clamp(kFirstWork / actions, kFewestNodes, kFirstNodes) * (found ? kNodesWithPlan : 1);
      if (options.node_limit > 0) here.nodes = std::min(options.node_limit, here.nodes);
      Budget part = share(found ? kBeforeImproving : kFirstEighths);
      result = optimal.resume(here, part, plan.statistics);
      if (result == OptimalSearch::Result::kNodeLimit ||
          (result == OptimalSearch::Result::kStopped && !budget.check())) {
        tried = true;
        Budget some = share(found ? kImproving : kSatisficingEighths);
        if (satisfice(found ? 1 : first_turns, some) == SatisficingSearch::Result::kExhausted && !found) {
          exhausted = true;
          break;
        }
        here.upper_bound = std::min(here.upper_bound, limits.upper_bound);
        result = OptimalSearch::Result::kNodeLimit;
      }
    }
    if (result == OptimalSearch::Result::kNodeLimit) {
      here.nodes = options.node_limit;
      Budget part = share(found ? kBeforeImproving : kAll);
      result = optimal.resume(here, part, plan.statistics);
      if (result == OptimalSearch::Result::kStopped && found && !budget.check()) {
        Budget some = share(kImproving);
        make_cheaper(some);
        if (plan.lower_bound >= plan.cost) break;
        here.upper_bound = std::min(here.upper_bound, limits.upper_bound);
        Budget rest = share(kAll);
        result = optimal.resume(here, rest, plan.statistics);
      }
    }
    plan.lower_bound = std::max(plan.lower_bound, std::min(optimal.lower_bound(), bound));
    if (result == OptimalSearch::Result::kFound) {
      best.clear();
      for (const std::int32_t action : optimal.plan()) {
        best.push_back(filter.original()[static_cast<std::size_t>(action)]);
      }
      plan.cost = plan.lower_bound = cost_of(best);
      plan.statistics.method = "A*";
      found = true;
      break;
    }
    if (result == OptimalSearch::Result::kExhausted) {
      plan.lower_bound = std::max(plan.lower_bound, here.upper_bound);
      if (here.upper_bound == limits.upper_bound && found) break;
      if (focus == Focus::kAll && !optimal.bound_used()) {
        exhausted = true;
        break;
      }
      continue;
    }
    if (!found && !budget.check())
      exhausted = satisfice(kNoLimit, budget) == SatisficingSearch::Result::kExhausted;
    break;
  }
  if (found) plan.lower_bound = std::min(plan.lower_bound, plan.cost);
  plan.optimal = found && plan.lower_bound == plan.cost;
}

std::int64_t Planner::Impl::dearest_action() const {
  std::int64_t dearest = 1;
  for (const GroundAction& action : task.actions) dearest = std::max(dearest, action.cost);
  return dearest;
}

// Filters the task for plans below `bound`, again as long as that raises the estimate. Raises
// plan.lower_bound.
Planner::Impl::Focus Planner::Impl::focus_on(std::int64_t bound, Plan& plan, Budget& budget) {
  std::int64_t estimate = first_estimate;
  std::int64_t left_out = 0;
  if (task.axioms.empty()) {
    left_out = filter.filter(task, relaxed, lm_cut, estimate, bound, focused, budget);
  } else {
    filter.copy(task, focused);
  }
  if (budget.stopped()) return Focus::kAll;
  if (focused.goal_impossible) return Focus::kNone;
  focused_relaxed.build(focused, budget);
  if (budget.stopped()) return Focus::kAll;
  initial_state(focused, budget, &focused_initial);
  focused_lm_cut.restart(focused_relaxed, budget);
  if (budget.stopped()) return Focus::kAll;
  ++plan.statistics.evaluated;
  estimate = focused_lm_cut.evaluate(focused_initial.data(), budget);
  if (estimate >= bound && !budget.check()) return Focus::kNone;
  plan.lower_bound = std::max(plan.lower_bound, std::min(estimate, bound));
  return left_out == 0 ? Focus::kAll : Focus::kPart;
}

}  // namespace goalnet::planner
