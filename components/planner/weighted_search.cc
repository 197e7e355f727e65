#include "components/planner/weighted_search.h"

#include <algorithm>

namespace goalnet::planner {
std::int64_t WeightedSearch::bytes() const {
  return states_.bytes() + static_cast<std::int64_t>(open_.bytes() + nodes_.bytes());
}

void WeightedSearch::extract(std::int32_t id) {
  for (; nodes_[static_cast<std::size_t>(id)].parent >= 0; id = nodes_[static_cast<std::size_t>(id)].parent)
    plan_.push_back(nodes_[static_cast<std::size_t>(id)].action);
  std::reverse(plan_.begin(), plan_.end());
}

// Evaluates a state and queues its successors.
void WeightedSearch::open(const GroundTask& task, RelaxedPlanner& heuristic, std::int32_t id,
                          std::int64_t weight, Budget& budget, Statistics& statistics) {
  ++statistics.evaluated;
  const std::int64_t h = heuristic.evaluate(states_.state(id), budget);
  if (h >= RelaxedPlanner::kDeadEnd || budget.stopped()) return;
  ++statistics.expanded;
  if (h < best_h_) {
    best_h_ = h;
    open_.favour(kPreferred);
  }
  const std::int64_t f = nodes_[static_cast<std::size_t>(id)].g + weight * h;
  for (const std::int32_t action : heuristic.applicable()) open_.push(kAll, f, id, action);
  for (const std::int32_t action : heuristic.actions()) {
    if (action_applies(task, states_.state(id), task.actions[static_cast<std::size_t>(action)]))
      open_.push(kPreferred, f, id, action);
  }
}

WeightedSearch::Result WeightedSearch::search(const GroundTask& task, RelaxedPlanner& heuristic,
                                              const Word* initial, std::int64_t upper_bound,
                                              std::int64_t weight, std::int64_t most_bytes, Budget& budget,
                                              Statistics& statistics, const Pruning& pruning) {
  const std::size_t words = std::max<std::size_t>(task.words(), 1);
  pruning.restart(states_, words);
  nodes_.clear();
  open_.clear();
  best_h_ = INT64_MAX;
  next_.resize(words);
  plan_.clear();
  bool is_new = false;
  pruning.add(states_, initial, key_, &is_new);
  nodes_.push_back({});
  open(task, heuristic, 0, weight, budget, statistics);
  Result result = Result::kExhausted;
  OpenEntry entry{};
  while (open_.pop(&entry)) {
    if (budget.poll()) {
      result = Result::kStopped;
      break;
    }
    if (most_bytes > 0 && bytes() > most_bytes) {
      result = Result::kMemory;
      break;
    }
    const GroundAction& action = task.actions[static_cast<std::size_t>(entry.action)];
    const std::int64_t g = nodes_[static_cast<std::size_t>(entry.parent)].g + action.cost;
    if (g >= upper_bound) continue;
    apply_action(task, states_.state(entry.parent), action, next_.data());
    ++statistics.generated;
    if (pruning.dead.dead_after(task, action, next_.data())) continue;
    std::int32_t id = pruning.add(states_, next_.data(), key_, &is_new);
    if (!is_new) {
      if (g >= nodes_[static_cast<std::size_t>(id)].g) continue;
      // The state that is known may be another one, like this but for which thing is where; what follows from
      // it stays as it is, and this one takes its place.
      if (pruning.symmetry.any()) {
        id = states_.add_variant(next_.data(), id);
        is_new = true;
      }
    }
    if (is_new) {
      nodes_.push_back({g, entry.parent, entry.action});
    } else {
      nodes_[static_cast<std::size_t>(id)] = {g, entry.parent, entry.action};
    }
    if (all_hold(task, next_.data(), task.goal)) {
      extract(id);
      result = Result::kFound;
      break;
    }
    open(task, heuristic, id, weight, budget, statistics);
  }
  if (budget.stopped() && result == Result::kExhausted) result = Result::kStopped;
  statistics.peak_bytes = std::max(statistics.peak_bytes, bytes());
  return result;
}

}  // namespace goalnet::planner
