// The state machine of managed nodes, as rcl_lifecycle has it: states, transitions, their names. Pure.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace goalnet::ros {

// Numbers of lifecycle_msgs/msg/State.
enum class LifecycleState : std::uint8_t {
  kUnknown = 0,
  kUnconfigured = 1,
  kInactive = 2,
  kActive = 3,
  kFinalized = 4,
  kConfiguring = 10,
  kCleaningUp = 11,
  kShuttingDown = 12,
  kActivating = 13,
  kDeactivating = 14,
  kErrorProcessing = 15,
};

// How a transition's work ended.
enum class TransitionResult : std::uint8_t { kSuccess, kFailure, kError };

struct LifecycleTransition {
  std::uint8_t id;  // of lifecycle_msgs/msg/Transition
  std::string_view label;
  LifecycleState from;
  LifecycleState to;
};

std::string_view label(LifecycleState state);

// All states and transitions, in rcl's order.
std::span<const LifecycleState> all_lifecycle_states();
std::span<const LifecycleTransition> all_lifecycle_transitions();

// The transition that may be asked for in `state`: by label where one is given ("shutdown" means another id
// in each state), else by id.
std::optional<LifecycleTransition> find_transition(LifecycleState state, std::uint8_t id,
                                                   std::string_view label);

// Where a transition state (configuring, ...) leads, by the result of its work.
LifecycleState after(LifecycleState transition_state, TransitionResult result);

}  // namespace goalnet::ros
