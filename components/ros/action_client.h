// Action clients: send goals, follow their feedback, cancel them, get their results.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <utility>

#include "action_msgs/msg/GoalStatusArray.h"
#include "action_msgs/srv/CancelGoal_service.h"
#include "components/ros/action_goals.h"
#include "components/ros/service.h"

namespace goalnet::ros {

// A random UUID (version 4).
GoalId random_goal_id();

// Used from the loop's thread; callbacks come from there.
template <class Action>
class ActionClient {
 public:
  using SendGoal = typename Action::SendGoal;
  using GetResult = typename Action::GetResult;
  using Cancel = action_msgs::srv::CancelGoal;

  struct GoalCallbacks {
    std::function<void(bool accepted)> on_response;
    std::function<void(const typename Action::Feedback&)> on_feedback;
    // How the goal ended (kSucceeded, kCanceled, kAborted) and its result; kUnknown if the server forgot it.
    // An error (kTimeLimit, kComponentLost) where no answer came.
    std::function<void(Expected<std::pair<GoalState, typename Action::Result>>)> on_result;
    // The state as the server's status topic has it, whenever it changed. States that follow each other
    // quickly may be skipped.
    std::function<void(GoalState)> on_status = {};
  };

  ActionClient(Node& node, const std::string& name)
      : base_(node.resolve(name, RemapKind::kName) + "/_action/"),
        send_goal_(node, base_ + "send_goal"),
        cancel_(node, base_ + "cancel_goal"),
        get_result_(node, base_ + "get_result"),
        feedback_(node.subscribe<typename Action::FeedbackMessage>(
            base_ + "feedback", Qos::standard().keep_last(100),
            [this](const typename Action::FeedbackMessage& message) { on_feedback(message); })),
        status_(node.subscribe<action_msgs::msg::GoalStatusArray>(
            base_ + "status", Qos::latched(),
            [this](const action_msgs::msg::GoalStatusArray& message) { on_status(message); })) {}

  bool wait_for_server(std::chrono::nanoseconds timeout = std::chrono::seconds(5)) const {
    const auto end = std::chrono::steady_clock::now() + timeout;
    const auto left = [&] {
      return std::max<std::chrono::nanoseconds>(end - std::chrono::steady_clock::now(),
                                                std::chrono::nanoseconds(0));
    };
    return send_goal_.wait_for_service(left()) && cancel_.wait_for_service(left()) &&
           get_result_.wait_for_service(left()) && feedback_->wait_for_publishers(1, left());
  }

  // Returns the id of the goal. `result_timeout` counts from acceptance.
  GoalId send(const typename Action::Goal& goal, GoalCallbacks callbacks,
              std::chrono::nanoseconds response_timeout = std::chrono::seconds(10),
              std::chrono::nanoseconds result_timeout = std::chrono::hours(24)) {
    const GoalId id = random_goal_id();
    auto shared = std::make_shared<GoalCallbacks>(std::move(callbacks));
    goals_[id] = {shared};
    typename SendGoal::Request request;
    request.goal_id().uuid(id);
    request.goal(goal);
    send_goal_.call(
        request,
        [this, id, shared, result_timeout](auto response) {
          const bool accepted = response && (*response)->accepted();
          if (shared->on_response) shared->on_response(accepted);
          if (accepted) {
            ask_for_result(id, shared, result_timeout);
          } else {
            goals_.erase(id);
            if (!response && shared->on_result) shared->on_result(tl::unexpected(response.error()));
          }
        },
        response_timeout);
    return id;
  }

  // Cancels that goal; `on_answer` gets the return code, or an error.
  void cancel(const GoalId& id, std::function<void(Expected<CancelCode>)> on_answer = {}) {
    typename Cancel::Request request;
    request.goal_info().goal_id().uuid(id);
    send_cancel(request, std::move(on_answer));
  }
  void cancel_all(std::function<void(Expected<CancelCode>)> on_answer = {}) {
    send_cancel(typename Cancel::Request(), std::move(on_answer));
  }

 private:
  void ask_for_result(const GoalId& id, std::shared_ptr<GoalCallbacks> callbacks,
                      std::chrono::nanoseconds timeout) {
    typename GetResult::Request request;
    request.goal_id().uuid(id);
    get_result_.call(
        request,
        [this, id, callbacks](auto response) {
          goals_.erase(id);
          if (!callbacks->on_result) return;
          if (!response) {
            callbacks->on_result(tl::unexpected(response.error()));
          } else {
            callbacks->on_result(
                std::pair(static_cast<GoalState>((*response)->status()), (*response)->result()));
          }
        },
        timeout);
  }

  void on_feedback(const typename Action::FeedbackMessage& message) {
    const auto found = goals_.find(message.goal_id().uuid());
    if (found == goals_.end()) return;
    const auto callbacks = found->second.callbacks;  // may end while it is called
    if (callbacks->on_feedback) callbacks->on_feedback(message.feedback());
  }

  void on_status(const action_msgs::msg::GoalStatusArray& message) {
    for (const auto& one : message.status_list()) {
      const auto found = goals_.find(one.goal_info().goal_id().uuid());
      const auto state = static_cast<GoalState>(one.status());
      if (found == goals_.end() || found->second.state == state) continue;
      found->second.state = state;
      const auto callbacks = found->second.callbacks;  // may end while it is called
      if (callbacks->on_status) callbacks->on_status(state);
    }
  }

  void send_cancel(const typename Cancel::Request& request,
                   std::function<void(Expected<CancelCode>)> on_answer) {
    cancel_.call(request, [on_answer = std::move(on_answer)](auto response) {
      if (!on_answer) return;
      if (!response) {
        on_answer(tl::unexpected(response.error()));
      } else {
        on_answer(static_cast<CancelCode>((*response)->return_code()));
      }
    });
  }

  struct Entry {
    std::shared_ptr<GoalCallbacks> callbacks;
    GoalState state = GoalState::kUnknown;  // as last told by the status topic
  };
  std::string base_;
  std::map<GoalId, Entry> goals_;
  Client<SendGoal> send_goal_;
  Client<Cancel> cancel_;
  Client<GetResult> get_result_;
  std::shared_ptr<Subscription<typename Action::FeedbackMessage>> feedback_;
  std::shared_ptr<Subscription<action_msgs::msg::GoalStatusArray>> status_;
};

}  // namespace goalnet::ros
