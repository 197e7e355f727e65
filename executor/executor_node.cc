#include "executor/executor_node.h"

#include <chrono>
#include <utility>

#include "components/messages/conversions.h"

namespace goalnet::executor {
namespace {

constexpr std::chrono::milliseconds kReportPeriod{20};

bool busy(ExecutorState state) {
  return state == ExecutorState::kExecuting || state == ExecutorState::kStopping;
}

bool tells_the_same(const ExecutorStatus& a, const ExecutorStatus& b) {
  return a.state == b.state && a.trajectory_id == b.trajectory_id && a.outcome == b.outcome &&
         a.message == b.message;
}

}  // namespace

Expected<std::unique_ptr<ExecutorNode>> ExecutorNode::create(ros::Node& node) {
  auto params = declare_parameters(node);
  if (!params) return tl::unexpected<Error>(params.error());
  auto executor = TrajectoryExecutor::create(params->core);
  if (!executor) return tl::unexpected<Error>(executor.error());
  auto made = std::unique_ptr<ExecutorNode>(new ExecutorNode(node, std::move(*params), std::move(*executor)));
  made->open_topics();
  return made;
}

ExecutorNode::ExecutorNode(ros::Node& node, NodeParams params, std::unique_ptr<TrajectoryExecutor> executor)
    : node_(node), params_(std::move(params)), executor_(std::move(executor)), reader_(params_.core.joints) {}

ExecutorNode::~ExecutorNode() = default;

void ExecutorNode::open_topics() {
  status_publisher_ =
      node_.advertise<goalnet_msgs::msg::ExecutorStatus>("executor_status", ros::Qos::latched());
  command_publisher_ =
      node_.advertise<sensor_msgs::msg::JointState>("joint_commands", ros::Qos::standard().keep_last(1));
  trajectory_ = node_.subscribe<trajectory_msgs::msg::JointTrajectory>(
      "joint_trajectory", ros::Qos::standard(), [this](const auto& message) { on_trajectory(message); });
  command_ = node_.subscribe<std_msgs::msg::String>("executor_command", ros::Qos::standard(),
                                                    [this](const auto& message) { on_command(message); });
  if (params_.lockstep) {
    timer_ = node_.create_timer(kReportPeriod, [this] { report(); });
    return;
  }
  // On the wall clock reports follow it even if the node uses simulated time: when a simulator dies, its time
  // stands still, and that is when a fault has to be told.
  timer_ = ros::Timer::create(node_.loop(), wall_clock_, kReportPeriod, [this] { report(); });

  joint_states_ = node_.subscribe<sensor_msgs::msg::JointState>(
      "joint_states", ros::Qos::standard(), [this](const auto& message) { on_joint_states(message); });
  loop_ = std::make_unique<WallClockLoop>(*executor_, params_.thread, params_.command_period,
                                          [this](const JointSample& command) {
                                            auto message = to_message(command, params_.core.joints);
                                            message.header().stamp(node_.now());
                                            command_publisher_->publish(message);
                                          });
  if (const auto warning = loop_->start()) node_.log().warn("{}", *warning);
}

ExecutorNode::Hook ExecutorNode::lockstep_hook() {
  return [this](std::int64_t time_ns, const JointSample& measured, JointSample& command) {
    executor_->cycle(time_ns, measured, command);
  };
}

void ExecutorNode::on_trajectory(const trajectory_msgs::msg::JointTrajectory& message) {
  const auto accepted = executor_->submit(from_message(message));
  if (accepted) return;
  refuse(messages::to_nanoseconds(message.header().stamp()), accepted.error().outcome,
         accepted.error().message);
}

void ExecutorNode::on_command(const std_msgs::msg::String& message) {
  if (message.data() == "stop") {
    executor_->stop();
  } else if (message.data() == "emergency_stop") {
    executor_->emergency_stop();
  } else if (message.data() == "reset") {
    executor_->reset();
  } else {
    node_.log().warn("unknown executor command '{}'; there are stop, emergency_stop and reset",
                     message.data().substr(0, 40));
    return;
  }
  node_.log().info("command: {}", message.data());
}

void ExecutorNode::on_joint_states(const sensor_msgs::msg::JointState& message) {
  if (const auto read = reader_.read(message); !read) {
    // One line for the first of a flood, then one for every thousand.
    if (bad_joint_states_++ % 1000 == 0)
      node_.log().warn("{} ({} so far)", read.error().message, bad_joint_states_);
    return;
  }
  if (reader_.complete()) loop_->set_measured(reader_.sample());
}

void ExecutorNode::report() {
  ExecutorStatus status = executor_->status();
  // The topic keeps one message: a refusal gets a period of its own, or the next report would push it out.
  if (std::exchange(refused_lately_, false)) return;
  if (reported_ && status.rejections > reported_->rejections) {
    refuse(status.rejected_stamp_ns, status.rejected_outcome, status.rejected_message);
    reported_->rejections = status.rejections;
    refused_lately_ = false;  // the next report is a period away already
    return;
  }
  if (reported_ && !busy(status.state) && tells_the_same(status, *reported_)) return;
  if (!reported_ || status.state != reported_->state) {
    if (status.state == ExecutorState::kFault) node_.log().error("fault: {}", status.message);
    if (status.state == ExecutorState::kIdle && status.outcome == Outcome::kMotionFailed)
      node_.log().warn("motion failed: {}", status.message);
  }
  reported_ = status;
  publish(std::move(status));
}

void ExecutorNode::refuse(std::int64_t stamp_ns, Outcome outcome, const std::string& message) {
  node_.log().warn("{}", message);
  refused_lately_ = true;
  ExecutorStatus answer = executor_->status();
  answer.trajectory_stamp_ns = stamp_ns;
  answer.progress = 0.0;
  answer.outcome = outcome;
  answer.message = message;
  publish(std::move(answer));
}

void ExecutorNode::publish(ExecutorStatus status) {
  auto message = to_message(status);
  message.header().stamp(node_.now());
  status_publisher_->publish(message);
}

}  // namespace goalnet::executor
