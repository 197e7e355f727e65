// What the shell of every component derives from: a managed (lifecycle) node with a table of parameters.
//
//   unconfigured ── configure: load files, check ──► inactive ── activate: open topics, work ──► active
//        ▲                cleanup: let go ◄──────────┘  ▲──────── deactivate: stop, fall silent ◄──┘
//
// A transition that fails leaves the node where it was, says why in one message, and may be tried again, for
// example after `ros2 param set`. An exception counts as an error: everything is let go and the node is
// unconfigured. Values from files and -p that make no sense do not end the node either: configure fails with
// them until they are set right. The parameter autostart (default true) configures and activates at creation;
// false leaves that to others.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>

#include "components/ros/diagnostics.h"
#include "components/ros/lifecycle.h"
#include "components/ros/node.h"
#include "components/ros/parameter_set.h"

namespace goalnet::ros {

// Belongs to the thread of the node's event loop. The node must outlive it.
class ManagedComponent : public Component {
 public:
  ~ManagedComponent() override;
  ManagedComponent(const ManagedComponent&) = delete;

  LifecycleState state() const;
  bool active() const { return state() == LifecycleState::kActive; }

  // As the service change_state does, but with the reason where it fails: kInvalidRequest for a transition
  // that is not allowed now, else what the work said.
  Expected<void> configure() { return change("configure"); }
  Expected<void> activate() { return change("activate"); }
  Expected<void> deactivate() { return change("deactivate"); }
  Expected<void> cleanup() { return change("cleanup"); }
  Expected<void> shutdown() { return change("shutdown"); }

  // From any thread: ends a long computation under way, with kCancelled, so that the loop is free again.
  virtual void interrupt() {}

  const ParameterSet& parameters() const { return parameters_; }

  // Declares the parameters, offers the lifecycle services and starts by itself where autostart says so.
  // Once, after construction; an error means that autostart failed (or the node cannot be used), and the
  // component is to be dropped.
  Expected<void> begin();

 protected:
  // Derived constructors fill `parameters_`; members bound there have the node's values from configure on.
  explicit ManagedComponent(Node& node);

  // Called in this order of life; on_deactivate() and on_cleanup() also after errors, so they must bear being
  // called in any state, and again. on_deactivate() fails where work cannot be stopped; it is not asked twice
  // at shutdown.
  virtual Expected<void> on_configure() = 0;
  virtual Expected<void> on_activate() = 0;
  virtual Expected<void> on_deactivate() = 0;
  virtual Expected<void> on_cleanup() = 0;
  // A parameter that may be set at any time was set; its member has the new value.
  virtual void on_parameter_set() {}

  // Once a second while active, for /diagnostics: how the work goes.
  virtual void on_diagnose(DiagnosticReport&) {}

  Node& node_;
  ParameterSet parameters_;

 private:
  using Work = Expected<void> (ManagedComponent::*)();
  Expected<void> change(std::string_view transition);
  Expected<void> configure_with_parameters();
  Expected<void> let_go();
  TransitionResult run(const char* what, Work work);
  void declare();
  Expected<void> check(const std::vector<Parameter>& values) const;
  void take(const ParameterChange& change);
  void diagnose(DiagnosticReport& report);

  std::map<std::string, std::string> faults_;  // parameters with values that make no sense, and why
  Error last_error_;                           // of the last transition that failed
  bool declared_ = false;
  bool log_failures_ = true;
  std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);  // the node's parameters outlive us
  std::unique_ptr<Diagnostics> diagnostics_;
  std::unique_ptr<Lifecycle> lifecycle_;
};

// begin() for a new component of any kind, as their create() functions need it.
template <class Made>
Expected<std::unique_ptr<Made>> started(std::unique_ptr<Made> component) {
  if (auto begun = component->begin(); !begun) return tl::unexpected<Error>(std::move(begun.error()));
  return component;
}

}  // namespace goalnet::ros
