#include "components/goalnet/goalnet_node.h"

#include <utility>

#include "components/core/config_path.h"
#include "components/messages/conversions.h"

namespace goalnet::inference {

using goalnet_msgs::msg::GoalPredicates;
using goalnet_msgs::msg::StepRequest;

void GoalnetNode::describe(ros::ParameterSet& set, Params& params) {
  set.text("model", params.model, "model that infers goals", "a name in config/models or a file");
}

Expected<std::unique_ptr<GoalnetNode>> GoalnetNode::create(ros::Node& node) {
  return ros::started(std::unique_ptr<GoalnetNode>(new GoalnetNode(node)));
}

GoalnetNode::GoalnetNode(ros::Node& node) : ManagedComponent(node) { describe(parameters_, params_); }

Expected<void> GoalnetNode::on_configure() {
  auto model = load_model(config_file("models", params_.model, ".safetensors"));
  if (!model) return tl::unexpected<Error>(std::move(model.error()));
  model_ = std::move(*model);
  return {};
}

Expected<void> GoalnetNode::on_activate() {
  goal_predicates_ = node_.advertise<GoalPredicates>("goal_predicates");
  request_ = node_.subscribe<StepRequest>("step_request", ros::Qos::standard(),
                                          [this](const StepRequest& message) { on_request(message); });
  world_state_ = node_.subscribe<goalnet_msgs::msg::WorldState>(
      "world_state", ros::Qos::latched(),
      [this](const goalnet_msgs::msg::WorldState& message) { on_world(message); });
  return {};
}

Expected<void> GoalnetNode::on_deactivate() {
  world_state_.reset();
  request_.reset();
  goal_predicates_.reset();
  waiting_.reset();
  last_answer_.reset();
  world_.reset();
  world_stamp_ = 0;
  states_.clear();
  goals_.clear();
  return {};
}

Expected<void> GoalnetNode::on_cleanup() {
  model_.reset();
  return {};
}

void GoalnetNode::on_world(const goalnet_msgs::msg::WorldState& message) {
  auto world = messages::from_message(message);
  if (!world) return node_.log().warn("world_state: {}", world.error().message);
  world_ = std::move(*world);
  world_stamp_ = messages::to_nanoseconds(message.header().stamp());
  if (waiting_ && world_is_new_enough(*waiting_)) answer(*std::exchange(waiting_, {}));
}

bool GoalnetNode::world_is_new_enough(const StepRequest& message) const {
  return world_ && world_stamp_ >= messages::to_nanoseconds(message.header().stamp());
}

void GoalnetNode::on_request(const StepRequest& message) {
  const bool repeated = last_answer_ && last_answer_->instruction_id() == message.instruction_id() &&
                        last_answer_->step() == message.step() &&
                        last_answer_->instruction() == message.instruction();
  if (repeated && message.step() > 0) {
    goal_predicates_->publish(*last_answer_);
  } else if (world_is_new_enough(message)) {
    answer(message);
  } else {
    waiting_ = message;
  }
}

void GoalnetNode::answer(const StepRequest& message) {
  const bool continues = message.step() > 0 && last_answer_ &&
                         last_answer_->instruction_id() == message.instruction_id() &&
                         states_.size() == message.step();
  if (!continues) {
    states_.clear();
    goals_.clear();
  }
  states_.push_back(*world_);
  StepInput input;
  input.sentence = message.instruction();
  input.states = states_;
  input.goals = goals_;
  const auto goal = model_->infer(input);

  GoalPredicates answer;
  answer.header().stamp(node_.now());
  answer.instruction_id(message.instruction_id());
  answer.step(message.step());
  answer.instruction(message.instruction());
  if (goal) {
    messages::fill(answer, *goal);
    answer.complete(goal->empty());
    goals_.push_back(*goal);
  } else {
    answer.outcome(static_cast<std::int32_t>(goal.error().outcome));
    answer.message(goal.error().message);
  }
  last_answer_ = answer;
  goal_predicates_->publish(answer);
}

}  // namespace goalnet::inference
