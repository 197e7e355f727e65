#include "components/planner/landmark_search.h"

#include <algorithm>

namespace goalnet::planner {
namespace {
constexpr std::int64_t kBoost = 1000;  // how long preferred actions are favoured after progress
}  // namespace

void LandmarkSearch::push(Queue& queue, std::int64_t h, std::int32_t parent, std::int32_t action) {
  queue.heap.push({h, serial_++, parent, action});
}

bool LandmarkSearch::pop(Entry* entry) {
  Queue* best = nullptr;
  for (Queue& queue : queues_) {
    if (!queue.heap.empty() && (best == nullptr || queue.priority < best->priority)) best = &queue;
  }
  if (best == nullptr) return false;
  ++best->priority;
  *entry = best->heap.pop();
  return true;
}

std::int64_t LandmarkSearch::bytes() const {
  std::size_t entries = 0;
  for (const Queue& queue : queues_) entries += queue.heap.bytes();
  return states_.bytes() + static_cast<std::int64_t>(entries + nodes_.bytes() + reached_.bytes());
}

// Evaluates a state and queues its successors.
void LandmarkSearch::open(const GroundTask& task, RelaxedPlanner& heuristic, Landmarks& landmarks,
                          std::int32_t id, Budget& budget, Statistics& statistics) {
  ++statistics.evaluated;
  const std::int64_t by_plan = heuristic.evaluate(states_.state(id), budget);
  if (by_plan >= RelaxedPlanner::kDeadEnd || budget.stopped()) return;
  const std::int64_t by_landmarks = landmarks.missing(states_.state(id), reached(id));
  ++statistics.expanded;
  const auto progress = [this](std::int64_t h, std::int64_t& best) {
    if (h >= best) return;
    best = h;
    queues_[kByPlanPreferred].priority -= kBoost;
    queues_[kByLandmarksPreferred].priority -= kBoost;
  };
  progress(by_plan, best_by_plan_);
  progress(by_landmarks, best_by_landmarks_);
  for (const std::int32_t action : heuristic.actions()) preferred_[static_cast<std::size_t>(action)] = 1;
  for (const std::int32_t action : heuristic.applicable()) {
    push(queues_[kByPlan], by_plan, id, action);
    push(queues_[kByLandmarks], by_landmarks, id, action);
    if (preferred_[static_cast<std::size_t>(action)] != 0 ||
        landmarks.leads_on(task.actions[static_cast<std::size_t>(action)])) {
      push(queues_[kByPlanPreferred], by_plan, id, action);
      push(queues_[kByLandmarksPreferred], by_landmarks, id, action);
    }
  }
  for (const std::int32_t action : heuristic.actions()) preferred_[static_cast<std::size_t>(action)] = 0;
}

LandmarkSearch::Result LandmarkSearch::search(const GroundTask& task, RelaxedPlanner& heuristic,
                                              Landmarks& landmarks, const Word* initial,
                                              std::int64_t upper_bound, std::int64_t most_states,
                                              std::int64_t most_bytes, Budget& budget, Statistics& statistics,
                                              const Pruning& pruning) {
  const std::size_t words = std::max<std::size_t>(task.words(), 1);
  pruning.restart(states_, words);
  nodes_.clear();
  for (Queue& queue : queues_) {
    queue.heap.clear();
    queue.priority = 0;
  }
  landmark_words_ = landmarks.words();
  reached_.restart(landmark_words_);
  next_reached_.assign(landmark_words_, 0);
  next_.resize(words);
  preferred_.assign(task.actions.size(), 0);
  serial_ = 0;
  best_by_plan_ = best_by_landmarks_ = INT64_MAX;
  plan_.clear();
  const std::int64_t last =
      most_states < INT64_MAX - statistics.evaluated ? statistics.evaluated + most_states : INT64_MAX;
  bool is_new = false;
  pruning.add(states_, initial, key_, &is_new);
  nodes_.push_back({});
  landmarks.note(initial, next_reached_.data());
  reached_.push_back(next_reached_.data());
  open(task, heuristic, landmarks, 0, budget, statistics);
  Result result = Result::kExhausted;
  Entry entry{};
  while (pop(&entry)) {
    if (budget.poll()) {
      result = Result::kStopped;
      break;
    }
    if (statistics.evaluated > last || (most_bytes > 0 && bytes() > most_bytes)) {
      result = statistics.evaluated > last ? Result::kLimit : Result::kMemory;
      break;
    }
    const GroundAction& action = task.actions[static_cast<std::size_t>(entry.action)];
    const std::int64_t g = nodes_[static_cast<std::size_t>(entry.parent)].g + action.cost;
    if (g >= upper_bound) continue;
    apply_action(task, states_.state(entry.parent), action, next_.data());
    ++statistics.generated;
    if (pruning.dead.dead_after(task, action, next_.data())) continue;
    const std::int32_t id = pruning.add(states_, next_.data(), key_, &is_new);
    if (!is_new) continue;
    nodes_.push_back({g, entry.parent, entry.action});
    std::copy_n(reached(entry.parent), landmark_words_, next_reached_.begin());
    landmarks.note(next_.data(), next_reached_.data());
    reached_.push_back(next_reached_.data());
    if (all_hold(task, next_.data(), task.goal)) {
      for (std::int32_t at = id; nodes_[static_cast<std::size_t>(at)].parent >= 0;
           at = nodes_[static_cast<std::size_t>(at)].parent) {
        plan_.push_back(nodes_[static_cast<std::size_t>(at)].action);
      }
      std::reverse(plan_.begin(), plan_.end());
      result = Result::kFound;
      break;
    }
    open(task, heuristic, landmarks, id, budget, statistics);
  }
  if (budget.stopped() && result == Result::kExhausted) result = Result::kStopped;
  statistics.peak_bytes = std::max(statistics.peak_bytes, bytes());
  return result;
}

}  // namespace goalnet::planner
