// How the planner goes on where one action, or a relaxed plan, is not the answer: optimal search below a
// growing bound, and satisficing searches in between.
#include <algorithm>

#include "components/planner/planner_impl.h"

namespace goalnet::planner {
namespace {

constexpr std::int64_t kFirstNodes = 2000;    // most household problems end before
constexpr std::int64_t kFirstWork = 600'000;  // nodes times actions: large tasks get fewer nodes, but some
constexpr std::int64_t kFewestNodes = 50;
constexpr std::int64_t kNodesWithPlan = 20;  // times as many where a plan is known already
constexpr std::size_t kLargeTask = 10'000;   // actions; here even the first lower bounds take seconds

// Where there is no plan yet, optimal search begins, then any plan is sought, and optimal search has the
// rest: what the one does not find in its part of the time it would hardly find in the other's.
constexpr int kFirstEighths = 1, kSatisficingEighths = 6, kAll = 8;
// With a plan, optimal search has a third of the time before the plan is made cheaper.
constexpr int kBeforeImproving = 3, kImproving = 4;
constexpr int kNoLimit = 1 << 20;  // turns of a satisficing search

}  // namespace

// One such search: a plan, how much of the time it took, and what is known of cheaper ones.
class Planner::Impl::Improvement {
 public:
  Improvement(Impl& impl, Plan& plan, bool& found, const SolveOptions& options, Budget& budget)
      : impl_(impl),
        plan_(plan),
        found_(found),
        options_(options),
        budget_(budget),
        found_at_(Budget::Clock::now()) {
    limits_.bytes = options.memory_limit;
  }

  void run() {
    if (found_) begin_with_plan();
    if (options_.satisficing) return only_satisfice();
    if (!found_ && impl_.task.actions.size() > kLargeTask && !first_plan_of_large_task()) return;
    // Plans up to a little above the lower bound first: the fewer actions fit under the bound, the faster the
    // search. The bound grows until a plan is found or nothing was left out.
    const std::int64_t unit = impl_.dearest_action();
    for (std::int64_t round = 0; !budget_.check(); ++round) {
      const std::int64_t slack = round < 3 ? 1 : std::int64_t{1} << std::min<std::int64_t>(round - 2, 30);
      if (!search_below(std::min(limits_.upper_bound, plan_.lower_bound + slack * unit))) break;
    }
    if (found_) plan_.lower_bound = std::min(plan_.lower_bound, plan_.cost);
    plan_.optimal = found_ && plan_.lower_bound == plan_.cost;
  }

 private:
  using Satisficed = SatisficingSearch::Result;
  using Searched = OptimalSearch::Result;

  void begin_with_plan() {
    shorten_plan(impl_.task, impl_.initial.data(), budget_, &impl_.best);
    limits_.upper_bound = plan_.cost = impl_.cost_of(impl_.best);
    impl_.tell(plan_, options_);
  }

  void only_satisfice() {
    impl_.exhausted = satisfice(kNoLimit, budget_) == Satisficed::kExhausted && !found_;
    plan_.optimal = found_ && plan_.cost == plan_.lower_bound;
  }

  // False when there is no plan.
  bool first_plan_of_large_task() {
    tried_ = true;
    Budget part = share(kSatisficingEighths);
    impl_.exhausted = satisfice(first_turns(), part) == Satisficed::kExhausted && !found_;
    return !impl_.exhausted;
  }

  int first_turns() const { return budget_.limited() ? kNoLimit : 2; }

  // A part of the time that is left, in eighths; with a plan, of what the proof limit leaves.
  Budget share(int eighths) const {
    const bool proves = found_ && options_.proof_limit.count() > 0;
    auto left = budget_.limited() ? budget_.deadline() - Budget::Clock::now() : std::chrono::nanoseconds(0);
    if (proves) {
      const auto proof =
          std::max(options_.proof_limit - (Budget::Clock::now() - found_at_), std::chrono::nanoseconds(1));
      left = budget_.limited() ? std::min<std::chrono::nanoseconds>(left, proof) : proof;
    }
    const bool limited = budget_.limited() || proves;
    return Budget(options_.stop, limited ? std::max(left * eighths / 8, std::chrono::nanoseconds(1)) : left);
  }

  SatisficingOptions satisficing_options() const {
    SatisficingOptions some;
    some.upper_bound = limits_.upper_bound;
    some.bytes = options_.memory_limit / 4;
    return some;
  }

  void take_satisficing_plan() {
    impl_.best = impl_.satisficing.plan();
    plan_.cost = limits_.upper_bound = impl_.satisficing.cost();
    plan_.statistics.method = impl_.satisficing.method();
  }

  // Seeks a plan, or one cheaper than the known one.
  Satisficed satisfice(int turns, Budget& time) {
    if (!found_ && !exclusion_tried_) {  // what no search would find quickly
      exclusion_tried_ = true;
      if (!impl_.exclusive_goals_message(time).empty()) return Satisficed::kExhausted;
    }
    SatisficingOptions some = satisficing_options();
    some.turns = turns;
    some.best_of_turn = !options_.satisficing;
    const auto result = impl_.satisficing.search(impl_.relaxed, impl_.relaxed_planner, impl_.initial.data(),
                                                 some, time, plan_.statistics);
    if (result != Satisficed::kFound) return result;
    take_satisficing_plan();
    if (!found_) found_at_ = Budget::Clock::now();
    found_ = true;
    impl_.tell(plan_, options_);
    return result;
  }

