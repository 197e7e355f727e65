#include "components/manipulation/workbench.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace goalnet::manipulation {

using Eigen::Vector3d;

double tilt_of(const Pose& pose) { return std::acos(std::clamp(pose.linear()(2, 2), -1.0, 1.0)); }

std::vector<Pose> interpolate(const Pose& from, const Pose& to, double step, double turn) {
  const double distance = (to.translation() - from.translation()).norm();
  const Eigen::Quaterniond a(from.linear()), b(to.linear());
  const int n = std::max({1, static_cast<int>(std::ceil(distance / step)),
                          static_cast<int>(std::ceil(a.angularDistance(b) / turn))});
  std::vector<Pose> out;
  for (int i = 1; i <= n; ++i) {
    const double u = static_cast<double>(i) / n;
    Pose pose = Pose::Identity();
    pose.translation() = (1 - u) * from.translation() + u * to.translation();
    pose.linear() = a.slerp(u, b).toRotationMatrix();
    out.push_back(i == n ? to : pose);
  }
  return out;
}

Workbench::Workbench(robot::RobotModel model, scene::Scene scene, ManipulationParams params)
    : model_(std::move(model)),
      scene_(std::move(scene)),
      params_(params),
      kinematics_(model_),
      checker_(model_, kinematics_, scene_) {}

Expected<std::unique_ptr<Workbench>> Workbench::create(robot::RobotModel model, scene::Scene scene,
                                                       ManipulationParams params) {
  std::unique_ptr<Workbench> out(new Workbench(std::move(model), std::move(scene), params));
  const auto& m = out->model_;
  for (const auto& arm : m.arms) {
    auto kinematics = robot::ArmKinematics::create(m, arm);
    if (!kinematics) return tl::unexpected<Error>(kinematics.error());
    out->arms_.push_back(std::move(*kinematics));
    out->tool_links_.push_back(out->kinematics_.link_index(arm.tool_link));
    out->arm_base_links_.push_back(out->kinematics_.link_index(arm.base_link));
    const auto first = out->kinematics_.link_index(m.urdf->getJoint(arm.joints.front())->child_link_name);
    const Pose base = out->kinematics_.forward(m.home(), out->kinematics_.link_index(m.base.link));
    out->sides_.push_back((base.inverse() * out->kinematics_.forward(m.home(), first)).translation().y());
  }
  out->base_x_ = m.index_of(m.base.x);
  out->base_y_ = m.index_of(m.base.y);
  out->base_yaw_ = m.index_of(m.base.yaw);
  out->lift_ = m.lift.empty() ? -1 : m.index_of(m.lift);
  out->held_.resize(m.arms.size());
  out->carry_.resize(m.arms.size());
  out->hindered_.resize(m.arms.size());
  out->now_ = m.home();
  return out;
}

void Workbench::observe(const WorldView& world) {
  world_ = world;
  now_ = world.robot;
  if (command_.size() == now_.size()) {
    for (std::size_t j = 0; j < now_.size(); ++j) {
      // Motions start at the command. A joint far from it was moved by somebody else: believe the
      // measurement.
      const bool finger = std::any_of(model_.arms.begin(), model_.arms.end(), [&](const robot::Arm& arm) {
        const auto& f = arm.gripper.fingers;
        return std::find(f.begin(), f.end(), model_.joints[j].name) != f.end();
      });
      if (!finger && std::abs(command_[j] - now_[j]) < 0.08) now_[j] = command_[j];
    }
  }
  for (std::size_t arm = 0; arm < held_.size(); ++arm) {
    if (!held_[arm]) continue;
    const Pose* pose = world.object(held_[arm]->name);
    if (pose == nullptr) continue;
    held_[arm]->object_in_tool = tool_pose(world.robot, arm).inverse() * *pose;
  }
  checker_.update(world_, held_);
}

void Workbench::set_held(std::size_t arm, const std::optional<std::string>& object) {
  held_[arm].reset();
  carry_[arm].reset();
  if (object) held_[arm] = HeldObject{*object, Pose::Identity()};
  observe(WorldView(world_));
}

void Workbench::suppose_grip(std::size_t arm, const Pose& object_in_tool) {
  before_.push_back({held_, false});
  held_[arm]->object_in_tool = object_in_tool;
  checker_.update(world_, held_);
}

void Workbench::suppose_held(std::size_t arm, const std::string& object, const Pose& object_in_tool) {
  before_.push_back({held_, false});
  held_[arm] = HeldObject{object, object_in_tool};
  checker_.update(world_, held_);
}

void Workbench::suppose_put_down(std::size_t arm) {
  before_.push_back({held_, true});
  std::vector<std::string> gone{held_[arm]->name};
  for (const Predicate& fact : world_.facts)
    if ((fact.relation == "In" || fact.relation == "On") && fact.object == gone.front())
      gone.push_back(fact.subject);
  checker_.leave_out(gone);
  held_[arm].reset();
  checker_.update(world_, held_);
}

void Workbench::end_supposition() {
  if (before_.back().leaves_out) checker_.leave_out({});
  held_ = std::move(before_.back().held);
  before_.pop_back();
  checker_.update(world_, held_);
}

std::optional<std::size_t> Workbench::arm_holding(const std::string& object) const {
  for (std::size_t arm = 0; arm < held_.size(); ++arm) {
    if (held_[arm] && held_[arm]->name == object) return arm;
  }
  return std::nullopt;
}

void Workbench::set_command(const std::vector<std::string>& joints, const std::vector<double>& positions) {
  if (command_.size() != model_.joints.size()) command_ = now_;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const int j = model_.index_of(joints[i]);
    if (j >= 0) command_[static_cast<std::size_t>(j)] = positions[i];
  }
}

