#include "components/goalnet/goalnet_node.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "components/core/config_path.h"
#include "components/messages/conversions.h"

namespace goalnet::inference {

using goalnet_msgs::msg::GoalPredicates;
using goalnet_msgs::msg::StepRequest;

namespace {

constexpr std::size_t kMostSteps =
    1000;  // the coordinator's largest max_steps; requests come from the network

}  // namespace

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
  object_poses_ = node_.subscribe<goalnet_msgs::msg::ObjectPoses>(
      "object_poses", ros::Qos::standard(),
      [this](const goalnet_msgs::msg::ObjectPoses& message) { on_poses(message); });
  joint_states_ = node_.subscribe<sensor_msgs::msg::JointState>(
      "joint_states", ros::Qos::standard(),
      [this](const sensor_msgs::msg::JointState& message) { on_joints(message); });
  return {};
}

Expected<void> GoalnetNode::on_deactivate() {
  joint_states_.reset();
  object_poses_.reset();
  world_state_.reset();
  request_.reset();
  goal_predicates_.reset();
  waiting_.reset();
  last_answer_.reset();
  world_.reset();
  world_stamp_ = 0;
  states_.clear();
  goals_.clear();
  positions_.clear();
  distances_.clear();
  base_x_.reset();
  base_y_.reset();
  return {};
}

Expected<void> GoalnetNode::on_cleanup() {
  model_.reset();
  return {};
}

void GoalnetNode::on_poses(const goalnet_msgs::msg::ObjectPoses& message) {
  if (message.objects().size() > messages::kMaxObjects) return;  // the world model says so
  for (const auto& object : message.objects()) {
    const auto& position = object.pose().position();
    if (!std::isfinite(position.x()) || !std::isfinite(position.y())) continue;
    if (positions_.size() < messages::kMaxObjects || positions_.contains(object.name()))
      positions_[object.name()] = {position.x(), position.y()};
  }
}

void GoalnetNode::on_joints(const sensor_msgs::msg::JointState& message) {
  const std::size_t count = std::min(message.name().size(), message.position().size());
  for (std::size_t i = 0; i < count; ++i) {
    if (!std::isfinite(message.position()[i])) continue;
    if (message.name()[i] == "base_x") base_x_ = message.position()[i];
    if (message.name()[i] == "base_y") base_y_ = message.position()[i];
  }
}

// Rounded to centimetres: smaller differences are no reason to prefer one thing.
std::map<std::string, double> GoalnetNode::distances() const {
  std::map<std::string, double> result;
  if (!base_x_ || !base_y_) return result;
  for (const auto& [name, at] : positions_)
    result[name] = std::round(100 * std::hypot(at[0] - *base_x_, at[1] - *base_y_)) / 100;
  return result;
}

void GoalnetNode::on_world(const goalnet_msgs::msg::WorldState& message) {
  auto world = messages::from_message(message);
  if (!world) {
    return bad_worlds_.write(
        [&](const std::string& more) { node_.log().warn("world_state: {}{}", world.error().message, more); });
  }
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
                         states_.size() == message.step() && states_.size() < kMostSteps;
  if (!continues) {
    states_.clear();
    goals_.clear();
    distances_ = distances();
  }
  states_.push_back(*world_);
  StepInput input;
  input.sentence = message.instruction();
  input.states = states_;
  input.goals = goals_;
  if (!distances_.empty()) input.distances = &distances_;
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
