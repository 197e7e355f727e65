#include "components/planner/lm_cut.h"

#include <algorithm>

namespace goalnet::planner {
namespace {
constexpr std::int64_t kUnreached = INT64_MAX / 2;
}

void LmCut::restart(const RelaxedTask& relaxed, Budget& budget) {
  relaxed_ = &relaxed;
  const std::size_t actions = relaxed.task().actions.size(), operators = relaxed.operators().size();
  const auto propositions = static_cast<std::size_t>(relaxed.proposition_count());
  const auto stop = [&budget] { return budget.check(); };
  const bool whole = cost_left_.assign(actions, 0, stop) && in_cut_.assign(actions, 0, stop) &&
                     proposition_cost_.assign(propositions, 0, stop) &&
                     in_zone_.assign(propositions, 0, stop) && uses_.assign(propositions, 0, stop) &&
                     reached_.assign(propositions, 0, stop) &&
                     precondition_count_.assign(operators, 0, stop) && missing_.assign(operators, 0, stop) &&
                     unsatisfied_.assign(operators, 0, stop) && supporter_.assign(operators, 0, stop) &&
                     supporter_cost_.assign(operators, 0, stop);
  if (!whole) return;
  for (std::size_t i = 0; i < operators && !budget.poll(); ++i) {
    const RelaxedOperator& op = relaxed.operators()[i];
    precondition_count_[i] = static_cast<std::int32_t>(op.precondition_end - op.precondition_begin);
  }
}

void LmCut::reach(Proposition p, std::int64_t cost) {
  auto& known = proposition_cost_[static_cast<std::size_t>(p)];
  if (cost >= known) return;
  known = cost;
  queue_.push(cost, p);
}

// h-max from `state`: every operator remembers its most expensive precondition, the supporter.
void LmCut::explore(const Word* state, Budget& budget) {
  const auto& operators = relaxed_->operators();
  std::fill(proposition_cost_.begin(), proposition_cost_.end(), kUnreached);
  if (budget.check()) return;
  std::copy(precondition_count_.begin(), precondition_count_.end(), unsatisfied_.begin());
  queue_.clear();
  relaxed_->for_each_true(state, budget, [this](Literal literal) { reach(literal, 0); });
  reach(relaxed_->always(), 0);
  while (!queue_.empty() && !budget.poll()) {
    const auto [cost, p] = queue_.pop();
    if (cost != proposition_cost_[static_cast<std::size_t>(p)]) continue;
    for (const std::int32_t user : relaxed_->users(p)) {
      const auto i = static_cast<std::size_t>(user);
      if (--unsatisfied_[i] != 0) continue;
      supporter_[i] = p;
      supporter_cost_[i] = cost;
      const RelaxedOperator& op = operators[i];
      const std::int64_t reached =
          cost + (op.action < 0 ? 0 : cost_left_[static_cast<std::size_t>(op.action)]);
      for (const Proposition effect : relaxed_->effects(op)) reach(effect, reached);
    }
  }
}

void LmCut::update_supporter(std::int32_t index) {
  const auto i = static_cast<std::size_t>(index);
  for (const Proposition p : relaxed_->preconditions(relaxed_->operators()[i])) {
    if (proposition_cost_[static_cast<std::size_t>(p)] >
        proposition_cost_[static_cast<std::size_t>(supporter_[i])]) {
      supporter_[i] = p;
    }
  }
  supporter_cost_[i] = proposition_cost_[static_cast<std::size_t>(supporter_[i])];
}

// After the costs of the cut's actions went down: only what gets cheaper is visited.
void LmCut::propagate(Budget& budget) {
  const auto& operators = relaxed_->operators();
  queue_.clear();
  for (const std::int32_t action : cut_actions_) {
    for (const std::int32_t user : relaxed_->operators_of(action)) {
      const auto i = static_cast<std::size_t>(user);
      if (unsatisfied_[i] > 0) continue;
      const std::int64_t cost = supporter_cost_[i] + cost_left_[static_cast<std::size_t>(action)];
      for (const Proposition effect : relaxed_->effects(operators[i])) reach(effect, cost);
    }
  }
  while (!queue_.empty() && !budget.poll()) {
    const auto [cost, p] = queue_.pop();
    if (cost != proposition_cost_[static_cast<std::size_t>(p)]) continue;
    for (const std::int32_t user : relaxed_->users(p)) {
      const auto i = static_cast<std::size_t>(user);
      if (supporter_[i] != p || unsatisfied_[i] > 0) continue;
      const std::int64_t before = supporter_cost_[i];
      if (before <= cost) continue;
      update_supporter(user);
      if (supporter_cost_[i] == before) continue;
      const RelaxedOperator& op = operators[i];
      const std::int64_t reached =
          supporter_cost_[i] + (op.action < 0 ? 0 : cost_left_[static_cast<std::size_t>(op.action)]);
      for (const Proposition effect : relaxed_->effects(op)) reach(effect, reached);
    }
  }
}

// The goal zone: propositions from which the goal follows by operators that cost nothing any more. No free
// operator may enter it from outside, so one precondition of each must be in the zone. Any that itself costs
// something will do (the classical choice is the dearest); taking those that most operators share keeps the
// zone, and with it the cut, small, and leaves more for later cuts. With forty cups to pour from, this is the
// difference between 6 and 10.
void LmCut::mark_goal_zone(Proposition goal, Budget& budget) {
  constexpr std::size_t kMostPending = 400;  // beyond, choosing well costs more than it gives
  const auto enter = [this](Proposition p) {
    in_zone_[static_cast<std::size_t>(p)] = 1;
    zone_.push_back(p);
    for (const std::int32_t producer : relaxed_->producers(p)) {
      const auto i = static_cast<std::size_t>(producer);
      const RelaxedOperator& op = relaxed_->operators()[i];
      if (unsatisfied_[i] > 0 || (op.action >= 0 && cost_left_[static_cast<std::size_t>(op.action)] > 0))
        continue;
      pending_.push_back(producer);
    }
  };
  zone_.clear();
  pending_.clear();
  enter(goal);
  while (!budget.poll()) {
    std::erase_if(pending_, [this](std::int32_t op) {
      return needs_zone(relaxed_->operators()[static_cast<std::size_t>(op)]);
    });
    if (pending_.empty()) return;
    if (pending_.size() == 1 || pending_.size() > kMostPending) {
      enter(supporter_[static_cast<std::size_t>(pending_.back())]);
      continue;
    }
    Proposition best = -1;
    for (const std::int32_t op : pending_) {
      for (const Proposition p :
           relaxed_->preconditions(relaxed_->operators()[static_cast<std::size_t>(op)])) {
        const auto i = static_cast<std::size_t>(p);
        if (proposition_cost_[i] == 0) continue;
        ++uses_[i];
        const auto rank = [this](Proposition q) {
          return std::pair{uses_[static_cast<std::size_t>(q)],
                           proposition_cost_[static_cast<std::size_t>(q)]};
        };
        if (best < 0 || rank(p) > rank(best)) best = p;
      }
    }
    for (const std::int32_t op : pending_) {
      for (const Proposition p :
           relaxed_->preconditions(relaxed_->operators()[static_cast<std::size_t>(op)])) {
        uses_[static_cast<std::size_t>(p)] = 0;
      }
    }
    enter(best);
  }
}

bool LmCut::needs_zone(const RelaxedOperator& op) const {
  for (const Proposition p : relaxed_->preconditions(op)) {
    if (in_zone_[static_cast<std::size_t>(p)] != 0) return true;
  }
  return false;
}

// The cut: operators that can be the first to enter the zone, because all they need is reached outside of it.
// Which of the producers these are is found by exploring the relaxation without the zone.
void LmCut::find_cut(const Word* state, Budget& budget) {
  const auto& operators = relaxed_->operators();
  cut_.clear();
  std::copy(precondition_count_.begin(), precondition_count_.end(), missing_.begin());
  std::fill(reached_.begin(), reached_.end(), std::uint8_t{0});
  stack_.clear();
  const auto visit = [this](Proposition p) {
    auto& mark = reached_[static_cast<std::size_t>(p)];
    if (mark != 0) return;
    mark = 1;
    stack_.push_back(p);
  };
  relaxed_->for_each_true(state, budget, visit);
  visit(relaxed_->always());
  while (!stack_.empty() && !budget.poll()) {
    const Proposition p = stack_.back();
    stack_.pop_back();
    for (const std::int32_t user : relaxed_->users(p)) {
      const auto i = static_cast<std::size_t>(user);
      if (--missing_[i] != 0) continue;
      bool enters = false;
      const auto effects = relaxed_->effects(operators[i]);
      for (const Proposition effect : effects)
        enters = enters || in_zone_[static_cast<std::size_t>(effect)] != 0;
      if (enters) {
        cut_.push_back(user);
      } else {
        for (const Proposition effect : effects) visit(effect);
      }
    }
  }
}

bool LmCut::reachable(ConditionId condition) const {
  return proposition_cost_[static_cast<std::size_t>(relaxed_->of(condition))] < kUnreached;
}

std::int64_t LmCut::evaluate(const Word* state, Budget& budget) {
  const auto& actions = relaxed_->task().actions;
  for (std::size_t i = 0; i < actions.size(); ++i) cost_left_[i] = actions[i].cost;
  explore(state, budget);
  if (budget.stopped()) return 0;
  const auto goal = static_cast<std::size_t>(relaxed_->goal());
  if (proposition_cost_[goal] >= kUnreached) return kDeadEnd;
  std::int64_t total = 0;
  while (proposition_cost_[goal] > 0 && !budget.poll()) {
    mark_goal_zone(relaxed_->goal(), budget);
    find_cut(state, budget);
    for (const Proposition p : zone_) in_zone_[static_cast<std::size_t>(p)] = 0;
    if (cut_.empty() || budget.stopped()) break;
    std::int64_t cheapest = INT64_MAX;
    cut_actions_.clear();
    for (const std::int32_t op : cut_) {
      const std::int32_t action = relaxed_->operators()[static_cast<std::size_t>(op)].action;
      auto& mark = in_cut_[static_cast<std::size_t>(action)];
      if (mark != 0) continue;
      mark = 1;
      cut_actions_.push_back(action);
      cheapest = std::min(cheapest, cost_left_[static_cast<std::size_t>(action)]);
    }
    for (const std::int32_t action : cut_actions_) {
      in_cut_[static_cast<std::size_t>(action)] = 0;
      cost_left_[static_cast<std::size_t>(action)] -= cheapest;
    }
    total += cheapest;
    propagate(budget);
  }
  return total;
}

}  // namespace goalnet::planner
