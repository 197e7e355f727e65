#include "components/world_model/world_model_session.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "components/messages/conversions.h"

namespace goalnet::world_model {
namespace {

constexpr std::chrono::milliseconds kPublishPeriod{100};
// Wall-clock time without any observation that is reported. Long enough for a planner that thinks while
// simulated time stands still.
constexpr std::chrono::seconds kSilence{10};
constexpr std::int64_t kSecond = 1'000'000'000;
constexpr std::int64_t kStaleReportPeriod = 5 * kSecond;

std::int64_t nanoseconds(double seconds) { return static_cast<std::int64_t>(1e9 * seconds); }

scene::Pose from_message(const geometry_msgs::msg::Pose& message) {
  const auto& q = message.orientation();
  const Eigen::Quaterniond rotation(q.w(), q.x(), q.y(), q.z());
  scene::Pose pose = scene::Pose::Identity();
  // A quaternion of no length becomes not-a-number here, and the observation is left out.
  pose.linear() = Eigen::Quaterniond(rotation.coeffs() / rotation.norm()).toRotationMatrix();
  pose.translation() =
      Eigen::Vector3d(message.position().x(), message.position().y(), message.position().z());
  return pose;
}

}  // namespace

WorldModelSession::WorldModelSession(ros::Node& node, const scene::Scene& scene,
                                     const robot::RobotModel& robot, const SessionParams& params)
    : node_(node),
      scene_(scene),
      robot_(robot),
      params_(params),
      model_(std::make_unique<WorldModel>(scene_, robot_, params_.core)),
      opened_ns_(node.now().nanoseconds) {
  open_topics();
}

void WorldModelSession::open_topics() {
  publisher_ = node_.advertise<goalnet_msgs::msg::WorldState>("world_state", ros::Qos::latched());
  joints_ = node_.subscribe<sensor_msgs::msg::JointState>(
      "joint_states", ros::Qos::standard(), [this](const auto& message) { on_joints(message); });
  object_states_ = node_.subscribe<goalnet_msgs::msg::ObjectStates>(
      "object_states", ros::Qos::latched(), [this](const auto& message) { on_states(message); });
  poses_ = node_.subscribe<goalnet_msgs::msg::ObjectPoses>(
      "object_poses", ros::Qos::standard(), [this](const auto& message) { on_poses(message); });
  timer_ = node_.create_timer(kPublishPeriod, [this] { publish_regularly(); });
  silence_timer_ = ros::Timer::create(node_.loop(), wall_clock_, kSilence, [this] { watch_for_silence(); });
}

void WorldModelSession::on_poses(const goalnet_msgs::msg::ObjectPoses& message) {
  if (message.objects().size() > messages::kMaxObjects)
    return report_ignored("object_poses", message.objects().size());
  ObservedPoses observed{messages::to_nanoseconds(message.header().stamp()), {}};
  observed.objects.reserve(message.objects().size());
  for (const auto& object : message.objects())
    observed.objects.push_back({object.name(), from_message(object.pose())});
  start_over_if_time_jumped_back(poses_ns_, observed.time_ns);
  poses_ns_ = observed.time_ns;
  ++observations_;
  report_ignored("object_poses", model_->observe(observed));
  if (!computed_ns_ || poses_ns_ - *computed_ns_ >= nanoseconds(1.0 / params_.rate)) update();
}

void WorldModelSession::on_joints(const sensor_msgs::msg::JointState& message) {
  const std::int64_t time_ns = messages::to_nanoseconds(message.header().stamp());
  const bool of_the_robot = std::any_of(message.name().begin(), message.name().end(),
                                        [&](const auto& name) { return robot_.index_of(name) >= 0; });
  if (of_the_robot) start_over_if_time_jumped_back(joints_ns_, time_ns);
  ++observations_;
  report_ignored("joint_states",
                 model_->observe(ObservedJoints{time_ns, message.name(), message.position()}));
  joints_ns_ = model_->joints_time_ns();
}

void WorldModelSession::on_states(const goalnet_msgs::msg::ObjectStates& message) {
  if (message.objects().size() > messages::kMaxObjects)
    return report_ignored("object_states", message.objects().size());
  std::size_t values = 0;
  for (const auto& object : message.objects()) values += object.values().size();
  if (values > messages::kMaxObjects) return report_ignored("object_states", values);
  states_.clear();
  for (const auto& object : message.objects()) states_.push_back({object.name(), object.values()});
  report_ignored("object_states", model_->observe(states_));
  update();
}

void WorldModelSession::update() {
  if (!model_->complete()) return;
  computed_ns_ = poses_ns_;
  const WorldState& world = model_->update();
  if (!published_ || world.facts != published_->facts) publish();
}

void WorldModelSession::publish_regularly() {
  const std::int64_t now = node_.now().nanoseconds, limit = nanoseconds(params_.stale_after);
  const bool poses_stale = now - poses_ns_ > limit, joints_stale = now - joints_ns_ > limit;
  if (!model_->complete() || poses_stale || joints_stale) {
    if (stale_reported_ns_ && now - *stale_reported_ns_ < kStaleReportPeriod) return;
    if (!stale_reported_ns_ && !published_ && now - opened_ns_ < kStaleReportPeriod) return;  // just starting
    stale_reported_ns_ = now;
    node_.log().error(
        "the world is not known: no {} for more than {} s; is the simulator or the perception running?",
        poses_stale && joints_stale ? "object_poses and joint_states"
        : poses_stale               ? "object_poses"
                                    : "joint_states",
        params_.stale_after);
    return;
  }
  if (stale_reported_ns_) node_.log().info("the world is known again");
  stale_reported_ns_.reset();
  if (computed_ns_ != poses_ns_) update();
  if (model_->time_ns() > published_ns_) publish();
}

void WorldModelSession::diagnose(ros::DiagnosticReport& report) const {
  const double age = 1e-9 * static_cast<double>(node_.now().nanoseconds - std::min(poses_ns_, joints_ns_));
  report.threshold("age of observations", age, 0.5 * params_.stale_after, params_.stale_after, "s");
  report.add("messages with entries left out", std::to_string(ignored_reports_));
  if (!model_->complete() || silence_reported_)
    report.summary(ros::DiagnosticLevel::kStale, "the world is not known: nothing is observed");
}

// When a simulator dies, its time stands still, and nothing ever becomes stale by it. So silence is also
// watched for on the wall clock.
void WorldModelSession::watch_for_silence() {
  const bool silent = observations_ == observations_before_;
  observations_before_ = observations_;
  if (silent && !silence_reported_)
    node_.log().error(
        "nothing was observed for {} s of real time; is the simulator or the perception running?",
        kSilence.count());
  silence_reported_ = silent;
}

void WorldModelSession::publish() {
  goalnet_msgs::msg::WorldState message;
  message.header().stamp(messages::to_stamp(model_->time_ns()));
  message.header().frame_id("map");
  messages::fill(message, model_->world());
  publisher_->publish(message);
  published_ = model_->world();
  published_ns_ = model_->time_ns();
}

// A simulator that was started anew counts from zero; the old history means nothing then. Each topic is
// compared with itself: cameras may be seconds behind the joints, which is no jump.
void WorldModelSession::start_over_if_time_jumped_back(std::int64_t last_ns, std::int64_t time_ns) {
  if (time_ns >= last_ns - kSecond) return;
  jumps_.write([&](const std::string& more) {
    node_.log().warn("time jumped back by {:.1f} s: starting over{}",
                     1e-9 * static_cast<double>(last_ns - time_ns), more);
  });
  model_ = std::make_unique<WorldModel>(scene_, robot_, params_.core);
  static_cast<void>(model_->observe(states_));
  poses_ns_ = joints_ns_ = time_ns;
  computed_ns_.reset();
  published_.reset();
  published_ns_ = 0;
}

void WorldModelSession::report_ignored(const char* topic, std::size_t count) {
  if (count == 0) return;
  // One line for the first of a flood, then one for every thousand.
  if (ignored_reports_++ % 1000 == 0)
    node_.log().warn("{}: {} entries make no sense and are left out (report {})", topic, count,
                     ignored_reports_);
}

}  // namespace goalnet::world_model
