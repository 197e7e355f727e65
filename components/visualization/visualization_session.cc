#include "components/visualization/visualization_session.h"

#include <chrono>
#include <cmath>
#include <utility>

#include "components/messages/conversions.h"

namespace goalnet::visualization {
namespace {

constexpr double kMoved = 0.001, kTurned = 0.01;  // [m, rad] smaller changes are not drawn
constexpr std::size_t kMostTrajectoryPoints = 100'000;

bool same_place(const Pose& a, const Pose& b) {
  return (a.translation() - b.translation()).norm() < kMoved &&
         Eigen::Quaterniond(a.linear()).angularDistance(Eigen::Quaterniond(b.linear())) < kTurned;
}

bool same_places(const Poses& a, const Poses& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& one, const auto& other) {
    return one.first == other.first && same_place(one.second, other.second);
  });
}

std::optional<Pose> from_message(const geometry_msgs::msg::Pose& message) {
  const auto& q = message.orientation();
  const Eigen::Quaterniond turn(q.w(), q.x(), q.y(), q.z());
  Pose pose = Pose::Identity();
  pose.translation() =
      Eigen::Vector3d(message.position().x(), message.position().y(), message.position().z());
  if (!(std::abs(turn.norm() - 1.0) < 0.1) || !pose.translation().allFinite()) return std::nullopt;
  pose.linear() = turn.normalized().toRotationMatrix();
  return pose;
}

}  // namespace

VisualizationSession::VisualizationSession(ros::Node& node, const scene::Scene& scene,
                                           const robot::RobotModel& robot, double rate)
    : node_(node), scene_(scene), robot_(robot), kinematics_(robot_), joints_(robot_.home()) {
  open_topics(rate);
}

// What comes seldom, and what is latched, is always listened to: what was latched before a reader exists
// reaches it some time later, from a DDS thread, and in lockstep nothing may depend on when.
void VisualizationSession::open_topics(double rate) {
  markers_ = node_.advertise<visualization_msgs::msg::MarkerArray>("markers", ros::Qos::latched());
  world_state_ = node_.subscribe<goalnet_msgs::msg::WorldState>(
      "world_state", ros::Qos::latched(), [this](const auto& message) { on_world(message); });
  status_ = node_.subscribe<goalnet_msgs::msg::InstructionStatus>(
      "instruction_status", ros::Qos::latched(), [this](const auto& message) { on_status(message); });
  trajectory_ = node_.subscribe<trajectory_msgs::msg::JointTrajectory>(
      "joint_trajectory", ros::Qos::standard(), [this](const auto& message) { on_trajectory(message); });
  const auto period = std::chrono::nanoseconds(std::llround(1e9 / rate));
  timer_ = node_.create_timer(period, [this] { look(); });
}

void VisualizationSession::look() {
  if (markers_->subscriber_count() == 0) return stop_watching();
  if (!watched()) start_watching();
  if (changed_ && !poses_.empty()) publish();
}

void VisualizationSession::start_watching() {
  changed_ = true;
  object_poses_ = node_.subscribe<goalnet_msgs::msg::ObjectPoses>(
      "object_poses", ros::Qos::standard().keep_last(1), [this](const auto& message) { on_poses(message); });
  joint_states_ = node_.subscribe<sensor_msgs::msg::JointState>(
      "joint_states", ros::Qos::standard().keep_last(1), [this](const auto& message) { on_joints(message); });
}

void VisualizationSession::stop_watching() {
  object_poses_.reset();
  joint_states_.reset();
  poses_.clear();
  path_.clear();
}

void VisualizationSession::on_poses(const goalnet_msgs::msg::ObjectPoses& message) {
  if (message.objects().size() > messages::kMaxObjects) return;
  Poses poses;
  for (const auto& object : message.objects()) {
    const auto pose = from_message(object.pose());
    if (pose && (scene_.find_object(object.name()) != nullptr || scene_.find_part(object.name())))
      poses.insert_or_assign(object.name(), *pose);
  }
  if (same_places(poses, poses_)) return;
  poses_ = std::move(poses);
  seen_ = message.header().stamp();
  changed_ = true;
}

void VisualizationSession::on_world(const goalnet_msgs::msg::WorldState& message) {
  const auto world = messages::from_message(message);
  if (!world || world->facts == facts_) return;
  facts_ = world->facts;
  changed_ = true;
}

void VisualizationSession::on_status(const goalnet_msgs::msg::InstructionStatus& message) {
  if (message.positive().size() > messages::kMaxGoalSize ||
      message.negative().size() > messages::kMaxGoalSize || message.plan().size() > messages::kMaxActions)
    return;
  task_ = {message.instruction(),
           message.stage(),
           message.message(),
           {messages::from_message(message.positive()), messages::from_message(message.negative())},
           messages::from_message(message.plan()),
           messages::from_message(message.current_action()),
           message.finished()};
  if (task_.finished) path_.clear();
  changed_ = true;
}

void VisualizationSession::on_trajectory(const trajectory_msgs::msg::JointTrajectory& message) {
  if (!watched() || message.points().size() > kMostTrajectoryPoints) return;
  PlannedMotion motion{message.joint_names(), {}};
  for (const auto& point : message.points()) motion.points.push_back(point.positions());
  path_.clear();
  draw_path(robot_, kinematics_, joints_, motion, path_);
  changed_ = true;
}

void VisualizationSession::on_joints(const sensor_msgs::msg::JointState& message) {
  if (message.name().size() != message.position().size()) return;
  for (std::size_t i = 0; i < message.name().size(); ++i) {
    const int index = robot_.index_of(message.name()[i]);
    if (index >= 0 && std::isfinite(message.position()[i]))
      joints_[static_cast<std::size_t>(index)] = message.position()[i];
  }
}

void VisualizationSession::publish() {
  std::vector<Drawing> drawings;
  draw_shapes(scene_, poses_, drawings);
  draw_facts(scene_, poses_, facts_, drawings);
  draw_task(scene_, poses_, facts_, task_, drawings);
  drawings.insert(drawings.end(), path_.begin(), path_.end());
  markers_->publish(writer_.write(drawings, seen_));
  changed_ = false;
}

}  // namespace goalnet::visualization
