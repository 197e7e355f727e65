// The nodes that the captures were taken from, made with our library: /golden/golden_node and the managed
// node /golden/golden_lc, each a participant of its own, and /golden_client, which asks the action.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "components/ros/action_client.h"
#include "components/ros/action_server.h"
#include "components/ros/lifecycle.h"
#include "components/ros/service.h"
#include "example_interfaces/action/Fibonacci_action.h"
#include "std_msgs/msg/String.h"
#include "std_srvs/srv/Trigger_service.h"

namespace goalnet::ros {

class GoldenNode {
 public:
  using Fibonacci = example_interfaces::action::Fibonacci;
  GoldenNode(int domain, Distro distro, EventLoop& loop);

  // One round of the action's work: a feedback message, or the end of the goal.
  void step();
  // Ends a goal that is done, or whose cancelling was asked for.
  void end_if_due();
  Context& context() { return *context_; }
  const std::vector<std::string>& heard() const { return heard_; }  // on /cmd

 private:
  std::unique_ptr<Context> context_;
  Node node_;
  std::vector<std::string> heard_;
  std::shared_ptr<Publisher<std_msgs::msg::String>> chatter_;
  std::shared_ptr<Subscription<std_msgs::msg::String>> cmd_, sens_;
  std::unique_ptr<Server<std_srvs::srv::Trigger>> do_it_;
  std::shared_ptr<GoalHandle<Fibonacci>> goal_;
  std::vector<std::int32_t> sequence_;
  std::unique_ptr<ActionServer<Fibonacci>> fib_;
};

class GoldenLifecycleNode {
 public:
  GoldenLifecycleNode(int domain, Distro distro, EventLoop& loop);
  Context& context() { return *context_; }

 private:
  std::unique_ptr<Context> context_;
  Node node_;
  Lifecycle lifecycle_;
};

class GoldenClient {
 public:
  GoldenClient(int domain, Distro distro, EventLoop& loop);
  Context& context() { return *context_; }

 private:
  std::unique_ptr<Context> context_;
  Node node_;
  ActionClient<GoldenNode::Fibonacci> fib_;
};

}  // namespace goalnet::ros
