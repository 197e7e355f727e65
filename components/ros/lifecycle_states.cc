#include "components/ros/lifecycle_states.h"

#include <algorithm>
#include <array>

namespace goalnet::ros {
namespace {

using State = LifecycleState;

constexpr std::array kStates = {State::kUnknown,      State::kUnconfigured,   State::kInactive,
                                State::kActive,       State::kFinalized,      State::kConfiguring,
                                State::kCleaningUp,   State::kShuttingDown,   State::kActivating,
                                State::kDeactivating, State::kErrorProcessing};

constexpr std::string_view kSuccess = "transition_success";
constexpr std::string_view kFailure = "transition_failure";
constexpr std::string_view kError = "transition_error";

constexpr std::array<LifecycleTransition, 25> kTransitions = {{
    {1, "configure", State::kUnconfigured, State::kConfiguring},
    {10, kSuccess, State::kConfiguring, State::kInactive},
    {11, kFailure, State::kConfiguring, State::kUnconfigured},
    {12, kError, State::kConfiguring, State::kErrorProcessing},
    {2, "cleanup", State::kInactive, State::kCleaningUp},
    {20, kSuccess, State::kCleaningUp, State::kUnconfigured},
    {21, kFailure, State::kCleaningUp, State::kInactive},
    {22, kError, State::kCleaningUp, State::kErrorProcessing},
    {3, "activate", State::kInactive, State::kActivating},
    {30, kSuccess, State::kActivating, State::kActive},
    {31, kFailure, State::kActivating, State::kInactive},
    {32, kError, State::kActivating, State::kErrorProcessing},
    {4, "deactivate", State::kActive, State::kDeactivating},
    {40, kSuccess, State::kDeactivating, State::kInactive},
    {41, kFailure, State::kDeactivating, State::kActive},
    {42, kError, State::kDeactivating, State::kErrorProcessing},
    {5, "shutdown", State::kUnconfigured, State::kShuttingDown},
    {6, "shutdown", State::kInactive, State::kShuttingDown},
    {7, "shutdown", State::kActive, State::kShuttingDown},
    {50, kSuccess, State::kShuttingDown, State::kFinalized},
    {51, kFailure, State::kShuttingDown, State::kFinalized},
    {52, kError, State::kShuttingDown, State::kErrorProcessing},
    {60, kSuccess, State::kErrorProcessing, State::kUnconfigured},
    {61, kFailure, State::kErrorProcessing, State::kFinalized},
    {62, kError, State::kErrorProcessing, State::kFinalized},
}};

}  // namespace

std::string_view label(LifecycleState state) {
  switch (state) {
    case State::kUnknown:
      return "unknown";
    case State::kUnconfigured:
      return "unconfigured";
    case State::kInactive:
      return "inactive";
    case State::kActive:
      return "active";
    case State::kFinalized:
      return "finalized";
    case State::kConfiguring:
      return "configuring";
    case State::kCleaningUp:
      return "cleaningup";
    case State::kShuttingDown:
      return "shuttingdown";
    case State::kActivating:
      return "activating";
    case State::kDeactivating:
      return "deactivating";
    case State::kErrorProcessing:
      return "errorprocessing";
  }
  return "unknown";
}

std::span<const LifecycleState> all_lifecycle_states() { return kStates; }
std::span<const LifecycleTransition> all_lifecycle_transitions() { return kTransitions; }

std::optional<LifecycleTransition> find_transition(LifecycleState state, std::uint8_t id,
                                                   std::string_view name) {
  const auto found =
      std::find_if(kTransitions.begin(), kTransitions.end(), [&](const LifecycleTransition& one) {
        // Ids from 10 on are results of work: nobody may ask for them.
        return one.from == state && one.id < 10 && (name.empty() ? one.id == id : one.label == name);
      });
  return found == kTransitions.end() ? std::nullopt : std::optional(*found);
}

LifecycleState after(LifecycleState transition_state, TransitionResult result) {
  const auto wanted = static_cast<std::uint8_t>(result);
  const auto found =
      std::find_if(kTransitions.begin(), kTransitions.end(), [&](const LifecycleTransition& one) {
        return one.from == transition_state && one.id >= 10 && one.id % 10 == wanted;
      });
  return found == kTransitions.end() ? State::kUnknown : found->to;
}

}  // namespace goalnet::ros
