#include "components/coordinator/coordinator_session.h"

#include <chrono>
#include <utility>

#include "components/coordinator/status_message.h"
#include "components/messages/conversions.h"

namespace goalnet::coordinator {
namespace {

using goalnet_msgs::msg::ActionRequest;
using goalnet_msgs::msg::ActionStatus;
using goalnet_msgs::msg::CancelInstruction;
using goalnet_msgs::msg::GoalPredicates;
using goalnet_msgs::msg::InstructionStatus;
using goalnet_msgs::msg::StepRequest;

constexpr std::chrono::milliseconds kTick{50};
constexpr std::chrono::milliseconds kLastWords{50};

}  // namespace

CoordinatorSession::CoordinatorSession(ros::Node& node, const CoordinatorParams& params,
                                       const ActionModel& model, std::uint64_t first_id)
    : node_(node),
      coordinator_(params, model, *this, first_id),
      standstill_timeout_(params.standstill_timeout) {
  open_topics();
}

void CoordinatorSession::open_topics() {
  step_request_ = node_.advertise<StepRequest>("step_request");
  goal_predicates_ = node_.advertise<GoalPredicates>("goal_predicates");
  action_request_ = node_.advertise<ActionRequest>("action_request");
  status_ = node_.advertise<InstructionStatus>("instruction_status", ros::Qos::latched());
  const auto subscribe = [this]<class M>(const char* topic, const ros::Qos& qos,
                                         void (CoordinatorSession::*handle)(const M&)) {
    return node_.subscribe<M>(topic, qos, [this, handle](const M& message) { (this->*handle)(message); });
  };
  const ros::Qos standard = ros::Qos::standard();
  instruction_ = subscribe("instruction", standard, &CoordinatorSession::on_instruction);
  goal_ = subscribe("goal", standard, &CoordinatorSession::on_given_goal);
  inferred_ = subscribe("goal_predicates", standard, &CoordinatorSession::on_goal_predicates);
  plan_ = subscribe("plan", standard, &CoordinatorSession::on_plan);
  action_status_ = subscribe("action_status", standard.keep_last(100), &CoordinatorSession::on_action_status);
  world_state_ = subscribe("world_state", ros::Qos::latched(), &CoordinatorSession::on_world_state);
  cancel_ = node_.advertise<CancelInstruction>("cancel_instruction");
  cancel_asked_ = subscribe("cancel_instruction", standard, &CoordinatorSession::on_cancel);
  action_ = std::make_unique<FollowInstruction>(node_, coordinator_,
                                                [this](std::uint64_t id) { forget_request(id); });
  timer_ = node_.create_timer(kTick, [this] { coordinator_.tick(now()); });
  wall_timer_ =
      ros::Timer::create(node_.loop(), wall_clock_, std::chrono::seconds(1), [this] { watch_time(); });
}

void CoordinatorSession::leave() {
  coordinator_.abandon(now(), "the coordinator was deactivated");
  action_request_->wait_for_acknowledgments(kLastWords);
  status_->wait_for_acknowledgments(kLastWords);
  action_->wait_for_acknowledgments(kLastWords);
}

// When a simulator dies, its time stands still, and no timeout would ever come. Counted, not measured: while
// another component computes in the same thread, the count stands still, too.
void CoordinatorSession::watch_time() {
  const TimeNs time = now();
  seconds_still_ = time == last_time_ ? seconds_still_ + 1 : 0;
  last_time_ = time;
  if (!node_.clock().simulated() || !coordinator_.busy() || seconds_still_ < standstill_timeout_) return;
  coordinator_.world_lost(time, "simulated time stands still; is the simulator running?");
}

void CoordinatorSession::cancel(const std::string& reason) { coordinator_.cancel(now(), reason); }

bool CoordinatorSession::connected() const {
  return step_request_->subscriber_count() > 0 && goal_predicates_->subscriber_count() > 1 &&
         action_request_->subscriber_count() > 0 && plan_->publisher_count() > 0 &&
         action_status_->publisher_count() > 0 && world_state_->publisher_count() > 0;
}

void CoordinatorSession::request_goal(std::uint64_t id, std::uint32_t step, const std::string& instruction,
                                      TimeNs world_stamp) {
  StepRequest message;
  message.header().stamp(messages::to_stamp(world_stamp));
  message.instruction_id(id);
  message.step(step);
  message.instruction(instruction);
  step_request_->publish(message);
}

void CoordinatorSession::request_plan(std::uint64_t id, std::uint32_t step, const std::string& instruction,
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

void CoordinatorSession::execute(const ActionOrder& order) {
  send_order(order, goalnet_msgs::msg::ActionRequest_Constants::EXECUTE);
}

void CoordinatorSession::cancel(const ActionOrder& order) {
  send_order(order, goalnet_msgs::msg::ActionRequest_Constants::CANCEL);
}

// Thread-safe: the action's cancel requests call it from a thread of DDS.
void CoordinatorSession::forget_request(std::uint64_t id) {
  CancelInstruction message;
  message.header().stamp(messages::to_stamp(now()));
  message.instruction_id(id);
  cancel_->publish(message);
}

void CoordinatorSession::send_order(const ActionOrder& order, std::uint8_t command) {
  ActionRequest message;
  message.header().stamp(messages::to_stamp(now()));
  message.instruction_id(order.id);
  message.step(order.step);
  message.index(order.index);
  message.command(command);
  message.action(messages::to_message(order.action));
  action_request_->publish(message);
}

void CoordinatorSession::report(const Report& report) {
  status_->publish(to_message(report, now()));
  if (action_) action_->on_report(report);
  if (!report.finished || report.id == finished_id_) return;
  finished_id_ = report.id;
  const std::string outcome(goalnet::to_string(report.outcome));
  if (static_cast<int>(report.outcome) >= static_cast<int>(Outcome::kMotionFailed)) {
    node_.log().error("instruction {} ended: {}: {}", report.id, outcome, report.message);
    return;
  }
  end_lines_.write([&](const std::string& more) {  // a flood of instructions is refused one by one
    node_.log().info("instruction {} ended: {}: {}{}", report.id, outcome, report.message, more);
  });
}

void CoordinatorSession::on_instruction(const std_msgs::msg::String& message) {
  // A refusal is reported on /instruction_status and logged there.
  static_cast<void>(coordinator_.instruct(message.data(), 0, now()));
}

void CoordinatorSession::complain(const char* topic, const std::string& what) {
  bad_messages_.write([&](const std::string& more) { node_.log().warn("{}: {}{}", topic, what, more); });
}

void CoordinatorSession::on_given_goal(const GoalPredicates& message) {
  const auto goal = messages::goal_from_message(message);
  if (!goal) return complain("/goal", goal.error().message);
  static_cast<void>(coordinator_.pursue(*goal, now()));
}

void CoordinatorSession::on_goal_predicates(const GoalPredicates& message) {
  const auto goal = messages::goal_from_message(message);
  if (!goal) return complain("/goal_predicates", goal.error().message);
  coordinator_.on_goal({message.instruction_id(), message.step(), *goal, message.complete(),
                        outcome_from_int(message.outcome()), message.message()},
                       now());
}

void CoordinatorSession::on_plan(const goalnet_msgs::msg::Plan& message) {
  if (message.actions().size() > messages::kMaxActions) return complain("/plan", "too many actions; dropped");
  coordinator_.on_plan({message.instruction_id(), message.step(), messages::from_message(message.actions()),
                        outcome_from_int(message.outcome()), message.message()},
                       now());
}

void CoordinatorSession::on_action_status(const ActionStatus& message) {
  coordinator_.on_action({message.instruction_id(), message.step(), message.index(),
                          message.state() == goalnet_msgs::msg::ActionStatus_Constants::FINISHED,
                          message.progress(), outcome_from_int(message.outcome()), message.message()},
                         now());
}

void CoordinatorSession::on_world_state(const goalnet_msgs::msg::WorldState& message) {
  auto world = messages::from_message(message);
  if (!world) return complain("/world_state", world.error().message);
  coordinator_.on_world(std::move(*world), messages::to_nanoseconds(message.header().stamp()), now());
}

// Also heard: our own. Those name an instruction that has ended, or are followed by the action's own cancel.
void CoordinatorSession::on_cancel(const CancelInstruction& message) {
  if (message.instruction_id() == 0) return coordinator_.cancel(now());
  coordinator_.cancel_one(message.instruction_id(), now());
}

}  // namespace goalnet::coordinator
