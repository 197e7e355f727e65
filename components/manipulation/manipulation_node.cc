#include "components/manipulation/manipulation_node.h"

#include <chrono>
#include <utility>

#include "components/messages/conversions.h"

namespace goalnet::manipulation {
namespace {

using goalnet_msgs::msg::ActionRequest;
using goalnet_msgs::msg::ActionStatus;

constexpr std::chrono::milliseconds kUpdatePeriod{10};
constexpr std::chrono::milliseconds kReportPeriod{100};

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

// Parameters until the first that makes no sense.
struct Declared {
  std::string scene = "kitchen";
  std::string robot = "default";
  ManipulationParams core;
};

Expected<Declared> declare_parameters(ros::Node& node) {
  Declared params;
  Expected<void> result;
  const auto declare = [&]<class T>(const char* name, T& value, ros::ParameterDescriptor descriptor) {
    if (!result) return;
    descriptor.read_only = true;
    const auto declared = node.declare_parameter<T>(name, value, descriptor);
    if (declared) {
      value = *declared;
    } else {
      result = tl::unexpected<Error>(declared.error());
    }
  };
  const auto described = [](const char* text, double from, double to, double step = 0.0) {
    ros::ParameterDescriptor descriptor;
    descriptor.description = text;
    descriptor.range = ros::ParameterRange{from, to, step};
    return descriptor;
  };
  declare(
      "scene", params.scene,
      {.description = "Scene: a name in config/scenes or a file", .range = {}, .additional_constraints = ""});
  declare(
      "robot", params.robot,
      {.description = "Robot: a name in config/robots or a file", .range = {}, .additional_constraints = ""});
  declare("speed", params.core.speed,
          described("Part of the joints' velocity limits that is used", 0.05, 1.0));
  declare("acceleration", params.core.acceleration, described("The same of acceleration limits", 0.05, 1.0));
  declare("margin", params.core.margin,
          described("Distance kept from obstacles in free motion [m]", 0.0, 0.1));
  declare("attempts", params.core.attempts,
          described("Different ways tried before an action fails", 1.0, 100.0, 1.0));
  if (!result) return tl::unexpected<Error>(std::move(result.error()));
  return params;
}

}  // namespace

Expected<std::unique_ptr<ManipulationNode>> ManipulationNode::create(ros::Node& node) {
  const auto params = declare_parameters(node);
  if (!params) return tl::unexpected<Error>(params.error());
  auto scene = scene::load_scene(params->scene);
  if (!scene) return tl::unexpected<Error>(std::move(scene.error()));
  auto robot = robot::load_robot(params->robot);
  if (!robot) return tl::unexpected<Error>(std::move(robot.error()));
  auto bench = Workbench::create(std::move(*robot), std::move(*scene), params->core);
  if (!bench) return tl::unexpected<Error>(std::move(bench.error()));
  auto made = std::unique_ptr<ManipulationNode>(new ManipulationNode(node, std::move(*bench)));
  made->open_topics();
  return made;
}

ManipulationNode::ManipulationNode(ros::Node& node, std::unique_ptr<Workbench> bench)
    : node_(node), bench_(std::move(bench)), runner_(*bench_), perception_(bench_->model()) {
  bench_->set_stop_check([this] { return interrupted_.load(); });
}

void ManipulationNode::open_topics() {
  status_ = node_.advertise<ActionStatus>("action_status");
  trajectory_ = node_.advertise<trajectory_msgs::msg::JointTrajectory>("joint_trajectory");
  command_ = node_.advertise<std_msgs::msg::String>("executor_command");
  const ros::Qos standard = ros::Qos::standard();
  request_ = node_.subscribe<ActionRequest>("action_request", standard,
                                            [this](const auto& message) { on_request(message); });
  // Planning keeps the event loop busy: a cancel must reach it from outside.
  cancel_at_once_ = node_.subscribe<ActionRequest>(
      "action_request", standard,
      [this](const ActionRequest& message) {
        if (message.command() == goalnet_msgs::msg::ActionRequest_Constants::CANCEL) interrupt();
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
void ManipulationNode::perceive(const char* topic, const Message& message) {
  const auto taken = perception_.take(message);
  if (taken || bad_messages_++ % 1000 != 0) return;  // one line for the first of a flood
  node_.log().warn("{} dropped: {} ({} so far)", topic, taken.error().message, bad_messages_);
}

void ManipulationNode::on_executor_status(const goalnet_msgs::msg::ExecutorStatus& message) {
  executor_ = from_message(message);
  // A trajectory refused because of the fault is answered in the same state with the refusal's outcome: not
  // the cause.
  const bool cause = executor_.outcome >= Outcome::kMotionFailed;
  if (executor_.state == executor::ExecutorState::kFault && cause)
    fault_ = {executor_.outcome, executor_.message};
  if (executor_.state != executor::ExecutorState::kFault) fault_ = {};
  update();
}

void ManipulationNode::on_request(const ActionRequest& message) {
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

void ManipulationNode::on_cancel(const ActionRequest& message) {
  if (waiting_ && same_request(*waiting_, message)) {
    waiting_.reset();
    publish_status(message, true, {Outcome::kCancelled, "cancelled before it began"});
  } else if (current_ && same_request(*current_, message)) {
    runner_.cancel();
    update();
  } else if (last_ && answers(*last_, message)) {
    status_->publish(*last_);
  } else {
    publish_status(message, true, {Outcome::kCancelled, "it did not run"});
  }
}

void ManipulationNode::start_waiting() {
  if (!waiting_ || current_ || !perception_.complete()) return;
  current_ = std::exchange(waiting_, {});
  interrupted_ = false;
  reported_stage_.clear();
  const auto started = runner_.start(messages::from_message(current_->action()));
  if (!started) publish_status(*std::exchange(current_, {}), true, started.error());
}

void ManipulationNode::update() {
  start_waiting();
  if (!current_) return;
  if (executor_.state == executor::ExecutorState::kFault) return end_in_fault();
  const ActionRunner::Orders orders = runner_.update(perception_.view(node_.now().nanoseconds), executor_);
  if (orders.stop) {
    std_msgs::msg::String stop;
    stop.data("stop");
    command_->publish(stop);
  }
  if (orders.send) trajectory_->publish(to_message(*orders.send));
  report();
}

// The executor holds until a person resets it: no other way to carry out the action would help.
void ManipulationNode::end_in_fault() {
  runner_.cancel();
  // The first call ends what is planned, the second what was moving.
  for (int i = 0; i < 2 && runner_.running(); ++i) {
    static_cast<void>(runner_.update(perception_.view(node_.now().nanoseconds), executor_));
  }
  const Error fault =
      fault_.message.empty() ? Error{Outcome::kMotionFailed, "the executor is in fault; reset it"} : fault_;
  publish_status(*std::exchange(current_, {}), true, fault);
}

void ManipulationNode::report() {
  if (runner_.finished()) {
    publish_status(*std::exchange(current_, {}), true, runner_.result());
    return start_waiting();
  }
  if (runner_.stage() == reported_stage_ && node_.now() - reported_at_ < kReportPeriod) return;
  publish_status(*current_, false, {Outcome::kDone, ""});
}

void ManipulationNode::publish_status(const ActionRequest& request, bool finished, const Error& result) {
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
