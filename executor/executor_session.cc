#include "executor/executor_session.h"

#include <chrono>
#include <cmath>
#include <thread>
#include <utility>

#include "components/messages/conversions.h"

namespace goalnet::executor {
namespace {

constexpr std::chrono::milliseconds kReportPeriod{20};
constexpr std::chrono::milliseconds kLastWords{50};
// The slowest joint of the default robot stops from full speed in less than two seconds; giving way takes
// another three at most.
constexpr std::chrono::seconds kLongestStop{8};
constexpr std::chrono::milliseconds kHardStop{500};
constexpr std::chrono::milliseconds kHandOver{5};  // until the real-time thread has taken what was asked

bool busy(ExecutorState state) {
  return state == ExecutorState::kExecuting || state == ExecutorState::kStopping;
}

bool tells_the_same(const ExecutorStatus& a, const ExecutorStatus& b) {
  return a.state == b.state && a.trajectory_id == b.trajectory_id && a.outcome == b.outcome &&
         a.message == b.message;
}

}  // namespace

ExecutorSession::ExecutorSession(ros::Node& node, const NodeParams& params, TrajectoryExecutor& executor)
    : node_(node), params_(params), executor_(executor), reader_(params_.core.joints) {
  open_topics();
}

ExecutorSession::~ExecutorSession() {
  joint_states_.reset();  // feeds the loop from a thread of DDS
}

void ExecutorSession::leave() {
  trajectory_.reset();  // nothing new
  command_.reset();
  executor_.stop();
  // In lockstep the simulator's next ticks carry the stop out.
  const bool was_moving = loop_ ? wait_for_standstill() : busy(executor_.status().state);
  if (!was_moving) return;
  ExecutorStatus last = executor_.status();
  last.outcome = Outcome::kCancelled;
  last.message = "the executor was deactivated; the robot was stopped";
  publish(std::move(last));
  status_publisher_->wait_for_acknowledgments(kLastWords);
}

// Returns whether anything moved. Measurements still arrive: from a thread of DDS.
bool ExecutorSession::wait_for_standstill() {
  const auto pause = [](std::chrono::nanoseconds span) { std::this_thread::sleep_for(span); };
  pause(kHandOver);
  bool moved = false;
  const auto start = std::chrono::steady_clock::now();
  while (busy(executor_.status().state)) {
    moved = true;
    if (std::chrono::steady_clock::now() - start > kLongestStop) executor_.emergency_stop();
    pause(std::chrono::milliseconds(2));
  }
  if (executor_.status().outcome == Outcome::kEmergencyStop)
    pause(kHardStop);  // FAULT begins before it stands
  pause(std::chrono::nanoseconds(std::llround(2e9 * params_.command_period)));
  joint_states_.reset();
  loop_.reset();  // the last command, standing, has been sent
  return moved;
}

void ExecutorSession::open_topics() {
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

  loop_ = std::make_unique<WallClockLoop>(executor_, params_.thread, params_.command_period,
                                          [this](const JointSample& command) {
                                            auto message = to_message(command, params_.core.joints);
                                            message.header().stamp(node_.now());
                                            command_publisher_->publish(message);
                                          });
  // At once, not when the event loop finds time: it may be busy, for example waiting for a stop.
  joint_states_ = node_.subscribe<sensor_msgs::msg::JointState>(
      "joint_states", ros::Qos::standard(), [this](const auto& message) { on_joint_states(message); },
      {.immediate = true});
  if (const auto warning = loop_->start()) node_.log().warn("{}", *warning);
}

void ExecutorSession::on_trajectory(const trajectory_msgs::msg::JointTrajectory& message) {
  const std::int64_t stamp = messages::to_nanoseconds(message.header().stamp());
  if (stamp != 0 && stamp == last_stamp_) return;  // sent again by one who has not heard our answer yet
  last_stamp_ = stamp;
  const auto accepted = executor_.submit(from_message(message));
  if (accepted) return;
  refuse(messages::to_nanoseconds(message.header().stamp()), accepted.error().outcome,
         accepted.error().message);
}

void ExecutorSession::on_command(const std_msgs::msg::String& message) {
  if (message.data() == "stop") {
    executor_.stop();
  } else if (message.data() == "emergency_stop") {
    executor_.emergency_stop();
  } else if (message.data() == "reset") {
    executor_.reset();
  } else {
    unknown_lines_.write([&](const std::string& more) {
      node_.log().warn("unknown executor command '{}'; there are stop, emergency_stop and reset{}",
                       message.data().substr(0, 40), more);
    });
    return;
  }
  command_lines_.write(
      [&](const std::string& more) { node_.log().info("command: {}{}", message.data(), more); });
}

void ExecutorSession::on_joint_states(const sensor_msgs::msg::JointState& message) {
  static const TimeSource time = steady_time_source();
  if (const auto read = reader_.read(message, time.now_ns()); !read) {
    joint_state_lines_.write(
        [&](const std::string& more) { node_.log().warn("{}{}", read.error().message, more); });
    return;
  }
  if (reader_.complete()) loop_->set_measured(reader_.sample());
}

void ExecutorSession::report() {
  ExecutorStatus status = executor_.status();
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

void ExecutorSession::refuse(std::int64_t stamp_ns, Outcome outcome, const std::string& message) {
  refusal_lines_.write([&](const std::string& more) { node_.log().warn("{}{}", message, more); });
  refused_lately_ = true;
  ExecutorStatus answer = executor_.status();
  answer.trajectory_stamp_ns = stamp_ns;
  answer.progress = 0.0;
  answer.outcome = outcome;
  answer.message = message;
  publish(std::move(answer));
}

void ExecutorSession::publish(ExecutorStatus status) {
  auto message = to_message(status);
  message.header().stamp(node_.now());
  status_publisher_->publish(message);
}

}  // namespace goalnet::executor
