// Action servers: goals with feedback, cancelling and results. #include "PKG/action/NAME_action.h" and say
// ActionServer<goalnet_msgs::action::FollowInstruction>.
//
//   ActionServer<A> server(node, "follow_instruction", {
//       .on_goal = [&](const GoalId&, const A::Goal& goal) { return GoalResponse::kExecute; },
//       .on_accepted = [&](std::shared_ptr<GoalHandle<A>> goal) { keep it; start working; },
//       .on_cancel = [&](GoalHandle<A>&) { stop soon, then call canceled(result); return true; }});
//
// Everything runs in the node's loop thread.
#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "action_msgs/msg/GoalStatusArray.h"
#include "action_msgs/srv/CancelGoal_service.h"
#include "components/ros/action_goals.h"
#include "components/ros/service.h"

namespace goalnet::ros {

enum class GoalResponse {
  kReject,
  kExecute,  // accept; the goal is EXECUTING from the start
  kDefer,    // accept; stays ACCEPTED until its handle's execute()
};

struct ActionServerOptions {
  std::chrono::nanoseconds result_timeout = std::chrono::minutes(15);  // on the node's clock
  std::size_t capacity = 100;  // goals known at once, finished ones included
};

template <class Action>
class ActionServer;

// One accepted goal. Exactly one of succeed(), abort() and canceled() must end it; a handle that is dropped
// before aborts its goal. Calls that the state does not allow return false and change nothing.
template <class Action>
class GoalHandle {
 public:
  using Core = typename ActionServer<Action>::Core;
  GoalHandle(std::shared_ptr<Core> core, const GoalId& id,
             std::shared_ptr<const typename Action::SendGoal::Request> request)
      : core_(std::move(core)), id_(id), request_(std::move(request)) {}
  ~GoalHandle() {
    if (active()) abort({});
  }
  GoalHandle(const GoalHandle&) = delete;

  const GoalId& id() const { return id_; }
  const typename Action::Goal& goal() const { return request_->goal(); }
  GoalState state() const { return core_->goals.state(id_).value_or(GoalState::kUnknown); }
  bool active() const { return state() != GoalState::kUnknown && !terminal(state()); }
  bool canceling() const { return state() == GoalState::kCanceling; }

  bool execute() { return core_->set(id_, GoalState::kExecuting); }
  void publish_feedback(const typename Action::Feedback& feedback) {
    typename Action::FeedbackMessage message;
    message.goal_id().uuid(id_);
    message.feedback(feedback);
    core_->feedback->publish(message);
  }
  bool succeed(const typename Action::Result& result) {
    return core_->finish(id_, GoalState::kSucceeded, result);
  }
  bool abort(const typename Action::Result& result) {
    if (state() == GoalState::kAccepted) execute();
    return core_->finish(id_, GoalState::kAborted, result);
  }
  bool canceled(const typename Action::Result& result) {
    if (!canceling()) core_->set(id_, GoalState::kCanceling);  // the server itself decided to stop
    return core_->finish(id_, GoalState::kCanceled, result);
  }

 private:
  std::shared_ptr<Core> core_;
  GoalId id_;
  std::shared_ptr<const typename Action::SendGoal::Request> request_;
};

template <class Action>
class ActionServer {
 public:
  using SendGoal = typename Action::SendGoal;
  using GetResult = typename Action::GetResult;
  using Cancel = action_msgs::srv::CancelGoal;
  struct Callbacks {
    std::function<GoalResponse(const GoalId& id, const typename Action::Goal& goal)> on_goal;
    std::function<void(std::shared_ptr<GoalHandle<Action>> goal)> on_accepted;
    // True: the goal is being cancelled (CANCELING); end it soon. False: it goes on.
    std::function<bool(GoalHandle<Action>& goal)> on_cancel;
    // Optional: a cancel request has arrived, seen in a thread of DDS while the loop may be busy. on_cancel
    // follows.
    std::function<void(const GoalId& id, Time stamp)> on_cancel_arrived = {};
  };

  // What handles and server share; internal.
  struct Core {
    Core(Node& n, const ActionServerOptions& options)
        : node(n), goals(options.result_timeout, options.capacity) {}
    bool set(const GoalId& id, GoalState state) {
      if (!open || !goals.set(id, state, node.now())) return false;
      publish_status();
      return true;
    }
    bool finish(const GoalId& id, GoalState state, const typename Action::Result& result) {
      if (!open || !goals.set(id, state, node.now())) return false;
      typename GetResult::Response response;
      response.status(static_cast<std::int8_t>(state));
      response.result(result);
      publish_status();  // before the result, as rclcpp and rclpy do: with it, clients forget the goal
      const auto waiting = waiters.equal_range(id);
      for (auto it = waiting.first; it != waiting.second; ++it) it->second.send(response);
      waiters.erase(id);
      results[id] = std::move(response);
      return true;
    }
    void publish_status() {
      action_msgs::msg::GoalStatusArray message;
      for (const ActionGoals::Goal& goal : goals.goals()) {
        action_msgs::msg::GoalStatus one;
        one.goal_info().goal_id().uuid(goal.id);
        one.goal_info().stamp(goal.accepted.to_msg());
        one.status(static_cast<std::int8_t>(goal.state));
        message.status_list().push_back(one);
      }
      status->publish(message);
    }
    void expire() {
      for (const GoalId& id : goals.expire(node.now())) {
        results.erase(id);
        handles.erase(id);
      }
      std::erase_if(results, [this](const auto& entry) { return !goals.state(entry.first); });
      std::erase_if(handles, [](const auto& entry) { return entry.second.expired(); });
    }

