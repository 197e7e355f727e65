#include "components/manipulation/manipulation_session.h"

#include <chrono>
#include <utility>

#include "components/messages/conversions.h"

namespace goalnet::manipulation {
namespace {

using goalnet_msgs::msg::ActionRequest;
using goalnet_msgs::msg::ActionStatus;

constexpr std::chrono::milliseconds kUpdatePeriod{10};
constexpr std::chrono::milliseconds kReportPeriod{100};
constexpr std::chrono::milliseconds kLastWords{50};

bool same_request(const ActionRequest& a, const ActionRequest& b) {
  return a.instruction_id() == b.instruction_id() && a.step() == b.step() && a.index() == b.index();
}

bool answers(const ActionStatus& status, const ActionRequest& request) {
  return status.instruction_id() == request.instruction_id() && status.step() == request.step() &&
         status.index() == request.index();
}

trajectory_msgs::msg::JointTrajectory to_message(const JointTrajectory& trajectory) {
  trajectory_msgs::msg::JointTrajectory message;
  message.header().stamp(messages::to_stamp(trajectory.stamp_ns));
  message.joint_names(trajectory.joints);
  for (const executor::TrajectoryPoint& point : trajectory.points) {
    trajectory_msgs::msg::JointTrajectoryPoint one;
    one.positions(point.position);
    one.velocities(point.velocity);
    one.time_from_start().sec(static_cast<std::int32_t>(point.time_ns / 1'000'000'000));
    one.time_from_start().nanosec(static_cast<std::uint32_t>(point.time_ns % 1'000'000'000));
    message.points().push_back(std::move(one));
  }
  return message;
}

executor::ExecutorStatus from_message(const goalnet_msgs::msg::ExecutorStatus& message) {
  executor::ExecutorStatus status;
  status.state = static_cast<executor::ExecutorState>(std::min<std::uint8_t>(message.state(), 3));
  status.trajectory_id = message.trajectory_id();
  status.trajectory_stamp_ns = messages::to_nanoseconds(message.trajectory_stamp());
  status.progress = message.progress();
  status.tracking_error = message.tracking_error();
  status.outcome = outcome_from_int(message.outcome());
  status.message = message.message();
  return status;
}

}  // namespace

ManipulationSession::ManipulationSession(ros::Node& node, Workbench& bench)
    : node_(node), bench_(bench), runner_(bench), perception_(bench.model()) {
  bench_.forget_command();
  bench_.set_stop_check([this] { return interrupted_.load(); });
  open_topics();
}

ManipulationSession::~ManipulationSession() { bench_.set_stop_check({}); }

void ManipulationSession::leave() {
  if (!current_ && !waiting_) return;
  const Error left{Outcome::kCancelled, "manipulation was deactivated; the executor was told to stop"};
  if (current_) {
    send_stop();
    publish_status(*std::exchange(current_, {}), true, left);
  }
  if (waiting_) publish_status(*std::exchange(waiting_, {}), true, left);
  // The topics close next: what was said last must have reached others by then.
  status_->wait_for_acknowledgments(kLastWords);
  command_->wait_for_acknowledgments(kLastWords);
}

void ManipulationSession::open_topics() {
  status_ = node_.advertise<ActionStatus>("action_status");
  trajectory_ = node_.advertise<trajectory_msgs::msg::JointTrajectory>("joint_trajectory");
  command_ = node_.advertise<std_msgs::msg::String>("executor_command");
  const ros::Qos standard = ros::Qos::standard();
  // Planning keeps the event loop busy: a cancel must reach it from outside.
  request_ = node_.subscribe<ActionRequest>(
      "action_request", standard, [this](const ActionRequest& message) { on_request(message); }, {},
      [this](const ActionRequest& message) {
        if (message.command() == goalnet_msgs::msg::ActionRequest_Constants::CANCEL) interrupt();
      });
  instruction_cancelled_ = node_.subscribe<goalnet_msgs::msg::CancelInstruction>(
      "cancel_instruction", standard,
      [this](const goalnet_msgs::msg::CancelInstruction& message) {
        if (message.instruction_id() == 0 || message.instruction_id() == instruction_) interrupt();
      },
      {.immediate = true});
  executor_status_ = node_.subscribe<goalnet_msgs::msg::ExecutorStatus>(
      "executor_status", ros::Qos::latched().keep_last(20),
      [this](const auto& message) { on_executor_status(message); });
  joint_states_ = node_.subscribe<sensor_msgs::msg::JointState>(
      "joint_states", standard, [this](const auto& message) { perceive("joint_states", message); });
  object_poses_ = node_.subscribe<goalnet_msgs::msg::ObjectPoses>(
      "object_poses", standard, [this](const auto& message) { perceive("object_poses", message); });
  world_state_ = node_.subscribe<goalnet_msgs::msg::WorldState>(
      "world_state", ros::Qos::latched(), [this](const auto& message) { perceive("world_state", message); });
  timer_ = node_.create_timer(kUpdatePeriod, [this] { update(); });
}

template <class Message>
void ManipulationSession::perceive(const char* topic, const Message& message) {
  const auto taken = perception_.take(message);
  if (taken) return;
  bad_messages_.write([&](const std::string& more) {
    node_.log().warn("{} dropped: {}{}", topic, taken.error().message, more);
  });
}

void ManipulationSession::on_executor_status(const goalnet_msgs::msg::ExecutorStatus& message) {
  executor_ = from_message(message);
  // A trajectory refused because of the fault is answered in the same state with the refusal's outcome: not
  // the cause.
  const bool cause = executor_.outcome >= Outcome::kMotionFailed;
  if (executor_.state == executor::ExecutorState::kFault && cause)
    fault_ = {executor_.outcome, executor_.message};
  if (executor_.state != executor::ExecutorState::kFault) fault_ = {};
  update();
}

void ManipulationSession::on_request(const ActionRequest& message) {
  if (message.command() == goalnet_msgs::msg::ActionRequest_Constants::CANCEL) return on_cancel(message);
  if (current_ && same_request(*current_, message)) return;
  if (waiting_ && same_request(*waiting_, message)) return;
  if (last_ && answers(*last_, message)) {
    status_->publish(*last_);
    return;
  }
  if (current_) runner_.cancel();
  waiting_ = message;
  update();
}

void ManipulationSession::on_cancel(const ActionRequest& message) {
  if (waiting_ && same_request(*waiting_, message)) {
    waiting_.reset();
    publish_status(message, true, {Outcome::kCancelled, "cancelled before it began"});
  } else if (current_ && same_request(*current_, message)) {
    runner_.cancel();
    update();
  } else if (last_ && answers(*last_, message)) {
    status_->publish(*last_);
  } else if (!current_ && moving()) {
    // By one of us that was killed. The answer has to wait: it means that the robot stands.
    stopping_for_ = message;
    send_stop();
  } else {
    publish_status(message, true, {Outcome::kCancelled, "it did not run"});
  }
}

bool ManipulationSession::moving() const {
  return executor_.state == executor::ExecutorState::kExecuting ||
         executor_.state == executor::ExecutorState::kStopping;
}

void ManipulationSession::send_stop() {
  std_msgs::msg::String stop;
  stop.data("stop");
  command_->publish(stop);
}

void ManipulationSession::start_waiting() {
  if (!waiting_ || current_ || !perception_.complete()) return;
  current_ = std::exchange(waiting_, {});
  if (instruction_ != current_->instruction_id()) {
    bench_.forget_hindrances();
    runner_.begin_instruction();
  }
  if (std::exchange(step_, current_->step()) != current_->step()) runner_.begin_step();
  instruction_ = current_->instruction_id();
  interrupted_ = false;
  abandoned_ = false;
  reported_stage_.clear();
  const auto started = runner_.start(messages::from_message(current_->action()));
  if (!started) publish_status(*std::exchange(current_, {}), true, started.error());
}

void ManipulationSession::update() {
  if (stopping_for_ && !moving())
    publish_status(*std::exchange(stopping_for_, {}), true,
                   {Outcome::kCancelled, "it did not run; the robot was stopped"});
  start_waiting();
  if (!current_) return;
  if (executor_.state == executor::ExecutorState::kFault) return end_in_fault();
  if (request_->publisher_count() == 0 && !std::exchange(abandoned_, true)) {
    node_.log().error("whoever asked for '{}' is gone: stopping", current_->action().name());
    runner_.cancel();
  }
  const ActionRunner::Orders orders = runner_.update(perception_.view(node_.now().nanoseconds), executor_);
  if (orders.stop) send_stop();
  if (orders.send) trajectory_->publish(to_message(*orders.send));
  report();
}

// The executor holds until a person resets it: no other way to carry out the action would help.
void ManipulationSession::end_in_fault() {
  runner_.cancel();
  // The first call ends what is planned, the second what was moving.
  for (int i = 0; i < 2 && runner_.running(); ++i) {
    static_cast<void>(runner_.update(perception_.view(node_.now().nanoseconds), executor_));
  }
  const Error fault = fault_.message.empty()
                          ? Error{Outcome::kMotionFailed,
                                  "the executor is in fault; send \"reset\" on the topic executor_command"}
                          : fault_;
  publish_status(*std::exchange(current_, {}), true, fault);
}

void ManipulationSession::report() {
  if (runner_.finished()) {
    publish_status(*std::exchange(current_, {}), true, runner_.result());
    return start_waiting();
  }
  if (runner_.stage() == reported_stage_ && node_.now() - reported_at_ < kReportPeriod) return;
  publish_status(*current_, false, {Outcome::kDone, ""});
}

void ManipulationSession::publish_status(const ActionRequest& request, bool finished, const Error& result) {
  ActionStatus status;
  status.header().stamp(node_.now());
  status.instruction_id(request.instruction_id());
  status.step(request.step());
  status.index(request.index());
  status.state(finished ? goalnet_msgs::msg::ActionStatus_Constants::FINISHED
                        : goalnet_msgs::msg::ActionStatus_Constants::RUNNING);
  status.stage(runner_.stage());
  status.progress(runner_.progress());
  status.planning_time(runner_.planning_time_s());
  status.outcome(static_cast<std::int32_t>(result.outcome));
  status.message(result.message);
  reported_stage_ = runner_.stage();
  reported_at_ = node_.now();
  if (finished) last_ = status;
  status_->publish(status);
}

}  // namespace goalnet::manipulation
