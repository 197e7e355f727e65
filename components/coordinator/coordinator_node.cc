#include "components/coordinator/coordinator_node.h"

#include <chrono>
#include <utility>

#include "components/coordinator/coordinator_parameters.h"
#include "components/coordinator/status_message.h"
#include "components/messages/conversions.h"

namespace goalnet::coordinator {
namespace {

using goalnet_msgs::msg::ActionRequest;
using goalnet_msgs::msg::ActionStatus;
using goalnet_msgs::msg::GoalPredicates;
using goalnet_msgs::msg::InstructionStatus;
using goalnet_msgs::msg::StepRequest;

constexpr std::chrono::milliseconds kTick{50};

}  // namespace

Expected<std::unique_ptr<CoordinatorNode>> CoordinatorNode::create(ros::Node& node) {
  const auto params = declare_parameters(node);
  if (!params) return tl::unexpected<Error>(params.error());
  auto domain = planner::load_domain(params->domain);
  if (!domain) return tl::unexpected<Error>(domain.error());
  auto coordinator =
      std::unique_ptr<CoordinatorNode>(new CoordinatorNode(node, params->core, std::move(*domain)));
  coordinator->open_topics();
  return coordinator;
}

CoordinatorNode::CoordinatorNode(ros::Node& node, const CoordinatorParams& params, planner::Domain domain)
    : node_(node), model_(std::move(domain)), coordinator_(params, model_, *this) {}

void CoordinatorNode::open_topics() {
  step_request_ = node_.advertise<StepRequest>("step_request");
  goal_predicates_ = node_.advertise<GoalPredicates>("goal_predicates");
  action_request_ = node_.advertise<ActionRequest>("action_request");
  status_ = node_.advertise<InstructionStatus>("instruction_status", ros::Qos::latched());
  const auto subscribe = [this]<class M>(const char* topic, const ros::Qos& qos,
                                         void (CoordinatorNode::*handle)(const M&)) {
    return node_.subscribe<M>(topic, qos, [this, handle](const M& message) { (this->*handle)(message); });
  };
  const ros::Qos standard = ros::Qos::standard();
  instruction_ = subscribe("instruction", standard, &CoordinatorNode::on_instruction);
  goal_ = subscribe("goal", standard, &CoordinatorNode::on_given_goal);
  inferred_ = subscribe("goal_predicates", standard, &CoordinatorNode::on_goal_predicates);
  plan_ = subscribe("plan", standard, &CoordinatorNode::on_plan);
  action_status_ = subscribe("action_status", standard.keep_last(100), &CoordinatorNode::on_action_status);
  world_state_ = subscribe("world_state", ros::Qos::latched(), &CoordinatorNode::on_world_state);
  action_ = std::make_unique<FollowInstruction>(node_, coordinator_);
  timer_ = node_.create_timer(kTick, [this] { coordinator_.tick(now()); });
}

void CoordinatorNode::cancel(const std::string& reason) { coordinator_.cancel(now(), reason); }

bool CoordinatorNode::connected() const {
  return step_request_->subscriber_count() > 0 && goal_predicates_->subscriber_count() > 1 &&
         action_request_->subscriber_count() > 0 && plan_->publisher_count() > 0 &&
         action_status_->publisher_count() > 0 && world_state_->publisher_count() > 0;
}

void CoordinatorNode::request_goal(std::uint64_t id, std::uint32_t step, const std::string& instruction,
                                   TimeNs world_stamp) {
  StepRequest message;
  message.header().stamp(messages::to_stamp(world_stamp));
  message.instruction_id(id);
  message.step(step);
  message.instruction(instruction);
  step_request_->publish(message);
}

void CoordinatorNode::request_plan(std::uint64_t id, std::uint32_t step, const std::string& instruction,
                                   const Goal& goal) {
  if (!coordinator_.last_difference().empty())
    node_.log().info("new plan: {}", coordinator_.last_difference());
  GoalPredicates message;
  message.header().stamp(messages::to_stamp(now()));
  message.instruction_id(id);
  message.step(step);
  message.instruction(instruction);
  messages::fill(message, goal);
  goal_predicates_->publish(message);
}

void CoordinatorNode::execute(const ActionOrder& order) {
  send_order(order, goalnet_msgs::msg::ActionRequest_Constants::EXECUTE);
}

void CoordinatorNode::cancel(const ActionOrder& order) {
  send_order(order, goalnet_msgs::msg::ActionRequest_Constants::CANCEL);
}

void CoordinatorNode::send_order(const ActionOrder& order, std::uint8_t command) {
  ActionRequest message;
  message.header().stamp(messages::to_stamp(now()));
  message.instruction_id(order.id);
  message.step(order.step);
  message.index(order.index);
  message.command(command);
  message.action(messages::to_message(order.action));
  action_request_->publish(message);
}

void CoordinatorNode::report(const Report& report) {
  status_->publish(to_message(report, now()));
  if (action_) action_->on_report(report);
  if (!report.finished || report.id == finished_id_) return;
  finished_id_ = report.id;
  const std::string outcome(goalnet::to_string(report.outcome));
  if (static_cast<int>(report.outcome) >= static_cast<int>(Outcome::kMotionFailed)) {
    node_.log().error("instruction {} ended: {}: {}", report.id, outcome, report.message);
  } else {
    node_.log().info("instruction {} ended: {}: {}", report.id, outcome, report.message);
  }
}

void CoordinatorNode::on_instruction(const std_msgs::msg::String& message) {
  // A refusal is reported on /instruction_status and logged there.
  static_cast<void>(coordinator_.instruct(message.data(), 0, now()));
}

void CoordinatorNode::on_given_goal(const GoalPredicates& message) {
  const auto goal = messages::goal_from_message(message);
  if (!goal) return node_.log().warn("/goal: {}", goal.error().message);
  static_cast<void>(coordinator_.pursue(*goal, now()));
}

void CoordinatorNode::on_goal_predicates(const GoalPredicates& message) {
  const auto goal = messages::goal_from_message(message);
  if (!goal) return node_.log().warn("/goal_predicates: {}", goal.error().message);
  coordinator_.on_goal({message.instruction_id(), message.step(), *goal, message.complete(),
                        outcome_from_int(message.outcome()), message.message()},
                       now());
}

void CoordinatorNode::on_plan(const goalnet_msgs::msg::Plan& message) {
  if (message.actions().size() > messages::kMaxActions)
    return node_.log().warn("/plan: too many actions; dropped");
  coordinator_.on_plan({message.instruction_id(), message.step(), messages::from_message(message.actions()),
                        outcome_from_int(message.outcome()), message.message()},
                       now());
}

void CoordinatorNode::on_action_status(const ActionStatus& message) {
  coordinator_.on_action({message.instruction_id(), message.step(), message.index(),
                          message.state() == goalnet_msgs::msg::ActionStatus_Constants::FINISHED,
                          message.progress(), outcome_from_int(message.outcome()), message.message()},
                         now());
}

void CoordinatorNode::on_world_state(const goalnet_msgs::msg::WorldState& message) {
  auto world = messages::from_message(message);
  if (!world) return node_.log().warn("/world_state: {}", world.error().message);
  coordinator_.on_world(std::move(*world), messages::to_nanoseconds(message.header().stamp()), now());
}

}  // namespace goalnet::coordinator
