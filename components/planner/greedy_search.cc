#include "components/planner/greedy_search.h"

#include <algorithm>

namespace goalnet::planner {
namespace {
constexpr std::int64_t kUndone =
    4;  // what a goal reached too early adds to the estimate, in cheapest actions
}  // namespace

std::int64_t GreedySearch::bytes() const {
  return states_.bytes() + static_cast<std::int64_t>(open_.bytes() + nodes_.bytes());
}

void GreedySearch::note_goals(const GroundTask& task) {
  is_goal_.assign(2 * task.initial.size(), 0);
  for (const ConditionId condition : task.goal) {
    if (condition >= 0) is_goal_[static_cast<std::size_t>(condition)] = 1;
  }
}

std::int64_t GreedySearch::undone_goals(const GroundTask& task, const RelaxedPlanner& heuristic,
                                        const Word* state) {
  undone_.clear();
  for (const std::int32_t number : heuristic.actions()) {
    for (const GroundEffect& effect : task.effects_of(task.actions[static_cast<std::size_t>(number)])) {
      const Literal goal = opposite(effect.literal);
      if (is_goal_[static_cast<std::size_t>(goal)] != 1 || !literal_holds(state, goal)) continue;
      is_goal_[static_cast<std::size_t>(goal)] = 2;  // counted
      undone_.push_back(goal);
    }
  }
  for (const Literal goal : undone_) is_goal_[static_cast<std::size_t>(goal)] = 1;
  return static_cast<std::int64_t>(undone_.size());
}

std::int32_t GreedySearch::look_ahead(const GroundTask& task, const RelaxedPlanner& heuristic,
                                      const Pruning& pruning, std::int32_t id, std::int64_t upper_bound,
                                      Budget& budget) {
  rest_ = heuristic.actions();
  const std::int32_t first_new = states_.size();
  for (bool progress = true; progress && !rest_.empty();) {
    progress = false;
    std::size_t kept = 0;
    for (const std::int32_t number : rest_) {
      if (budget.poll()) return -1;
      const GroundAction& action = task.actions[static_cast<std::size_t>(number)];
      const std::int64_t g = nodes_[static_cast<std::size_t>(id)].g + action.cost;
      if (g >= upper_bound || !action_applies(task, states_.state(id), action)) {
        rest_[kept++] = number;
        continue;
      }
      apply_action(task, states_.state(id), action, next_.data());
      if (pruning.dead.dead_after(task, action, next_.data())) {
        rest_[kept++] = number;
        continue;
      }
      bool is_new = false;
      const std::int32_t next = pruning.add(states_, next_.data(), key_, &is_new);
      if (is_new) nodes_.push_back({id, number, g, false});
      id = next;
      progress = true;
    }
    rest_.resize(kept);
  }
  return id >= first_new ? id : -1;
}

GreedySearch::Result GreedySearch::search(const GroundTask& task, RelaxedPlanner& heuristic,
                                          const Word* initial, std::int64_t upper_bound,
                                          std::int64_t most_states, std::int64_t most_bytes, Budget& budget,
                                          Statistics& statistics, const Pruning& pruning, Style style) {
  const std::size_t words = std::max<std::size_t>(task.words(), 1);
  pruning.restart(states_, words);
  nodes_.clear();
  open_.clear();
  next_.resize(words);
  note_goals(task);
  plan_.clear();
  std::int64_t cheapest = INT64_MAX;
  for (const GroundAction& action : task.actions)
    cheapest = std::min(cheapest, std::max<std::int64_t>(action.cost, 1));
  std::int64_t best_h = INT64_MAX, evaluated = 0;

  // Evaluates a state and queues its successors, then goes on where its relaxed plan leads as long as that
  // helps. The goal state found, or -1.
  const auto open = [&](std::int32_t id) {
    for (std::int64_t before = INT64_MAX; id >= 0 && !budget.poll();) {
      nodes_[static_cast<std::size_t>(id)].opened = true;
      if (all_hold(task, states_.state(id), task.goal)) return id;
      ++evaluated;
      const std::int64_t h = heuristic.evaluate(states_.state(id), budget);
      if (h >= RelaxedPlanner::kDeadEnd) break;
      ++statistics.expanded;
      if (h < best_h) {
        best_h = h;
        open_.favour(kPreferred);
      }
      for (const std::int32_t action : heuristic.applicable()) open_.push(kAll, h, id, action);
      for (const std::int32_t action : heuristic.actions()) {
        if (action_applies(task, states_.state(id), task.actions[static_cast<std::size_t>(action)])) {
          open_.push(kPreferred, h, id, action);
        }
      }
      if (h >= before) break;
      before = h;
      id = look_ahead(task, heuristic, pruning, id, upper_bound, budget);
    }
    return -1;
  };
  // Estimates a state and queues it. The state if it is a goal, or -1.
  const auto estimate = [&](std::int32_t id, bool preferred) {
    const Word* state = states_.state(id);
    if (all_hold(task, state, task.goal)) return id;
    ++evaluated;
    std::int64_t h = heuristic.evaluate(state, budget);
    if (h >= RelaxedPlanner::kDeadEnd) return -1;
    h += kUndone * cheapest * undone_goals(task, heuristic, state);
    if (h < best_h) {
      best_h = h;
      open_.favour(kPreferred);
    }
    open_.push(kAll, h, id, -1);
    if (preferred) open_.push(kPreferred, h, id, -1);
    return -1;
  };
  const auto expand = [&](std::int32_t id) {
    if (nodes_[static_cast<std::size_t>(id)].opened) return -1;
    nodes_[static_cast<std::size_t>(id)].opened = true;
    ++statistics.expanded;
    ++evaluated;
    if (heuristic.evaluate(states_.state(id), budget) >= RelaxedPlanner::kDeadEnd) return -1;
    applicable_ = heuristic.applicable();
    helpful_ = heuristic.actions();
    std::sort(helpful_.begin(), helpful_.end());
    for (const std::int32_t number : applicable_) {
      const GroundAction& action = task.actions[static_cast<std::size_t>(number)];
      const std::int64_t g = nodes_[static_cast<std::size_t>(id)].g + action.cost;
      if (g >= upper_bound) continue;
      apply_action(task, states_.state(id), action, next_.data());
      if (pruning.dead.dead_after(task, action, next_.data())) continue;
      bool is_new_state = false;
      const std::int32_t child = pruning.add(states_, next_.data(), key_, &is_new_state);
      ++statistics.generated;
      if (!is_new_state) continue;
      nodes_.push_back({id, number, g, false});
      if (estimate(child, std::binary_search(helpful_.begin(), helpful_.end(), number)) >= 0) return child;
    }
    return -1;
  };
  const auto extract = [&](std::int32_t id) {
    plan_.clear();
    for (; nodes_[static_cast<std::size_t>(id)].parent >= 0;
         id = nodes_[static_cast<std::size_t>(id)].parent) {
      plan_.push_back(nodes_[static_cast<std::size_t>(id)].action);
    }
    std::reverse(plan_.begin(), plan_.end());
  };

  bool is_new = false;
  pruning.add(states_, initial, key_, &is_new);
  nodes_.push_back({});
  Result result = Result::kExhausted;
  if (const std::int32_t goal = style == Style::kEager ? estimate(0, false) : open(0); goal >= 0) {
    extract(goal);
    statistics.evaluated += evaluated;
    return Result::kFound;
  }
  OpenEntry entry{};
  while (open_.pop(&entry)) {
    if (budget.poll()) {
      result = Result::kStopped;
      break;
    }
    if (evaluated > most_states || (most_bytes > 0 && bytes() > most_bytes)) {
      result = evaluated > most_states ? Result::kLimit : Result::kMemory;
      break;
    }
    if (entry.action < 0) {
      if (const std::int32_t goal = expand(entry.parent); goal >= 0) {
        extract(goal);
        result = Result::kFound;
        break;
      }
      continue;
    }
    const GroundAction& action = task.actions[static_cast<std::size_t>(entry.action)];
    const std::int64_t g = nodes_[static_cast<std::size_t>(entry.parent)].g + action.cost;
    if (g >= upper_bound) continue;
    apply_action(task, states_.state(entry.parent), action, next_.data());
    if (pruning.dead.dead_after(task, action, next_.data())) continue;
    const std::int32_t id = pruning.add(states_, next_.data(), key_, &is_new);
    ++statistics.generated;
    if (is_new) nodes_.push_back({entry.parent, entry.action, g, false});
    if (nodes_[static_cast<std::size_t>(id)].opened) continue;
    if (const std::int32_t goal = open(id); goal >= 0) {
      extract(goal);
      result = Result::kFound;
      break;
    }
  }
  statistics.evaluated += evaluated;
  statistics.peak_bytes = std::max(statistics.peak_bytes, bytes());
  return result;
}

}  // namespace goalnet::planner
