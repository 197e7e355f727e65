#include "sim/grasping.h"

#include <algorithm>
#include <cmath>

#include "sim/bullet_convert.h"

namespace goalnet::sim {
namespace {

constexpr double kTouch = 0.0015;        // [m] pads nearer than this touch
constexpr double kLetGo = 0.002;         // [m] commanded opening beyond the held width that opens the grasp
constexpr double kLoadSmoothing = 0.01;  // [s]

}  // namespace

Grasping::Grasping(Physics& physics, ArticulatedBody& robot, const RobotLinks& links,
                   const robot::RobotModel& model, RobotServo& servo, Movables& movables,
                   const WorldOptions& options)
    : physics_(physics), robot_(robot), servo_(servo), movables_(movables), options_(options) {
  for (const auto& arm : model.arms) {
    Hand hand;
    hand.arm = arm.name;
    const MergedLink tool = links.merged.at(arm.tool_link);
    hand.link = static_cast<std::size_t>(tool.link);
    hand.grip = tool.pose;
    for (const auto& finger : arm.gripper.fingers)
      hand.fingers.push_back(static_cast<std::size_t>(model.index_of(finger)));
    hands_.push_back(std::move(hand));
  }
}

Grasping::~Grasping() {
  for (auto& hand : hands_) {
    if (hand.constraint) physics_.world().removeMultiBodyConstraint(hand.constraint.get());
  }
}

int Grasping::enclosed(const Hand& hand) const {
  if (hand.fingers.size() != 2) return -1;
  // Mean normal of each finger's contacts with each object, pointing into the finger.
  struct Touch {
    int object;
    btVector3 normal[2] = {btVector3(0, 0, 0), btVector3(0, 0, 0)};
  };
  std::vector<Touch> touches;
  btDispatcher* dispatcher = physics_.world().getDispatcher();
  for (int m = 0; m < dispatcher->getNumManifolds(); ++m) {
    const btPersistentManifold* manifold = dispatcher->getManifoldByIndexInternal(m);
    if (manifold->getNumContacts() == 0) continue;
    for (int finger = 0; finger < 2; ++finger) {
      const btCollisionObject* pad = robot_.collider(hand.fingers[static_cast<std::size_t>(finger)]);
      const bool first = manifold->getBody0() == pad;
      if (!first && manifold->getBody1() != pad) continue;
      const int object = movables_.find(first ? manifold->getBody1() : manifold->getBody0());
      if (object < 0) continue;
      auto touch =
          std::find_if(touches.begin(), touches.end(), [&](const Touch& t) { return t.object == object; });
      if (touch == touches.end()) touch = touches.insert(touches.end(), Touch{object});
      for (int c = 0; c < manifold->getNumContacts(); ++c) {
        const btManifoldPoint& point = manifold->getContactPoint(c);
        if (point.getDistance() > kTouch) continue;
        touch->normal[finger] += first ? point.m_normalWorldOnB : -point.m_normalWorldOnB;
      }
    }
  }
  const Eigen::Matrix3d hand_axes = robot_.link_pose(hand.link).linear() * hand.grip.linear();
  const btVector3 closing = to_bullet(Eigen::Vector3d(hand_axes.col(1)));
  for (const auto& touch : touches) {
    const btScalar n0 = touch.normal[0].length(), n1 = touch.normal[1].length();
    if (n0 < 0.5 || n1 < 0.5) continue;
    const btVector3 a = touch.normal[0] / n0, b = touch.normal[1] / n1;
    // Opposite to each other, and on the pads rather than on the fingers' edges or tips.
    if (a.dot(b) > -std::cos(options_.grasp_angle)) continue;
    if (std::abs(a.dot(closing)) < 0.8 || std::abs(b.dot(closing)) < 0.8) continue;
    return touch.object;
  }
  return -1;
}

bool Grasping::presses(const Hand& hand) const {
  return std::all_of(hand.fingers.begin(), hand.fingers.end(), [&](std::size_t finger) {
    // Blocked: told to close further than the finger could, pressing with at least the least force.
    return servo_.target(finger) < robot_.position(finger) - 0.0005 &&
           -servo_.effort(finger) > options_.grasp_least_force;
  });
}

double Grasping::grip_force(const Hand& hand) const {
  double least = 1e9;
  for (std::size_t finger : hand.fingers) least = std::min(least, servo_.finger_force(finger));
  return least;
}

void Grasping::take(Hand& hand, int object) {
  btRigidBody& body = movables_.body(static_cast<std::size_t>(object));
  btMultiBody& robot = robot_.body();
  const int link = static_cast<int>(hand.link);
  const scene::Pose grip = robot_.link_pose(hand.link) * hand.grip;
  const btVector3 point = to_bullet(Eigen::Vector3d(grip.translation()));
  const btTransform hand_transform = robot_.collider(hand.link)->getWorldTransform();
  const btTransform body_transform = body.getCenterOfMassTransform();
  hand.constraint = std::make_unique<btMultiBodyFixedConstraint>(
      &robot, link, &body, hand_transform.inverse() * point, body_transform.inverse() * point,
      hand_transform.getBasis().transpose() * body_transform.getBasis(), btMatrix3x3::getIdentity());
  hand.object = object;
  hand.force = 0;
  hand.overloaded_for = 0;
  hand.opening = 0;
  // The pads press on, but against the thing that now belongs to the hand: they stay where they are.
  for (std::size_t finger : hand.fingers) {
    hand.opening += robot_.position(finger);
    servo_.hold(finger, true, robot_.position(finger));
    body.setIgnoreCollisionCheck(robot_.collider(finger), true);
  }
  body.setIgnoreCollisionCheck(robot_.collider(hand.link), true);
  physics_.forget_contacts(body);
  body.setActivationState(DISABLE_DEACTIVATION);
  physics_.world().addMultiBodyConstraint(hand.constraint.get());
}

void Grasping::release(Hand& hand) {
  if (hand.object < 0) return;
  btRigidBody& body = movables_.body(static_cast<std::size_t>(hand.object));
  physics_.world().removeMultiBodyConstraint(hand.constraint.get());
  hand.constraint.reset();
  for (std::size_t finger : hand.fingers) {
    servo_.hold(finger, false, 0.0);
    body.setIgnoreCollisionCheck(robot_.collider(finger), false);
  }
  body.setIgnoreCollisionCheck(robot_.collider(hand.link), false);
  physics_.forget_contacts(body);
  body.forceActivationState(ACTIVE_TAG);
  body.setDeactivationTime(0);
  hand.object = -1;
  hand.candidate = -1;
  hand.enclosed_for = 0;
}

void Grasping::watch(Hand& hand, double dt) {
  double told = 0;
  for (std::size_t finger : hand.fingers) told += servo_.target(finger);
  if (told > hand.opening + kLetGo) {
    release(hand);
    return;
  }
  double force = 0, torque = 0;
  for (int row = 0; row < 6; ++row) {
    const double load = hand.constraint->getAppliedImpulse(row) / dt;
    (row < 3 ? force : torque) += load * load;
  }
  force = std::sqrt(force);
  torque = std::sqrt(torque);
  hand.force += std::min(1.0, dt / kLoadSmoothing) * (force - hand.force);
  const btRigidBody& body = movables_.body(static_cast<std::size_t>(hand.object));
  const double friction = body.getFriction() * robot_.collider(hand.fingers[0])->getFriction();
  const double bearable = 2.0 * friction * grip_force(hand);
  // A jammed hand must not push without bound: the constraint itself yields beyond a multiple of what the
  // pads bear.
  hand.constraint->setMaxAppliedImpulse(5.0 * bearable * dt);
  const bool overloaded = force > bearable || torque > options_.held_torque;
  hand.overloaded_for = overloaded ? hand.overloaded_for + dt : 0.0;
  if (hand.overloaded_for > options_.overload_time) release(hand);
}

void Grasping::update(double dt) {
  for (auto& hand : hands_) {
    if (hand.object >= 0) {
      watch(hand, dt);
      continue;
    }
    const int object = presses(hand) ? enclosed(hand) : -1;
    hand.enclosed_for = object >= 0 && object == hand.candidate ? hand.enclosed_for + dt : 0.0;
    hand.candidate = object;
    // What another hand holds stays there; both may press it.
    if (hand.enclosed_for >= options_.grasp_time && !holds(static_cast<std::size_t>(object)))
      take(hand, object);
  }
}

bool Grasping::holds(std::size_t object) const {
  return std::any_of(hands_.begin(), hands_.end(),
                     [&](const Hand& hand) { return hand.object == static_cast<int>(object); });
}

int Grasping::hands_on(std::size_t object) const {
  const int wanted = static_cast<int>(object);
  return static_cast<int>(std::count_if(hands_.begin(), hands_.end(), [&](const Hand& hand) {
    return hand.object == wanted ||
           (hand.object < 0 && hand.candidate == wanted && hand.enclosed_for >= options_.grasp_time);
  }));
}

void Grasping::drop(std::size_t i) { release(hands_[i]); }

}  // namespace goalnet::sim
