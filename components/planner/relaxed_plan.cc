#include "components/planner/relaxed_plan.h"

#include <algorithm>

namespace goalnet::planner {
namespace {
constexpr std::int64_t kUnreached = INT64_MAX / 2;
constexpr std::int64_t kHighest = INT64_MAX / 8;  // sums are capped here
}  // namespace

void RelaxedPlanner::restart(const RelaxedTask& relaxed, Budget& budget) {
  relaxed_ = &relaxed;
  counts_actions_ = false;
  extra_ = 0;
  const std::size_t actions = relaxed.task().actions.size(), operators = relaxed.operators().size();
  const auto propositions = static_cast<std::size_t>(relaxed.proposition_count());
  const auto stop = [&budget] { return budget.check(); };
  const bool whole = cost_.assign(propositions, 0, stop) && best_.assign(propositions, 0, stop) &&
                     marked_.assign(propositions, 0, stop) && unsatisfied_.assign(operators, 0, stop) &&
                     sum_.assign(operators, 0, stop) && in_plan_.assign(actions, 0, stop) &&
                     listed_.assign(actions, 0, stop);
  applicable_.clear();
  if (!whole) return;
  for (const GroundAction& action : relaxed.task().actions) {
    if (action.cost == 0) extra_ = 1;
    if (budget.poll()) return;
  }
}

void RelaxedPlanner::reach(Proposition p, std::int64_t cost, std::int32_t op) {
  const auto i = static_cast<std::size_t>(p);
  if (cost >= cost_[i]) return;
  cost_[i] = cost;
  best_[i] = op;
  queue_.push(cost, p);
}

void RelaxedPlanner::explore(const Word* state, Budget& budget) {
  const auto& operators = relaxed_->operators();
  std::fill(cost_.begin(), cost_.end(), kUnreached);
  for (std::size_t i = 0; i < operators.size() && !budget.poll(); ++i) {
    unsatisfied_[i] =
        static_cast<std::int32_t>(operators[i].precondition_end - operators[i].precondition_begin);
    sum_[i] = cost_of(operators[i]);
  }
  if (budget.stopped()) return;
  queue_.clear();
  for (const std::int32_t action : applicable_) listed_[static_cast<std::size_t>(action)] = 0;
  applicable_.clear();
  relaxed_->for_each_true(state, budget, [this](Literal literal) { reach(literal, 0, -1); });
  reach(relaxed_->always(), 0, -1);
  while (!queue_.empty() && !budget.poll()) {
    const auto [cost, p] = queue_.pop();
    if (cost != cost_[static_cast<std::size_t>(p)]) continue;
    if (p == relaxed_->goal()) return;
    for (const std::int32_t user : relaxed_->users(p)) {
      const auto i = static_cast<std::size_t>(user);
      sum_[i] = std::min(sum_[i] + cost, kHighest);
      if (--unsatisfied_[i] != 0) continue;
      const std::int32_t action = operators[i].action;
      // Derived facts are taken to come and go for nothing, so that with axioms this alone does not make it
      // applicable.
      if (cost == 0 && action >= 0 && sum_[i] == cost_of(operators[i]) &&
          listed_[static_cast<std::size_t>(action)] == 0 &&
          (relaxed_->task().axioms.empty() ||
           action_applies(relaxed_->task(), state,
                          relaxed_->task().actions[static_cast<std::size_t>(action)]))) {
        applicable_.push_back(action);
        listed_[static_cast<std::size_t>(action)] = 1;
      }
      for (const Proposition effect : relaxed_->effects(operators[i])) reach(effect, sum_[i], user);
    }
  }
}

// Depth-first: first what an operator needs, in the order of its preconditions, then the operator.
void RelaxedPlanner::extract(Proposition goal) {
  const auto& operators = relaxed_->operators();
  const auto open = [&](Proposition p) {
    auto& mark = marked_[static_cast<std::size_t>(p)];
    if (mark != 0 || best_[static_cast<std::size_t>(p)] < 0) return;
    mark = 1;
    stack_.emplace_back(p, 0);
  };
  stack_.clear();
  open(goal);
  while (!stack_.empty()) {
    auto& [p, next] = stack_.back();
    const std::int32_t op = best_[static_cast<std::size_t>(p)];
    const auto needs = relaxed_->preconditions(operators[static_cast<std::size_t>(op)]);
    if (next < needs.size()) {
      open(needs[next++]);  // may move the stack
      continue;
    }
    stack_.pop_back();
    const std::int32_t action = operators[static_cast<std::size_t>(op)].action;
    if (action < 0 || in_plan_[static_cast<std::size_t>(action)] != 0) continue;
    in_plan_[static_cast<std::size_t>(action)] = 1;
    plan_.push_back(action);
  }
}

std::int64_t RelaxedPlanner::evaluate(const Word* state, Budget& budget) {
  explore(state, budget);
  plan_.clear();
  if (budget.stopped()) return kDeadEnd;
  if (cost_[static_cast<std::size_t>(relaxed_->goal())] >= kUnreached) return kDeadEnd;
  std::fill(marked_.begin(), marked_.end(), std::uint8_t{0});
  extract(relaxed_->goal());
  std::int64_t total = 0;
  for (const std::int32_t action : plan_) {
    in_plan_[static_cast<std::size_t>(action)] = 0;
    total += cost_of_action(action);
  }
  return total;
}

bool RelaxedPlanner::execute(const Word* state, Budget& budget, std::vector<std::int32_t>* plan) {
  constexpr int kMostRounds = 50;
  const GroundTask& task = relaxed_->task();
  const std::size_t words = std::max<std::size_t>(task.words(), 1);
  current_.assign(state, state + words);
  next_.resize(words);
  plan->clear();
  for (int round = 0; round < kMostRounds && !budget.poll(); ++round) {
    if (all_hold(task, current_.data(), task.goal)) return true;
    if (evaluate(current_.data(), budget) >= kDeadEnd) return false;
    rest_ = plan_;
    bool any = false;
    for (bool progress = true; progress && !rest_.empty();) {
      progress = false;
      std::size_t kept = 0;
      for (std::size_t i = 0; i < rest_.size(); ++i) {
        if (budget.poll()) return false;
        const GroundAction& action = task.actions[static_cast<std::size_t>(rest_[i])];
        if (!action_applies(task, current_.data(), action)) {
          rest_[kept++] = rest_[i];
          continue;
        }
        apply_action(task, current_.data(), action, next_.data());
        current_.swap(next_);
        plan->push_back(rest_[i]);
        any = progress = true;
      }
      rest_.resize(kept);
    }
    if (!any) return false;
  }
  return false;
}

}  // namespace goalnet::planner