namespace {

// Much the same place: what did not work there will not work here.
bool same_place(const Stand& a, const Stand& b) {
  return std::hypot(a.x - b.x, a.y - b.y) < 0.12 &&
         std::abs(std::remainder(a.yaw - b.yaw, 2 * std::numbers::pi)) < 0.25;
}

}  // namespace

bool Workbench::leads_nowhere(const Stand& stand) const {
  return std::any_of(dead_ends_.begin(), dead_ends_.end(), [&](const DeadEnd& end) {
    return !end.arm && same_place(end.stand, stand) && std::abs(end.stand.lift - stand.lift) < 0.1;
  });
}

bool Workbench::leads_nowhere(const Stand& stand, std::size_t arm, const ArmPositions& posture) const {
  return std::any_of(dead_ends_.begin(), dead_ends_.end(), [&](const DeadEnd& end) {
    return end.arm == arm && same_place(end.stand, stand) && robot::largest_step(end.posture, posture) < 0.6;
  });
}

Stand Workbench::stand_of(const Configuration& q) const {
  const auto at = [&](int j) { return j < 0 ? 0.0 : q[static_cast<std::size_t>(j)]; };
  return {at(base_x_), at(base_y_), at(base_yaw_), at(lift_)};
}

Configuration Workbench::with_stand(Configuration q, const Stand& stand) const {
  q[static_cast<std::size_t>(base_x_)] = stand.x;
  q[static_cast<std::size_t>(base_y_)] = stand.y;
  q[static_cast<std::size_t>(base_yaw_)] = stand.yaw;
  if (lift_ >= 0) q[static_cast<std::size_t>(lift_)] = stand.lift;
  return q;
}

ArmPositions Workbench::arm_of(const Configuration& q, std::size_t arm) const {
  ArmPositions out;
  for (std::size_t i = 0; i < 7; ++i) out[i] = q[static_cast<std::size_t>(arms_[arm].joints()[i])];
  return out;
}

Configuration Workbench::with_arm(Configuration q, std::size_t arm, const ArmPositions& positions) const {
  for (std::size_t i = 0; i < 7; ++i) q[static_cast<std::size_t>(arms_[arm].joints()[i])] = positions[i];
  return q;
}

Configuration Workbench::with_fingers(Configuration q, std::size_t arm, double opening) const {
  const auto& gripper = model_.arms[arm].gripper;
  const double each =
      std::clamp(opening / 2, std::min(gripper.closed, gripper.open), std::max(gripper.closed, gripper.open));
  for (const auto& finger : gripper.fingers) q[static_cast<std::size_t>(model_.index_of(finger))] = each;
  return q;
}

double Workbench::opening_of(const Configuration& q, std::size_t arm) const {
  double sum = 0;
  for (const auto& finger : model_.arms[arm].gripper.fingers)
    sum += q[static_cast<std::size_t>(model_.index_of(finger))];
  return sum * 2 / static_cast<double>(model_.arms[arm].gripper.fingers.size());
}

Pose Workbench::tool_pose(const Configuration& q, std::size_t arm) const {
  return kinematics_.forward(q, tool_links_[arm]);
}

Pose Workbench::arm_base_pose(const Configuration& q, std::size_t arm) const {
  return kinematics_.forward(q, arm_base_links_[arm]);
}

TimedJoints Workbench::timed(const std::vector<int>& joints, double speed) const {
  TimedJoints out;
  out.velocity.resize(static_cast<Eigen::Index>(joints.size()));
  out.acceleration.resize(static_cast<Eigen::Index>(joints.size()));
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const auto& joint = model_.joints[static_cast<std::size_t>(joints[i])];
    out.names.push_back(joint.name);
    out.velocity[static_cast<Eigen::Index>(i)] = joint.limits.velocity * params_.speed * speed;
    out.acceleration[static_cast<Eigen::Index>(i)] = joint.limits.acceleration * params_.acceleration * speed;
  }
  return out;
}

JointVector Workbench::pick(const Configuration& q, const std::vector<int>& joints) const {
  JointVector out(static_cast<Eigen::Index>(joints.size()));
  for (std::size_t i = 0; i < joints.size(); ++i) {
    out[static_cast<Eigen::Index>(i)] = q[static_cast<std::size_t>(joints[i])];
  }
  return out;
}

bool Workbench::contains_something(const std::string& vessel) const {
  const auto& contents = scene_.rules.contents;
  return std::any_of(world_.facts.begin(), world_.facts.end(), [&](const Predicate& fact) {
    if (fact.relation == "state")
      return fact.subject == vessel &&
             std::find(contents.begin(), contents.end(), fact.object) != contents.end();
    return (fact.relation == "In" || fact.relation == "On") && fact.object == vessel;
  });
}

double Workbench::tilt_limit(std::size_t arm) const {
  if (!held_[arm]) return std::numbers::pi;
  const auto* m = scene_.find_model_of(held_[arm]->name);
  if (m == nullptr) return params_.loose_tilt;
  const double limit =
      m->cavity && contains_something(held_[arm]->name) ? params_.upright_tilt : params_.loose_tilt;
  // Already leaning further (a plate held askew): do not make it worse, but allow to move it at all.
  const Pose pose = tool_pose(now_, arm) * held_[arm]->object_in_tool;
  return std::max(limit, tilt_of(pose) + 0.1);
}

bool Workbench::upright(const Configuration& q, std::size_t arm, double limit) const {
  if (!held_[arm] || limit >= std::numbers::pi) return true;
  return tilt_of(tool_pose(q, arm) * held_[arm]->object_in_tool) <= limit;
}

}  // namespace goalnet::manipulation