  void make_cheaper(Budget& time) {
    const auto result = impl_.satisficing.improve(impl_.relaxed, impl_.relaxed_planner, impl_.initial.data(),
                                                  satisficing_options(), time, plan_.statistics, [&] {
                                                    take_satisficing_plan();
                                                    impl_.tell(plan_, options_);
                                                  });
    if (result == Satisficed::kExhausted) plan_.lower_bound = plan_.cost;
  }

  // One round of optimal search. False when nothing is left to do.
  bool search_below(std::int64_t bound) {
    const Focus focus = impl_.focus_on(bound, plan_, budget_);
    if (budget_.stopped()) return false;
    if (focus == Focus::kNone) {  // nothing below the bound
      plan_.lower_bound = bound;
      return bound != limits_.upper_bound;
    }
    SearchLimits here = limits_;
    here.upper_bound = bound;
    impl_.optimal.start(impl_.focused, impl_.focused_lm_cut, impl_.focused_initial.data(), plan_.lower_bound,
                        budget_);
    if (budget_.stopped()) return false;
    Searched result = tried_ ? Searched::kNodeLimit : first_nodes(here);
    if (impl_.exhausted) return false;
    if (result == Searched::kNodeLimit) result = all_nodes(here);
    if (proved_) return false;
    plan_.lower_bound = std::max(plan_.lower_bound, std::min(impl_.optimal.lower_bound(), bound));
    return goes_on(result, here, focus);
  }

  // A few nodes end most searches; where they do not, any plan is sought before the rest of them.
  Searched first_nodes(SearchLimits& here) {
    const auto actions = std::max<std::int64_t>(static_cast<std::int64_t>(impl_.focused.actions.size()), 1);
    here.nodes = std::clamp(kFirstWork / actions, kFewestNodes, kFirstNodes) * (found_ ? kNodesWithPlan : 1);
    if (options_.node_limit > 0) here.nodes = std::min(options_.node_limit, here.nodes);
    Budget part = share(found_ ? kBeforeImproving : kFirstEighths);
    const Searched result = impl_.optimal.resume(here, part, plan_.statistics);
    const bool unfinished =
        result == Searched::kNodeLimit || (result == Searched::kStopped && !budget_.check());
    if (!unfinished) return result;
    tried_ = true;
    Budget some = share(found_ ? kImproving : kSatisficingEighths);
    impl_.exhausted = satisfice(found_ ? 1 : first_turns(), some) == Satisficed::kExhausted && !found_;
    here.upper_bound = std::min(here.upper_bound, limits_.upper_bound);
    return Searched::kNodeLimit;
  }

  Searched all_nodes(SearchLimits& here) {
    here.nodes = options_.node_limit;
    Budget part = share(found_ ? kBeforeImproving : kAll);
    const Searched result = impl_.optimal.resume(here, part, plan_.statistics);
    if (result != Searched::kStopped || !found_ || budget_.check()) return result;
    Budget some = share(kImproving);
    make_cheaper(some);
    proved_ = plan_.lower_bound >= plan_.cost;
    if (proved_) return result;
    here.upper_bound = std::min(here.upper_bound, limits_.upper_bound);
    Budget rest = share(kAll);
    return impl_.optimal.resume(here, rest, plan_.statistics);
  }

  // What a round's end means for the plan; whether another one is to follow.
  bool goes_on(Searched result, const SearchLimits& here, Focus focus) {
    if (result == Searched::kFound) {
      take_optimal_plan();
      return false;
    }
    if (result == Searched::kExhausted) {
      plan_.lower_bound = std::max(plan_.lower_bound, here.upper_bound);
      if (here.upper_bound == limits_.upper_bound && found_) return false;
      impl_.exhausted = focus == Focus::kAll && !impl_.optimal.bound_used();
      return !impl_.exhausted;
    }
    if (!found_ && !budget_.check()) impl_.exhausted = satisfice(kNoLimit, budget_) == Satisficed::kExhausted;
    return false;
  }

  void take_optimal_plan() {
    impl_.best.clear();
    for (const std::int32_t action : impl_.optimal.plan())
      impl_.best.push_back(impl_.filter.original()[static_cast<std::size_t>(action)]);
    plan_.cost = plan_.lower_bound = impl_.cost_of(impl_.best);
    plan_.statistics.method = "A*";
    found_ = true;
  }

  Impl& impl_;
  Plan& plan_;
  bool& found_;
  const SolveOptions& options_;
  Budget& budget_;
  SearchLimits limits_;
  Budget::Clock::time_point found_at_;
  bool exclusion_tried_ = false;
  bool tried_ = false;   // optimal search had its first nodes, or the task is too large for them
  bool proved_ = false;  // making the plan cheaper showed that none is
};

// Optimal search, with satisficing ones in between where they give a first or a better plan sooner.
void Planner::Impl::improve(Plan& plan, bool& found, const SolveOptions& options, Budget& budget) {
  Improvement(*this, plan, found, options, budget).run();
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
