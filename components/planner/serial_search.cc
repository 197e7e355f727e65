#include "components/planner/serial_search.h"

#include <algorithm>

namespace goalnet::planner {
namespace {
constexpr std::int64_t kLazyStates = 300, kEagerStates = 1000;  // for one more goal

bool undoes(const GroundTask& task, const std::vector<std::int32_t>& actions, const Word* state,
            const std::vector<ConditionId>& goals) {
  for (const std::int32_t number : actions) {
    for (const GroundEffect& effect : task.effects_of(task.actions[static_cast<std::size_t>(number)])) {
      const Literal undone = opposite(effect.literal);
      if (literal_holds(state, undone) && std::find(goals.begin(), goals.end(), undone) != goals.end())
        return true;
    }
  }
  return false;
}
}  // namespace

// One more goal besides those reached; strict: only if the relaxed plan for the rest leaves all of them
// alone.
bool SerialSearch::advance(const GroundTask& task, RelaxedPlanner& heuristic, ConditionId goal,
                           std::int64_t most_bytes, bool strict, Budget& budget, Statistics& statistics) {
  part_.goal = reached_;
  part_.goal.push_back(goal);
  relaxed_.build(part_);
  planner_.restart(relaxed_);
  auto result =
      greedy_.search(part_, planner_, state_.data(), INT64_MAX, kLazyStates, most_bytes, budget, statistics);
  if (result == GreedySearch::Result::kLimit) {
    result = greedy_.search(part_, planner_, state_.data(), INT64_MAX, kEagerStates, most_bytes, budget,
                            statistics, GreedySearch::Style::kEager);
  }
  if (result != GreedySearch::Result::kFound) return false;
  after_ = state_;
  next_.resize(state_.size());
  for (const std::int32_t number : greedy_.plan()) {
    apply_action(task, after_.data(), task.actions[static_cast<std::size_t>(number)], next_.data());
    after_.swap(next_);
  }
  if (heuristic.evaluate(after_.data(), budget) >= RelaxedPlanner::kDeadEnd) return false;
  if (strict && undoes(task, heuristic.actions(), after_.data(), part_.goal)) return false;
  state_ = after_;
  reached_.push_back(goal);
  plan_.insert(plan_.end(), greedy_.plan().begin(), greedy_.plan().end());
  return true;
}

bool SerialSearch::search(const GroundTask& task, RelaxedPlanner& heuristic, const Word* initial,
                          std::int64_t most_states, std::int64_t most_bytes, Budget& budget, Statistics& statistics) {
  const std::int64_t last = statistics.evaluated + most_states;
  part_ = task;
  state_.assign(initial, initial + std::max<std::size_t>(task.words(), 1));
  reached_.clear();
  plan_.clear();
  std::vector<ConditionId> open = task.goal;
  while (!open.empty() && !budget.check()) {
    bool any = false;
    for (const bool strict : {true, false}) {
      for (std::size_t i = 0; i < open.size() && !any && !budget.check() && statistics.evaluated < last; ++i) {
        if (!advance(task, heuristic, open[i], most_bytes, strict, budget, statistics)) continue;
        open.erase(open.begin() + static_cast<std::ptrdiff_t>(i));
        any = true;
      }
      if (any) break;
    }
    if (!any) return false;
  }
  return open.empty();
}

}  // namespace goalnet::planner
