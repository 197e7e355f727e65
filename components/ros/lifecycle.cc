#include "components/ros/lifecycle.h"

#include "components/ros/log_limit.h"
#include "components/ros/service.h"
#include "lifecycle_msgs/msg/TransitionEvent.h"
#include "lifecycle_msgs/srv/ChangeState_service.h"
#include "lifecycle_msgs/srv/GetAvailableStates_service.h"
#include "lifecycle_msgs/srv/GetAvailableTransitions_service.h"
#include "lifecycle_msgs/srv/GetState_service.h"

namespace goalnet::ros {
namespace {

namespace lifecycle_srv = lifecycle_msgs::srv;

lifecycle_msgs::msg::State to_message(LifecycleState state) {
  lifecycle_msgs::msg::State message;
  message.id(static_cast<std::uint8_t>(state));
  message.label(std::string(label(state)));
  return message;
}

lifecycle_msgs::msg::TransitionDescription to_message(const LifecycleTransition& transition) {
  lifecycle_msgs::msg::TransitionDescription message;
  message.transition().id(transition.id);
  message.transition().label(std::string(transition.label));
  message.start_state(to_message(transition.from));
  message.goal_state(to_message(transition.to));
  return message;
}

}  // namespace

struct Lifecycle::Impl {
  Node& node;
  LifecycleCallbacks callbacks;
  LifecycleState state = LifecycleState::kUnconfigured;
  std::shared_ptr<Publisher<lifecycle_msgs::msg::TransitionEvent>> events;
  std::unique_ptr<Server<lifecycle_srv::ChangeState>> change_state;
  std::unique_ptr<Server<lifecycle_srv::GetState>> get_state;
  std::unique_ptr<Server<lifecycle_srv::GetAvailableStates>> get_states;
  std::unique_ptr<Server<lifecycle_srv::GetAvailableTransitions>> get_transitions;
  std::unique_ptr<Server<lifecycle_srv::GetAvailableTransitions>> get_graph;
  LogLimit refusals;

  Impl(Node& n, LifecycleCallbacks c) : node(n), callbacks(std::move(c)) {}

  void enter(LifecycleState next) {
    lifecycle_msgs::msg::TransitionEvent event;  // timestamp and transition stay zero, as in rclcpp and rclpy
    event.start_state(to_message(state));
    event.goal_state(to_message(next));
    state = next;
    events->publish(event);
  }

  TransitionResult work(LifecycleState from) {
    const auto run = [](const auto& callback, auto... arguments) {
      return callback ? callback(arguments...) : TransitionResult::kSuccess;
    };
    try {
      switch (state) {
        case LifecycleState::kConfiguring:
          return run(callbacks.on_configure);
        case LifecycleState::kActivating:
          return run(callbacks.on_activate);
        case LifecycleState::kDeactivating:
          return run(callbacks.on_deactivate);
        case LifecycleState::kCleaningUp:
          return run(callbacks.on_cleanup);
        case LifecycleState::kShuttingDown:
          return run(callbacks.on_shutdown, from);
        case LifecycleState::kErrorProcessing:
          return callbacks.on_error ? callbacks.on_error(from) : TransitionResult::kFailure;
        default:
          return TransitionResult::kError;
      }
    } catch (const std::exception& error) {
      node.log().error("{} ended by an exception: {}", label(state), error.what());
      return TransitionResult::kError;
    }
  }

  bool change(std::uint8_t id, std::string_view name) {
    const auto transition = find_transition(state, id, name);
    if (!transition) {
      // Whoever asks in a loop is answered every time, but not written down every time.
      refusals.write([&](const std::string& more) {
        node.log().warn("transition {} '{}' is not possible in state {}{}", id, name.substr(0, 60),
                        label(state), more);
      });
      return false;
    }
    const LifecycleState from = state;
    enter(transition->to);
    const TransitionResult result = work(from);
    enter(after(state, result));
    if (state == LifecycleState::kErrorProcessing) enter(after(state, work(from)));
    return result == TransitionResult::kSuccess;
  }
};

Lifecycle::Lifecycle(Node& node, LifecycleCallbacks callbacks)
    : impl_(std::make_unique<Impl>(node, std::move(callbacks))) {
  Impl* impl = impl_.get();  // the servers below die with it
  impl->events = node.advertise<lifecycle_msgs::msg::TransitionEvent>("~/transition_event", Qos::standard());
  impl->change_state = std::make_unique<Server<lifecycle_srv::ChangeState>>(
      node, "~/change_state", [impl](const auto& request, auto& response) {
        response.success(impl->change(request.transition().id(), request.transition().label()));
      });
  impl->get_state = std::make_unique<Server<lifecycle_srv::GetState>>(
      node, "~/get_state",
      [impl](const auto&, auto& response) { response.current_state(to_message(impl->state)); });
  impl->get_states = std::make_unique<Server<lifecycle_srv::GetAvailableStates>>(
      node, "~/get_available_states", [](const auto&, auto& response) {
        for (const LifecycleState state : all_lifecycle_states())
          response.available_states().push_back(to_message(state));
      });
  impl->get_transitions = std::make_unique<Server<lifecycle_srv::GetAvailableTransitions>>(
      node, "~/get_available_transitions", [impl](const auto&, auto& response) {
        for (const auto& one : all_lifecycle_transitions()) {
          if (one.from == impl->state) response.available_transitions().push_back(to_message(one));
        }
      });
  impl->get_graph = std::make_unique<Server<lifecycle_srv::GetAvailableTransitions>>(
      node, "~/get_transition_graph", [](const auto&, auto& response) {
        for (const auto& one : all_lifecycle_transitions())
          response.available_transitions().push_back(to_message(one));
      });
}

Lifecycle::~Lifecycle() = default;
LifecycleState Lifecycle::state() const { return impl_->state; }
bool Lifecycle::change(std::uint8_t id, std::string_view name) { return impl_->change(id, name); }

}  // namespace goalnet::ros
