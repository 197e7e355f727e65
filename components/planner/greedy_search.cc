#include "components/planner/greedy_search.h"

#include <algorithm>

namespace goalnet::planner {
namespace {
constexpr std::int64_t kBoost = 1000;  // how long preferred actions are favoured after progress
}

void GreedySearch::push(Queue& queue, std::int64_t h, std::int32_t parent, std::int32_t action) {
  queue.heap.push_back({h, serial_++, parent, action});
  std::push_heap(queue.heap.begin(), queue.heap.end());
}

bool GreedySearch::pop(Entry* entry) {
  Queue* queue = &all_;
  if (all_.heap.empty() || (!preferred_.heap.empty() && preferred_.priority < all_.priority)) queue = &preferred_;
  if (queue->heap.empty()) return false;
  ++queue->priority;
  std::pop_heap(queue->heap.begin(), queue->heap.end());
  *entry = queue->heap.back();
  queue->heap.pop_back();
  return true;
}

GreedySearch::Result GreedySearch::search(const GroundTask& task, RelaxedPlanner& heuristic, const Word* initial,
                                          std::int64_t upper_bound, std::int64_t most_states, std::int64_t most_bytes,
                                          Budget& budget, Statistics& statistics) {
  const std::size_t words = std::max<std::size_t>(task.words(), 1);
  states_.restart(words, false);
  nodes_.clear();
  all_ = Queue{};
  preferred_ = Queue{};
  serial_ = 0;
  next_.resize(words);
  std::int64_t best_h = INT64_MAX, evaluated = 0;

  // Evaluates a new state and queues its successors; true if it is a goal.
  const auto open = [&](std::int32_t id) {
    const Word* state = states_.state(id);
    if (all_hold(task, state, task.goal)) return true;
    ++evaluated;
    const std::int64_t h = heuristic.evaluate(state, budget);
    if (h >= RelaxedPlanner::kDeadEnd) return false;
    ++statistics.expanded;
    if (h < best_h) {
      best_h = h;
      preferred_.priority -= kBoost;
    }
    for (const std::int32_t action : heuristic.applicable()) push(all_, h, id, action);
    for (const std::int32_t action : heuristic.actions()) {
      if (action_applies(task, states_.state(id), task.actions[static_cast<std::size_t>(action)])) {
        push(preferred_, h, id, action);
      }
    }
    return false;
  };
  const auto extract = [&](std::int32_t id) {
    plan_.clear();
    for (; nodes_[static_cast<std::size_t>(id)].parent >= 0; id = nodes_[static_cast<std::size_t>(id)].parent) {
      plan_.push_back(nodes_[static_cast<std::size_t>(id)].action);
    }
    std::reverse(plan_.begin(), plan_.end());
  };

  bool is_new = false;
  states_.add(initial, initial, &is_new);
  nodes_.push_back({});
  Result result = Result::kExhausted;
  if (open(0)) {
    extract(0);
    return Result::kFound;
  }
  Entry entry{};
  while (pop(&entry)) {
    if (budget.poll()) {
      result = Result::kStopped;
      break;
    }
    const auto bytes = states_.bytes() + static_cast<std::int64_t>((all_.heap.capacity() + preferred_.heap.capacity()) *
                                                                   sizeof(Entry));
    if (evaluated > most_states || (most_bytes > 0 && bytes > most_bytes)) {
      result = Result::kLimit;
      break;
    }
    const GroundAction& action = task.actions[static_cast<std::size_t>(entry.action)];
    const std::int64_t g = nodes_[static_cast<std::size_t>(entry.parent)].g + action.cost;
    if (g >= upper_bound) continue;
    apply_action(task, states_.state(entry.parent), action, next_.data());
    const std::int32_t id = states_.add(next_.data(), next_.data(), &is_new);
    ++statistics.generated;
    if (!is_new) continue;
    nodes_.push_back({entry.parent, entry.action, g});
    if (open(id)) {
      extract(id);
      result = Result::kFound;
      break;
    }
  }
  statistics.evaluated += evaluated;
  statistics.peak_bytes = std::max(
      statistics.peak_bytes,
      states_.bytes() + static_cast<std::int64_t>((all_.heap.capacity() + preferred_.heap.capacity()) * sizeof(Entry) +
                                                  nodes_.capacity() * sizeof(Node)));
  return result;
}

}  // namespace goalnet::planner
