// A managed node: configure, activate, deactivate, clean up, shut down, by service or by its own program.
#pragma once

#include <functional>
#include <memory>

#include "components/ros/lifecycle_states.h"
#include "components/ros/node.h"

namespace goalnet::ros {

// The work of each transition; a missing one succeeds. kFailure returns to the state before, kError goes
// through on_error: if that succeeds the node is unconfigured again, else finalized. An exception counts as
// kError.
struct LifecycleCallbacks {
  std::function<TransitionResult()> on_configure;
  std::function<TransitionResult()> on_activate;
  std::function<TransitionResult()> on_deactivate;
  std::function<TransitionResult()> on_cleanup;
  std::function<TransitionResult(LifecycleState from)> on_shutdown;
  std::function<TransitionResult(LifecycleState from)> on_error;  // missing: fails
};

// Offers ~/change_state, get_state, get_available_states, get_available_transitions and get_transition_graph,
// and publishes ~/transition_event. Runs in the node's loop.
class Lifecycle {
 public:
  Lifecycle(Node& node, LifecycleCallbacks callbacks);
  ~Lifecycle();
  Lifecycle(const Lifecycle&) = delete;

  LifecycleState state() const;
  bool active() const { return state() == LifecycleState::kActive; }

  // As ~/change_state: false where the transition is not allowed now, or where its work did not succeed.
  bool change(std::uint8_t id, std::string_view label = {});
  bool configure() { return change(1); }
  bool cleanup() { return change(2); }
  bool activate() { return change(3); }
  bool deactivate() { return change(4); }
  bool shutdown() { return change(0, "shutdown"); }

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace goalnet::ros
