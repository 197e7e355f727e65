#include "components/ros/managed_component.h"

#include <fmt/format.h>

namespace goalnet::ros {
namespace {

constexpr const char* kAutostart = "autostart";

}  // namespace

ManagedComponent::ManagedComponent(Node& node) : node_(node) {}
ManagedComponent::~ManagedComponent() = default;

LifecycleState ManagedComponent::state() const {
  return lifecycle_ ? lifecycle_->state() : LifecycleState::kUnconfigured;
}

Expected<void> ManagedComponent::begin() {
  declare();
  const auto autostart = node_.declare_parameter<bool>(
      kAutostart, true,
      {.description =
           "configure and activate at start; false: a lifecycle manager or ros2 lifecycle set does",
       .read_only = true});
  if (!autostart) return tl::unexpected<Error>(autostart.error());
  lifecycle_ = std::make_unique<Lifecycle>(
      node_,
      LifecycleCallbacks{
          .on_configure = [this] { return run("configure", &ManagedComponent::configure_with_parameters); },
          .on_activate = [this] { return run("activate", &ManagedComponent::on_activate); },
          .on_deactivate = [this] { return run("deactivate", &ManagedComponent::on_deactivate); },
          .on_cleanup = [this] { return run("cleanup", &ManagedComponent::on_cleanup); },
          .on_shutdown = [this](LifecycleState) { return run("shutdown", &ManagedComponent::let_go); },
          .on_error = [this](LifecycleState) { return run("error processing", &ManagedComponent::let_go); }});
  diagnostics_ = std::make_unique<Diagnostics>(node_);
  diagnostics_->add("state", [this](DiagnosticReport& report) { diagnose(report); });
  if (!*autostart) return {};
  log_failures_ = false;  // whoever made us tells it
  auto done = configure();
  if (done) done = activate();
  log_failures_ = true;
  return done;
}

// A value that makes no sense is replaced by the default, and remembered: configure fails with it.
void ManagedComponent::declare() {
  Parameters& parameters = node_.parameters();
  parameters.add_validator(
      [this, alive = std::weak_ptr<bool>(alive_)](const std::vector<Parameter>& values) -> Expected<void> {
        return alive.expired() ? Expected<void>() : check(values);
      });
  parameters.add_observer([this, alive = std::weak_ptr<bool>(alive_)](const ParameterChange& change) {
    if (!alive.expired()) take(change);
  });
  for (ParameterSet::Row row : parameters_.rows()) {
    row.descriptor.read_only = row.settable == Settable::kAtStart;
    if (row.settable == Settable::kUnconfigured) {
      row.descriptor.additional_constraints += row.descriptor.additional_constraints.empty()
                                                   ? "set while unconfigured"
                                                   : "; set while unconfigured";
    }
    auto declared = parameters.declare(row.name, row.default_value, row.descriptor);
    if (declared) continue;
    faults_[row.name] = declared.error().message;
    parameters.forget_override(row.name);
    declared = parameters.declare(row.name, row.default_value, row.descriptor);
    if (!declared) throw std::logic_error(declared.error().message);
  }
  declared_ = true;
}

Expected<void> ManagedComponent::check(const std::vector<Parameter>& values) const {
  for (const Parameter& parameter : values) {
    const ParameterSet::Row* row = parameters_.find(parameter.name);
    if (row == nullptr) continue;  // the node's own
    if (row->check) {
      if (auto ok = row->check(parameter.value); !ok) {
        // While declaring, the name and the origin are put before it anyway.
        return declared_ ? fail(Outcome::kInvalidRequest,
                                fmt::format("parameter '{}': {}", parameter.name, ok.error().message))
                         : ok;
      }
    }
    if (!declared_ || row->settable != Settable::kUnconfigured || state() == LifecycleState::kUnconfigured)
      continue;
    const ParameterValue* now = node_.parameters().find(parameter.name);
    if (now != nullptr && *now == parameter.value) continue;  // what `ros2 param load` of a dump does
    return fail(
        Outcome::kInvalidRequest,
        fmt::format(
            "parameter '{}' can be set while the node is unconfigured; it is {}: deactivate and clean "
            "it up first",
            parameter.name, label(state())));
  }
  return {};
}

void ManagedComponent::take(const ParameterChange& change) {
  bool live = false;
  for (const Parameter& parameter : change.changed) {
    faults_.erase(parameter.name);
    const ParameterSet::Row* row = parameters_.find(parameter.name);
    if (row == nullptr || row->settable != Settable::kAnyTime) continue;
    row->assign(parameter.value);
    live = true;
  }
  if (live) on_parameter_set();
}

Expected<void> ManagedComponent::configure_with_parameters() {
  if (!faults_.empty()) return fail(Outcome::kInvalidRequest, faults_.begin()->second);
  parameters_.read(node_.parameters());
  auto done = on_configure();
  if (!done) static_cast<void>(on_cleanup());  // nothing half loaded stays
  return done;
}

Expected<void> ManagedComponent::let_go() {
  const auto quiet = on_deactivate();
  auto empty = on_cleanup();
  return quiet ? empty : quiet;
}

TransitionResult ManagedComponent::run(const char* what, Work work) {
  TransitionResult result = TransitionResult::kSuccess;
  try {
    if (auto done = (this->*work)(); !done) {
      last_error_ = std::move(done.error());
      result = TransitionResult::kFailure;
    }
  } catch (const std::exception& error) {
    last_error_ = Error{Outcome::kInternal, error.what()};
    result = TransitionResult::kError;
  }
  if (result != TransitionResult::kSuccess && log_failures_)
    node_.log().error("{} failed: {}", what, last_error_.message);
  if (result == TransitionResult::kSuccess) node_.log().debug("{} done", what);
  return result;
}

Expected<void> ManagedComponent::change(std::string_view transition) {
  if (!find_transition(state(), 0, transition)) {
    return fail(Outcome::kInvalidRequest, fmt::format("{}: there is no transition '{}' in state {}",
                                                      node_.full_name(), transition, label(state())));
  }
  if (lifecycle_->change(0, transition)) return {};
  return tl::unexpected<Error>(last_error_);
}

void ManagedComponent::diagnose(DiagnosticReport& report) {
  report.add("state", std::string(label(state())));
  if (active()) return on_diagnose(report);
  if (state() == LifecycleState::kInactive) return;
  report.summary(
      DiagnosticLevel::kWarn,
      fmt::format("{}{}{}", label(state()), last_error_.message.empty() ? "" : ": ", last_error_.message));
}

}  // namespace goalnet::ros
