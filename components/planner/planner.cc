#include "components/planner/planner.h"

#include <algorithm>

#include "components/planner/goal_mutex.h"
#include "components/planner/grounder.h"
#include "components/planner/normal_form.h"
#include "components/planner/one_action.h"
#include "components/planner/optimal_search.h"
#include "components/planner/pair_reachability.h"
#include "components/planner/satisficing_search.h"
#include "components/planner/task_filter.h"
#include "components/planner/world.h"

namespace goalnet::planner {
namespace {

using Clock = Budget::Clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

struct Planner::Impl {
  explicit Impl(const Domain& the_domain)
      : domain(the_domain), compiled(the_domain), index(compiled), one_action(compiled), grounder(compiled),
        scratch(the_domain) {}

  Expected<Plan> solve(const Problem& problem, const SolveOptions& options);

  const Domain& domain;
  CompiledDomain compiled;
  ProblemIndex index;
  OneAction one_action;
  Grounder grounder;
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
  Expected<Plan> finish(Plan plan, bool found, Budget& budget, const SolveOptions& options);
  Expected<Plan> search(const Problem& problem, const SolveOptions& options, Budget& budget);
  std::string unreachable_message() const;
  std::string exclusive_goals_message(Budget& budget) const;
  std::string literal_text(Literal literal) const;
  // How much of the task a bound leaves: nothing (no plan below it), a part, all that is reachable.
  enum class Focus { kNone, kPart, kAll };
  Focus focus_on(std::int64_t bound, Plan& plan, Budget& budget);
  std::int64_t dearest_action() const;
  void improve(Plan& plan, bool& found, const SolveOptions& options, Budget& budget);
};

Action Planner::Impl::name_of(std::int32_t schema, const ObjectId* binding) const {
  const CompiledSchema& compiled_schema = compiled.schemas[static_cast<std::size_t>(schema)];
  const ActionSchema& action = domain.actions[static_cast<std::size_t>(compiled_schema.action)];
  Action result{action.name, {}};
  for (std::int32_t i = 0; i < action.parameter_count; ++i) {
    result.arguments.push_back(index.problem().object_name(binding[i]));
  }
  return result;
}

std::int64_t Planner::Impl::cost_of(const std::vector<std::int32_t>& actions) const {
  std::int64_t cost = 0;
  for (const std::int32_t action : actions) cost += task.actions[static_cast<std::size_t>(action)].cost;
  return cost;
}

Expected<Plan> Planner::Impl::stopped(const Budget& budget, const SolveOptions& options) const {
  if (budget.reason() == Budget::Reason::kCancelled) return fail(Outcome::kCancelled, "planning was cancelled");
  const double limit = std::chrono::duration<double>(options.time_limit).count();
  return fail(Outcome::kTimeLimit, "no plan found within " + std::to_string(limit) +
                                       " s; that there is none is not known");
}

Expected<Plan> Planner::Impl::solve(const Problem& problem, const SolveOptions& options) {
  if (&problem.domain() != &domain) {
    return fail(Outcome::kInvalidRequest, "the problem belongs to domain " + problem.domain().name +
                                              ", the planner to " + domain.name);
  }
  Budget budget(options.stop, options.time_limit);
  if (budget.check()) return stopped(budget, options);
  const auto start = Clock::now();
  index.restart(problem, budget);
  if (budget.stopped()) return stopped(budget, options);
  if (simple_goal(domain, problem.goal, &literals)) {
    if (const AtomPattern* atom = contradiction(literals)) {
      std::string text = "(" + domain.predicates.name(atom->predicate);
      for (const Term term : atom->arguments) text += " " + problem.object_name(term.value);
      return fail(Outcome::kNoPlan, "the goal contradicts itself: " + text + ") and (not " + text + "))");
    }
    const bool reached = std::all_of(literals.begin(), literals.end(), [&](const GoalLiteral& literal) {
      return index.holds_initially(*literal.atom, nullptr) != literal.negative;
    });
    if (reached) {
      Plan plan;
      plan.optimal = true;
      plan.statistics.method = "nothing to do";
      plan.statistics.search_seconds = seconds_since(start);
      return plan;
    }
    if (!problem.minimise_cost && compiled.axioms.empty()) {
      if (const auto found = one_action.find(index, literals, budget)) {
        Plan plan;
        plan.actions.push_back(name_of(found->schema, found->binding.data()));
        plan.cost = plan.lower_bound = 1;
        plan.optimal = true;
        plan.statistics.method = "one action";
        plan.statistics.search_seconds = seconds_since(start);
        return plan;
      }
    }
  }
  return search(problem, options, budget);
}

Expected<Plan> Planner::Impl::search(const Problem& problem, const SolveOptions& options, Budget& budget) {
  const auto start = Clock::now();
  std::vector<TypeSet> slots = problem.goal_slots;
  const Formula goal = Normaliser(domain, slots).normalise(problem.goal);
  const Grounder::Result grounded = grounder.ground(index, goal, slots, budget, task);
  if (grounded == Grounder::Result::kStopped) return stopped(budget, options);
  if (grounded == Grounder::Result::kTooLarge) {
    return fail(Outcome::kStepLimit, "the goal needs more than " + std::to_string(Grounder::kMostActions) +
                                         " ground actions; that is too large for this planner");
  }
  if (task.goal_impossible) return fail(Outcome::kNoPlan, "there is no plan: the goal can never hold");
  Plan plan;
  plan.statistics.ground_actions = static_cast<std::int64_t>(task.actions.size());
  plan.statistics.ground_facts = task.atoms.size();
  relaxed.build(task, budget);
  if (budget.stopped()) return stopped(budget, options);
  initial_state(task, &initial);
  plan.statistics.grounding_seconds = seconds_since(start);
  const auto search_start = Clock::now();

  bool found = all_hold(task, initial.data(), task.goal);
  best.clear();
  exhausted = false;
  if (found) {
    plan.optimal = true;
    plan.statistics.method = "nothing to do";
    return plan;
  }
  lm_cut.restart(relaxed);
  relaxed_planner.restart(relaxed);
  ++plan.statistics.evaluated;
  const std::int64_t estimate = lm_cut.evaluate(initial.data(), budget);
  if (budget.stopped()) return stopped(budget, options);
  if (estimate >= LmCut::kDeadEnd) return fail(Outcome::kNoPlan, unreachable_message());
  plan.lower_bound = first_estimate = estimate;
  found = relaxed_planner.execute(initial.data(), budget, &best);
  if (found) {
    plan.cost = cost_of(best);
    plan.statistics.method = "relaxed plan";
    plan.optimal = plan.cost == plan.lower_bound;
  }
  if (!found) {
    if (const auto mutex = find_goal_mutex(task, budget)) {
      return fail(Outcome::kNoPlan, "there is no plan: " + literal_text(mutex->first) + " and " +
                                        literal_text(mutex->second) + " exclude each other");
    }
  }
  if (!plan.optimal && !(found && options.satisficing) && !budget.check()) improve(plan, found, options, budget);
  plan.statistics.search_seconds = seconds_since(search_start);
  return finish(std::move(plan), found, budget, options);
}

// Optimal search, with satisficing ones in between where they give a first or a better plan sooner.
void Planner::Impl::improve(Plan& plan, bool& found, const SolveOptions& options, Budget& budget) {
  constexpr std::int64_t kFirstNodes = 2000;     // most household problems end before
  constexpr std::int64_t kFirstWork = 600'000;   // nodes times actions: large tasks get fewer nodes, but some
  constexpr std::int64_t kFewestNodes = 50;
  constexpr std::int64_t kNodesWithPlan = 20;    // times as many where a plan is known already
  constexpr std::size_t kLargeTask = 10'000;     // actions
  const auto start = Clock::now();
  SearchLimits limits;
  limits.bytes = options.memory_limit;
  bool exclusion_tried = false;
  if (found) {
    shorten_plan(task, initial.data(), budget, &best);
    limits.upper_bound = plan.cost = cost_of(best);
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
    const auto result = satisficing.search(relaxed, relaxed_planner, initial.data(), some, time, plan.statistics);
    if (result == SatisficingSearch::Result::kFound) {
      best = satisficing.plan();
      plan.cost = limits.upper_bound = satisficing.cost();
      plan.statistics.method = satisficing.method();
      found = true;
    }
    return result;
  };
  // What is left of the time: half of it where there is no plan yet, so that some remains for finding one; with a plan,
  // proving may not take longer than the proof limit.
  const auto share = [&](bool whole) {
    auto left = budget.limited() ? budget.deadline() - Clock::now() : std::chrono::nanoseconds(0);
    if (!whole) left /= 2;
    if (found && options.proof_limit.count() > 0) {
      const auto proof = std::max(options.proof_limit - (Clock::now() - start), std::chrono::nanoseconds(1));
      left = budget.limited() ? std::min<std::chrono::nanoseconds>(left, proof) : proof;
    }
    if (budget.limited()) left = std::max(left, std::chrono::nanoseconds(1));
    return Budget(options.stop, left);
  };
  constexpr int kNoLimit = 1 << 20, kFewTurns = 2;
  if (options.satisficing) {
    exhausted = satisfice(kNoLimit, budget) == SatisficingSearch::Result::kExhausted && !found;
    plan.optimal = found && plan.cost == plan.lower_bound;
    return;
  }
  bool tried = false;
  if (!found && task.actions.size() > kLargeTask) {  // here even the first lower bounds take seconds
    tried = true;
    Budget half = share(false);
    if (satisfice(kFewTurns, half) == SatisficingSearch::Result::kExhausted && !found) {
      exhausted = true;
      return;
    }
  }
  // Plans up to a little above the lower bound first: the fewer actions fit under the bound, the faster the search.
  // The bound grows until a plan is found or nothing was left out.
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
      Budget part = share(false);
      result = optimal.resume(here, part, plan.statistics);
      if (result == OptimalSearch::Result::kNodeLimit || (result == OptimalSearch::Result::kStopped && !budget.check())) {
        tried = true;
        Budget half = share(false);
        if (satisfice(found ? 1 : kFewTurns, half) == SatisficingSearch::Result::kExhausted && !found) {
          exhausted = true;
          break;
        }
        here.upper_bound = std::min(here.upper_bound, limits.upper_bound);
        result = OptimalSearch::Result::kNodeLimit;
      }
    }
    if (result == OptimalSearch::Result::kNodeLimit) {
      here.nodes = options.node_limit;
      Budget part = share(found);
      result = optimal.resume(here, part, plan.statistics);
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
    if (!found && !budget.check()) exhausted = satisfice(kNoLimit, budget) == SatisficingSearch::Result::kExhausted;
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

// Filters the task for plans below `bound`, again as long as that raises the estimate. Raises plan.lower_bound.
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
  initial_state(focused, &focused_initial);
  focused_lm_cut.restart(focused_relaxed);
  ++plan.statistics.evaluated;
  estimate = focused_lm_cut.evaluate(focused_initial.data(), budget);
  if (estimate >= bound && !budget.check()) return Focus::kNone;
  plan.lower_bound = std::max(plan.lower_bound, std::min(estimate, bound));
  return left_out == 0 ? Focus::kAll : Focus::kPart;
}

std::string Planner::Impl::literal_text(Literal literal) const {
  const AtomRef atom = task.atoms[literal >> 1];
  std::string text = "(" + domain.predicates.name(atom.predicate);
  for (const ObjectId id : atom.arguments) text += " " + index.problem().object_name(id);
  return (literal & 1) != 0 ? "(not " + text + "))" : text + ")";
}

std::string Planner::Impl::unreachable_message() const {
  for (const ConditionId condition : task.goal) {
    if (condition >= 0 && !lm_cut.reachable(condition)) {
      return "there is no plan: nothing can make " + literal_text(condition) + " true";
    }
  }
  return "there is no plan: nothing leads to the goal";
}

// Why every state was tried in vain, where two goals can never hold together; or "".
std::string Planner::Impl::exclusive_goals_message(Budget& budget) const {
  PairReachability pairs;
  if (!pairs.compute(task, budget)) return "";
  for (std::size_t i = 0; i < task.goal.size(); ++i) {
    for (std::size_t j = 0; j < i && !budget.poll(); ++j) {
      if (task.goal[i] < 0 || task.goal[j] < 0 || !pairs.exclusive(task.goal[i], task.goal[j])) continue;
      return "there is no plan: " + literal_text(task.goal[j]) + " and " + literal_text(task.goal[i]) + " exclude each other";
    }
  }
  return "";
}

Expected<Plan> Planner::Impl::finish(Plan plan, bool found, Budget& budget, const SolveOptions& options) {
  if (budget.reason() == Budget::Reason::kCancelled) return stopped(budget, options);
  if (!found) {
    if (exhausted) {
      const std::string why = exclusive_goals_message(budget);
      return fail(Outcome::kNoPlan, why.empty() ? "there is no plan: every state that could lead on was tried" : why);
    }
    if (budget.reason() == Budget::Reason::kTime) return stopped(budget, options);
    return fail(Outcome::kStepLimit, "no plan found within the memory and node limits; that there is none is not known");
  }
  for (const std::int32_t action : best) {
    const GroundAction& ground = task.actions[static_cast<std::size_t>(action)];
    plan.actions.push_back(name_of(ground.schema, task.bindings.data() + ground.binding));
  }
  return plan;
}

Planner::Planner(const Domain& domain) : impl_(std::make_unique<Impl>(domain)) {}
Planner::~Planner() = default;
Planner::Planner(Planner&&) noexcept = default;
Planner& Planner::operator=(Planner&&) noexcept = default;

const Domain& Planner::domain() const { return impl_->domain; }

Expected<Plan> Planner::solve(const Problem& problem, const SolveOptions& options) {
  return impl_->solve(problem, options);
}

Expected<Plan> Planner::solve(const WorldState& state, const Goal& goal, const SolveOptions& options) {
  if (auto made = make_problem(state, goal, impl_->scratch); !made) return tl::unexpected(made.error());
  return impl_->solve(impl_->scratch, options);
}

Expected<Plan> solve(const Domain& domain, const Problem& problem, const SolveOptions& options) {
  return Planner(domain).solve(problem, options);
}

}  // namespace goalnet::planner