    Node& node;
    bool open = true;  // false once the server is gone
    ActionGoals goals;
    std::map<GoalId, typename GetResult::Response> results;
    std::multimap<GoalId, Responder<GetResult>> waiters;
    std::map<GoalId, std::weak_ptr<GoalHandle<Action>>> handles;
    std::shared_ptr<Publisher<typename Action::FeedbackMessage>> feedback;
    std::shared_ptr<Publisher<action_msgs::msg::GoalStatusArray>> status;
  };

  ActionServer(Node& node, const std::string& name, Callbacks callbacks,
               const ActionServerOptions& options = {})
      : callbacks_(std::move(callbacks)), core_(std::make_shared<Core>(node, options)) {
    const std::string base = node.resolve(name, RemapKind::kName) + "/_action/";
    // In rcl's order, so that both sides list the same.
    send_goal_ = Server<SendGoal>::deferred(node, base + "send_goal", [this](auto request, auto responder) {
      take_goal(std::move(request), std::move(responder));
    });
    cancel_ = std::make_unique<Server<Cancel>>(
        node, base + "cancel_goal",
        [this](const auto& request, auto& response) { cancel(request, response); });
    if (callbacks_.on_cancel_arrived) {
      cancel_->set_glance([arrived = callbacks_.on_cancel_arrived](const Cancel::Request& request) {
        arrived(request.goal_info().goal_id().uuid(), Time(request.goal_info().stamp()));
      });
    }
    get_result_ =
        Server<GetResult>::deferred(node, base + "get_result", [this](auto request, auto responder) {
          give_result(request->goal_id().uuid(), std::move(responder));
        });
    core_->feedback = node.advertise<typename Action::FeedbackMessage>(base + "feedback", Qos::standard());
    core_->status = node.advertise<action_msgs::msg::GoalStatusArray>(base + "status", Qos::latched());
    expiry_ = node.create_timer(std::chrono::seconds(1), [core = core_] { core->expire(); });
  }
  ~ActionServer() {
    cancel_->set_glance({});
    core_->open = false;
  }
  ActionServer(const ActionServer&) = delete;

  // Waits until the results given so far have reached who asked for them: before the server goes.
  bool wait_for_acknowledgments(std::chrono::nanoseconds timeout) {
    return get_result_->wait_for_acknowledgments(timeout);
  }

 private:
  void take_goal(std::shared_ptr<const typename SendGoal::Request> request, Responder<SendGoal> responder) {
    const GoalId id = request->goal_id().uuid();
    typename SendGoal::Response response;
    const Time now = core_->node.now();
    response.stamp(now.to_msg());
    core_->expire();
    // Who is asked may begin at once: not with a goal that would be refused all the same.
    const GoalResponse answer = !core_->goals.can_accept(id) || !callbacks_.on_goal
                                    ? GoalResponse::kReject
                                    : callbacks_.on_goal(id, request->goal());
    if (answer == GoalResponse::kReject || !core_->goals.accept(id, now)) {
      responder.send(response);
      return;
    }
    response.accepted(true);
    responder.send(response);
    auto handle = std::make_shared<GoalHandle<Action>>(core_, id, std::move(request));
    core_->handles[id] = handle;
    if (answer == GoalResponse::kExecute) {
      handle->execute();
    } else {
      core_->publish_status();
    }
    callbacks_.on_accepted(std::move(handle));
  }

  void cancel(const typename Cancel::Request& request, typename Cancel::Response& response) {
    const auto selection = core_->goals.select_for_cancel(request.goal_info().goal_id().uuid(),
                                                          Time(request.goal_info().stamp()));
    response.return_code(static_cast<std::int8_t>(selection.code));
    for (const ActionGoals::Goal& goal : selection.goals) {
      const auto handle = core_->handles[goal.id].lock();
      if (!handle) continue;
      if (!callbacks_.on_cancel || !callbacks_.on_cancel(*handle)) continue;
      // The callback may have ended the goal at once: then it passed through CANCELING all the same.
      core_->set(goal.id, GoalState::kCanceling);
      action_msgs::msg::GoalInfo info;
      info.goal_id().uuid(goal.id);
      info.stamp(goal.accepted.to_msg());
      response.goals_canceling().push_back(info);
    }
    if (!selection.goals.empty() && response.goals_canceling().empty()) {
      response.return_code(static_cast<std::int8_t>(CancelCode::kRejected));
    }
  }

  void give_result(const GoalId& id, Responder<GetResult> responder) {
    constexpr std::size_t kMostWaiters = 1000;
    const auto done = core_->results.find(id);
    if (done != core_->results.end()) {
      responder.send(done->second);
    } else if (!core_->goals.state(id) || core_->waiters.size() >= kMostWaiters) {
      responder.send({});  // status 0: unknown
    } else {
      core_->waiters.emplace(id, std::move(responder));
    }
  }

  Callbacks callbacks_;
  std::shared_ptr<Core> core_;
  std::unique_ptr<Server<SendGoal>> send_goal_;
  std::unique_ptr<Server<Cancel>> cancel_;
  std::unique_ptr<Server<GetResult>> get_result_;
  std::shared_ptr<Timer> expiry_;
};

}  // namespace goalnet::ros
