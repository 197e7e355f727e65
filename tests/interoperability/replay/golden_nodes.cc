#include "tests/interoperability/replay/golden_nodes.h"

#include "tests/unit/ros/support.h"

namespace goalnet::ros {
namespace {

NodeOptions golden(std::string name, std::string node_namespace) {
  NodeOptions options = plain(std::move(name));
  options.node_namespace = std::move(node_namespace);
  options.logger_services = false;  // rclpy offers them on request only
  return options;
}

}  // namespace

GoldenNode::GoldenNode(int domain, Distro distro, EventLoop& loop)
    : context_(make_context(domain, distro)), node_(*context_, loop, golden("golden_node", "/golden")) {
  node_.declare_parameter("gain", 1.5).value();
  node_.declare_parameter("count", 3).value();
  node_.declare_parameter("label", "abc").value();
  node_.declare_parameter("on", true).value();
  node_.declare_parameter("joints", std::vector<std::string>{"j1", "j2"}).value();
  node_.declare_parameter("limits", std::vector<double>{0.5, 1.25}).value();
  chatter_ = node_.advertise<std_msgs::msg::String>("/chatter");
  cmd_ = node_.subscribe<std_msgs::msg::String>(
      "/cmd", Qos::standard(), [this](const auto& message) { heard_.push_back(message.data()); });
  sens_ = node_.subscribe<std_msgs::msg::String>("/sens", Qos::sensor_data(), [](const auto&) {});
  do_it_ =
      std::make_unique<Server<std_srvs::srv::Trigger>>(node_, "/do_it", [this](const auto&, auto& response) {
        node_.log().info("trigger called");
        response.success(true);
        response.message("done");
      });
  ActionServer<Fibonacci>::Callbacks callbacks;
  callbacks.on_goal = [](const GoalId&, const auto&) { return GoalResponse::kExecute; };
  callbacks.on_accepted = [this](auto goal) {
    goal_ = std::move(goal);
    sequence_ = {0, 1};
  };
  callbacks.on_cancel = [](auto&) { return true; };
  fib_ = std::make_unique<ActionServer<Fibonacci>>(node_, "/fib", std::move(callbacks));
}

void GoldenNode::step() {
  if (!goal_) return;
  Fibonacci::Result result;
  result.sequence_(sequence_);
  if (goal_->canceling()) {
    goal_->canceled(result);
    goal_.reset();
  } else if (static_cast<int>(sequence_.size()) > goal_->goal().order()) {
    goal_->succeed(result);
    goal_.reset();
  } else {
    sequence_.push_back(sequence_[sequence_.size() - 1] + sequence_[sequence_.size() - 2]);
    Fibonacci::Feedback feedback;
    feedback.sequence_(sequence_);
    goal_->publish_feedback(feedback);
  }
}

void GoldenNode::end_if_due() {
  if (goal_ && (goal_->canceling() || static_cast<int>(sequence_.size()) > goal_->goal().order())) step();
}

GoldenLifecycleNode::GoldenLifecycleNode(int domain, Distro distro, EventLoop& loop)
    : context_(make_context(domain, distro)),
      node_(*context_, loop, golden("golden_lc", "/golden")),
      lifecycle_(node_, {}) {}

GoldenClient::GoldenClient(int domain, Distro distro, EventLoop& loop)
    : context_(make_context(domain, distro)),
      node_(*context_, loop, golden("golden_client", "/")),
      fib_(node_, "/fib") {}

}  // namespace goalnet::ros
