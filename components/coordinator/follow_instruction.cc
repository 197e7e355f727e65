#include "components/coordinator/follow_instruction.h"

#include <utility>
#include <vector>

#include "components/messages/conversions.h"

namespace goalnet::coordinator {
namespace {

using FollowAction = goalnet_msgs::action::FollowInstruction;

FollowAction::Result result_of(const Report& report) {
  FollowAction::Result result;
  result.outcome(static_cast<std::int32_t>(report.outcome));
  result.message(report.message);
  result.facts_added(messages::to_message(report.facts_added));
  result.facts_removed(messages::to_message(report.facts_removed));
  result.actions(messages::to_message(report.actions));
  return result;
}

FollowAction::Feedback feedback_of(const Report& report) {
  FollowAction::Feedback feedback;
  feedback.stage(to_string(report.stage));
  feedback.step(report.step);
  feedback.positive(messages::to_message(report.goal.positive));
  feedback.negative(messages::to_message(report.goal.negative));
  feedback.current_action(messages::to_message(report.current_action));
  feedback.progress(report.progress);
  return feedback;
}

}  // namespace

FollowInstruction::FollowInstruction(ros::Node& node, Coordinator& coordinator,
                                     std::function<void(std::uint64_t id)> interrupt)
    : node_(node),
      coordinator_(coordinator),
      interrupt_(std::move(interrupt)),
      server_(node, "follow_instruction",
              {.on_goal = [this](const ros::GoalId& id,
                                 const FollowAction::Goal& goal) { return on_goal(id, goal); },
               .on_accepted =
                   [this](std::shared_ptr<Handle> handle) {
                     const auto found = instructions_.find(handle->id());
                     if (found != instructions_.end()) handles_[found->second] = std::move(handle);
                   },
               .on_cancel = [this](Handle& handle) { return on_cancel(handle); },
               .on_cancel_arrived = [this](const ros::GoalId& id,
                                           ros::Time stamp) { on_cancel_arrived(id, stamp); }}) {}

ros::GoalResponse FollowInstruction::on_goal(const ros::GoalId& goal_id, const FollowAction::Goal& goal) {
  const auto id = coordinator_.instruct(goal.instruction(), goal.max_steps(), node_.now().nanoseconds);
  if (!id) return ros::GoalResponse::kReject;
  const std::lock_guard lock(mutex_);
  instructions_[goal_id] = *id;
  return ros::GoalResponse::kExecute;
}

bool FollowInstruction::on_cancel(const Handle& handle) {
  const auto found = instructions_.find(handle.id());
  if (found == instructions_.end()) return false;
  // Ended from the loop: the goal must be CANCELING before its result says CANCELED.
  node_.loop().post([this, id = found->second, alive = std::weak_ptr<bool>(alive_)] {
    if (!alive.expired()) coordinator_.cancel_one(id, node_.now().nanoseconds);
  });
  return true;
}

// Only what surely means a goal of ours; the rest of the rules is applied when the loop comes to the request.
void FollowInstruction::on_cancel_arrived(const ros::GoalId& id, ros::Time stamp) {
  std::vector<std::uint64_t> meant;
  {
    const std::lock_guard lock(mutex_);
    for (const auto& [goal, instruction] : instructions_) {
      if (goal == id || (id == ros::GoalId{} && stamp == ros::Time{})) meant.push_back(instruction);
    }
  }
  for (const std::uint64_t instruction : meant) interrupt_(instruction);
}

void FollowInstruction::on_report(const Report& report) {
  const auto found = handles_.find(report.id);
  if (found == handles_.end()) return;
  if (!report.finished) return found->second->publish_feedback(feedback_of(report));
  const std::shared_ptr<Handle> handle = std::move(found->second);
  handles_.erase(found);
  {
    const std::lock_guard lock(mutex_);
    instructions_.erase(handle->id());
  }
  switch (report.outcome) {
    case Outcome::kDone:
      handle->succeed(result_of(report));
      break;
    case Outcome::kCancelled:
      handle->canceled(result_of(report));
      break;
    default:
      handle->abort(result_of(report));
      break;
  }
}

}  // namespace goalnet::coordinator
