#include "components/planner/lm_cut.h"

#include <algorithm>

namespace goalnet::planner {
namespace {
constexpr std::int64_t kUnreached = INT64_MAX / 2;
}

void LmCut::restart(const RelaxedTask& relaxed) {
  relaxed_ = &relaxed;
  const std::size_t operators = relaxed.operators().size();
  const auto propositions = static_cast<std::size_t>(relaxed.proposition_count());
  cost_left_.resize(relaxed.task().actions.size());
  in_cut_.assign(relaxed.task().actions.size(), 0);
  proposition_cost_.resize(propositions);
  zone_.resize(propositions);
  unsatisfied_.resize(operators);
  supporter_.resize(operators);
  supporter_cost_.resize(operators);
}

void LmCut::reach(Proposition p, std::int64_t cost) {
  auto& known = proposition_cost_[static_cast<std::size_t>(p)];
  if (cost >= known) return;
  known = cost;
  queue_.push(cost, p);
}

// h-max from `state`: every operator remembers its most expensive precondition, the supporter.
void LmCut::explore(const Word* state) {
  const auto& operators = relaxed_->operators();
  std::fill(proposition_cost_.begin(), proposition_cost_.end(), kUnreached);
  for (std::size_t i = 0; i < operators.size(); ++i) {
    unsatisfied_[i] = static_cast<std::int32_t>(operators[i].precondition_end - operators[i].precondition_begin);
  }
  queue_.clear();
  relaxed_->for_each_true(state, [this](Literal literal) { reach(literal, 0); });
  reach(relaxed_->always(), 0);
  while (!queue_.empty()) {
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
    if (proposition_cost_[static_cast<std::size_t>(p)] > proposition_cost_[static_cast<std::size_t>(supporter_[i])]) {
      supporter_[i] = p;
    }
  }
  supporter_cost_[i] = proposition_cost_[static_cast<std::size_t>(supporter_[i])];
}

// After the costs of the cut's actions went down: only what gets cheaper is visited.
void LmCut::propagate() {
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
  while (!queue_.empty()) {
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

// Propositions from which the goal follows by operators that cost nothing any more.
void LmCut::mark_goal_zone(Proposition goal) {
  stack_.assign(1, goal);
  zone_[static_cast<std::size_t>(goal)] = 1;
  while (!stack_.empty()) {
    const Proposition p = stack_.back();
    stack_.pop_back();
    for (const std::int32_t producer : relaxed_->producers(p)) {
      const auto i = static_cast<std::size_t>(producer);
      const RelaxedOperator& op = relaxed_->operators()[i];
      if (unsatisfied_[i] > 0 || (op.action >= 0 && cost_left_[static_cast<std::size_t>(op.action)] > 0)) continue;
      auto& mark = zone_[static_cast<std::size_t>(supporter_[i])];
      if (mark != 0) continue;
      mark = 1;
      stack_.push_back(supporter_[i]);
    }
  }
}

// Forward along supporters; operators that enter the goal zone are the cut. False if the zone contains the state.
bool LmCut::find_cut(const Word* state) {
  cut_.clear();
  stack_.clear();
  const auto visit = [this](Proposition p) {
    auto& mark = zone_[static_cast<std::size_t>(p)];
    if (mark != 0) return;
    mark = 2;
    stack_.push_back(p);
  };
  relaxed_->for_each_true(state, visit);
  visit(relaxed_->always());
  while (!stack_.empty()) {
    const Proposition p = stack_.back();
    stack_.pop_back();
    for (const std::int32_t user : relaxed_->users(p)) {
      const auto i = static_cast<std::size_t>(user);
      if (supporter_[i] != p || unsatisfied_[i] > 0) continue;
      bool enters = false;
      const auto effects = relaxed_->effects(relaxed_->operators()[i]);
      for (const Proposition effect : effects) enters = enters || zone_[static_cast<std::size_t>(effect)] == 1;
      if (enters) {
        cut_.push_back(user);
      } else {
        for (const Proposition effect : effects) visit(effect);
      }
    }
  }
  return !cut_.empty();
}

bool LmCut::reachable(ConditionId condition) const {
  return proposition_cost_[static_cast<std::size_t>(relaxed_->of(condition))] < kUnreached;
}

std::int64_t LmCut::evaluate(const Word* state, Budget& budget) {
  const auto& actions = relaxed_->task().actions;
  for (std::size_t i = 0; i < actions.size(); ++i) cost_left_[i] = actions[i].cost;
  explore(state);
  const auto goal = static_cast<std::size_t>(relaxed_->goal());
  if (proposition_cost_[goal] >= kUnreached) return kDeadEnd;
  std::int64_t total = 0;
  while (proposition_cost_[goal] > 0 && !budget.poll()) {
    std::fill(zone_.begin(), zone_.end(), std::uint8_t{0});
    mark_goal_zone(relaxed_->goal());
    if (!find_cut(state)) break;
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
    propagate();
  }
  return total;
}

}  // namespace goalnet::planner
