#include "components/planner/landmark_search.h"

#include <algorithm>

namespace goalnet::planner {
std::int64_t LandmarkSearch::bytes() const {
  return states_.bytes() + static_cast<std::int64_t>(open_.bytes() + nodes_.bytes() + reached_.bytes());
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
    open_.favour(kByPlanPreferred);
    open_.favour(kByLandmarksPreferred);
  };
  progress(by_plan, best_by_plan_);
  progress(by_landmarks, best_by_landmarks_);
  for (const std::int32_t action : heuristic.actions()) preferred_[static_cast<std::size_t>(action)] = 1;
  for (const std::int32_t action : heuristic.applicable()) {
    open_.push(kByPlan, by_plan, id, action);
    open_.push(kByLandmarks, by_landmarks, id, action);
    if (preferred_[static_cast<std::size_t>(action)] != 0 ||
        landmarks.leads_on(task.actions[static_cast<std::size_t>(action)])) {
      open_.push(kByPlanPreferred, by_plan, id, action);
      open_.push(kByLandmarksPreferred, by_landmarks, id, action);
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
  open_.clear();
  landmark_words_ = landmarks.words();
  reached_.restart(landmark_words_);
  next_reached_.assign(landmark_words_, 0);
  next_.resize(words);
  preferred_.assign(task.actions.size(), 0);
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
  OpenEntry entry{};
  while (open_.pop(&entry)) {
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
