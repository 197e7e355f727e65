#include "components/ros/action_goals.h"

#include <algorithm>
#include <cstring>
#include <random>

#include "components/ros/action_client.h"

namespace goalnet::ros {

GoalId random_goal_id() {
  static thread_local std::random_device device;
  GoalId id;
  for (std::size_t i = 0; i < id.size(); i += 4) {
    const std::uint32_t word = device();
    std::memcpy(id.data() + i, &word, 4);
  }
  id[6] = static_cast<std::uint8_t>((id[6] & 0x0f) | 0x40);  // version 4
  id[8] = static_cast<std::uint8_t>((id[8] & 0x3f) | 0x80);
  return id;
}

bool allowed(GoalState from, GoalState to) {
  switch (to) {
    case GoalState::kExecuting:
      return from == GoalState::kAccepted;
    case GoalState::kCanceling:
      return from == GoalState::kAccepted || from == GoalState::kExecuting;
    case GoalState::kSucceeded:
    case GoalState::kAborted:
      return from == GoalState::kExecuting || from == GoalState::kCanceling;
    case GoalState::kCanceled:
      return from == GoalState::kCanceling;
    default:
      return false;
  }
}

ActionGoals::ActionGoals(std::chrono::nanoseconds result_timeout, std::size_t capacity)
    : result_timeout_(result_timeout), capacity_(capacity) {}

ActionGoals::Goal* ActionGoals::find(const GoalId& id) {
  const auto found =
      std::find_if(goals_.begin(), goals_.end(), [&](const Goal& goal) { return goal.id == id; });
  return found == goals_.end() ? nullptr : &*found;
}

bool ActionGoals::can_accept(const GoalId& id) const {
  if (state(id)) return false;
  return goals_.size() < capacity_ ||
         std::any_of(goals_.begin(), goals_.end(), [](const Goal& goal) { return terminal(goal.state); });
}

bool ActionGoals::accept(const GoalId& id, Time now) {
  if (!can_accept(id)) return false;
  if (goals_.size() >= capacity_) {
    const auto oldest =
        std::find_if(goals_.begin(), goals_.end(), [](const Goal& goal) { return terminal(goal.state); });
    goals_.erase(oldest);
  }
  goals_.push_back({id, now, GoalState::kAccepted, Time()});
  return true;
}

bool ActionGoals::set(const GoalId& id, GoalState state, Time now) {
  Goal* goal = find(id);
  if (goal == nullptr || !allowed(goal->state, state)) return false;
  goal->state = state;
  if (terminal(state)) goal->finished = now;
  return true;
}

std::optional<GoalState> ActionGoals::state(const GoalId& id) const {
  const auto found =
      std::find_if(goals_.begin(), goals_.end(), [&](const Goal& goal) { return goal.id == id; });
  return found == goals_.end() ? std::nullopt : std::optional(found->state);
}

ActionGoals::Selection ActionGoals::select_for_cancel(const GoalId& id, Time stamp) const {
  Selection selection;
  const bool any_id = id == GoalId{};
  const bool any_time = stamp.nanoseconds == 0;
  if (!any_id && any_time) {
    const auto named = state(id);
    if (!named) return {CancelCode::kUnknownGoal, {}};
    if (!allowed(*named, GoalState::kCanceling)) return {CancelCode::kTerminated, {}};
  }
  for (const Goal& goal : goals_) {
    if (!allowed(goal.state, GoalState::kCanceling)) continue;
    const bool by_time = any_time ? any_id : goal.accepted <= stamp;
    if (by_time || (!any_id && goal.id == id)) selection.goals.push_back(goal);
  }
  return selection;
}

std::vector<GoalId> ActionGoals::expire(Time now) {
  std::vector<GoalId> gone;
  std::erase_if(goals_, [&](const Goal& goal) {
    if (!terminal(goal.state) || now - goal.finished < result_timeout_) return false;
    gone.push_back(goal.id);
    return true;
  });
  return gone;
}

}  // namespace goalnet::ros
