// The goals of one action server: their states, which of them a cancel request means, and how long results
// are kept. Pure; action_server.h puts it on DDS.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

#include "components/ros/clock.h"

namespace goalnet::ros {

using GoalId = std::array<std::uint8_t, 16>;  // a UUID, made by the client

// Numbers of action_msgs/msg/GoalStatus.
enum class GoalState : std::int8_t {
  kUnknown = 0,
  kAccepted = 1,
  kExecuting = 2,
  kCanceling = 3,
  kSucceeded = 4,
  kCanceled = 5,
  kAborted = 6,
};

inline bool terminal(GoalState state) { return state >= GoalState::kSucceeded; }

// May a goal go from one state to the other?
bool allowed(GoalState from, GoalState to);

// Numbers of action_msgs/srv/CancelGoal.
enum class CancelCode : std::int8_t { kNone = 0, kRejected = 1, kUnknownGoal = 2, kTerminated = 3 };

class ActionGoals {
 public:
  struct Goal {
    GoalId id{};
    Time accepted;
    GoalState state = GoalState::kAccepted;
    Time finished;
  };

  // `result_timeout`: how long a finished goal is remembered; `capacity`: how many goals at most.
  ActionGoals(std::chrono::nanoseconds result_timeout, std::size_t capacity);

  // False if the id is taken, or all places are held by unfinished goals. Else the oldest finished goals make
  // room.
  bool accept(const GoalId& id, Time now);
  bool can_accept(const GoalId& id) const;
  // False, and nothing changes, for an unknown goal or a change that is not allowed.
  bool set(const GoalId& id, GoalState state, Time now);
  std::optional<GoalState> state(const GoalId& id) const;

  // Goals that a cancel request with this id and stamp means, by the four rules of CancelGoal.srv, in order
  // of acceptance. As in rcl, goals that are finished or being cancelled already are left out; where the
  // request names just such a goal the code is kTerminated.
  struct Selection {
    CancelCode code = CancelCode::kNone;
    std::vector<Goal> goals;
  };
  Selection select_for_cancel(const GoalId& id, Time stamp) const;

  // Forgets finished goals older than the timeout; returns their ids.
  std::vector<GoalId> expire(Time now);

  const std::vector<Goal>& goals() const { return goals_; }  // in order of acceptance

 private:
  Goal* find(const GoalId& id);
  std::chrono::nanoseconds result_timeout_;
  std::size_t capacity_;
  std::vector<Goal> goals_;
};

}  // namespace goalnet::ros
