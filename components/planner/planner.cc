#include "components/planner/planner.h"

#include <algorithm>

#include "components/planner/goal_mutex.h"
#include "components/planner/planner_impl.h"
#include "components/planner/world.h"

namespace goalnet::planner {
namespace {

using Clock = Budget::Clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

Expected<Plan> Planner::Impl::solve(const Problem& problem, const SolveOptions& options) {
  if (&problem.domain() != &domain) {
    return fail(Outcome::kInvalidRequest,
                "the problem belongs to domain " + problem.domain().name + ", the planner to " + domain.name);
  }
  Budget budget(options.stop, options.time_limit);
  if (!prepared) return fail(Outcome::kCancelled, "preparing the domain was cancelled");
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
  auto answer = search(problem, options, budget);
  if (!answer && answer.error().outcome == Outcome::kNoPlan && grounder.without_cost() >= 0) {
    const auto& schema = compiled.schemas[static_cast<std::size_t>(grounder.without_cost())];
    answer.error().message += "; where the problem gives no value for the cost of action " +
                              std::string(domain.actions[static_cast<std::size_t>(schema.action)].name) +
                              ", that action cannot be used";
  }
  return answer;
}

Expected<Plan> Planner::Impl::search(const Problem& problem, const SolveOptions& options, Budget& budget) {
  const auto start = Clock::now();
  std::vector<TypeSet> slots = problem.goal_slots;
  goal_memory.clear();
  const Formula goal = Normaliser(domain, slots, goal_memory, options.stop).normalise(problem.goal);
  if (budget.check()) return stopped(budget, options);
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
  initial_state(task, budget, &initial);
  if (budget.stopped()) return stopped(budget, options);
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
  lm_cut.restart(relaxed, budget);
  relaxed_planner.restart(relaxed, budget);
  if (budget.stopped()) return stopped(budget, options);
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
  if (!plan.optimal && !(found && options.satisficing) && !budget.check())
    improve(plan, found, options, budget);
  plan.statistics.search_seconds = seconds_since(search_start);
  return finish(std::move(plan), found, budget, options);
}

Planner::Planner(const Domain& domain, const std::stop_token& stop)
    : impl_(std::make_unique<Impl>(domain, stop)) {}
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
  return Planner(domain, options.stop).solve(problem, options);
}

}  // namespace goalnet::planner
