#include "sim/world.h"

#include <algorithm>
#include <cmath>

#include <BulletCollision/NarrowPhaseCollision/btRaycastCallback.h>

#include "components/robot/joint_order.h"
#include "sim/bullet_convert.h"
#include "sim/world_parts.h"

namespace goalnet::sim {
namespace {

// The robot's pads are rubber; everything else of it is smooth.
void set_robot_friction(RobotLinks& links, const robot::RobotModel& model) {
  for (auto& link : links.links) link.friction = 0.6;
  for (const auto& arm : model.arms) {
    for (const auto& finger : arm.gripper.fingers)
      links.links[static_cast<std::size_t>(model.index_of(finger))].friction = 1.2;
  }
}

// Pictures show the colours of the URDF's visual elements where these correspond to the collision elements.
void color_robot(RobotLinks& links, const robot::RobotModel& model) {
  std::vector<std::size_t> next(links.links.size(), 0);
  std::vector<std::pair<int, const urdf::Link*>> order;
  for (const auto& joint : robot::joints_depth_first(*model.urdf)) {
    const auto link = model.urdf->getLink(joint->child_link_name);
    const int index = links.merged.at(link->name).link;
    if (index < 0) continue;
    const auto visual = shapes_of_link(*link, true);
    const std::size_t count = link->collision_array.size();
    auto& shapes = links.links[static_cast<std::size_t>(index)].shapes;
    std::size_t& first = next[static_cast<std::size_t>(index)];
    for (std::size_t i = 0; i < count; ++i) {
      if (visual && i < visual->size()) shapes[first + i].color = (*visual)[i].color;
    }
    first += count;
  }
}

}  // namespace

World::World(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
World::~World() = default;

Expected<std::unique_ptr<World>> World::create(const scene::Scene& scene, const robot::RobotModel& robot,
                                               const WorldOptions& options) {
  if (!(options.physics_step > 0.0 && options.physics_step <= 0.01)) {
    return fail(Outcome::kInvalidRequest, "the physics step must be above 0 and at most 0.01 s");
  }
  auto links = make_robot_links(robot);
  if (!links) return tl::unexpected(links.error());
  set_robot_friction(*links, robot);
  color_robot(*links, robot);
  std::unique_ptr<World> world(new World(std::make_unique<Parts>(scene, robot, options, std::move(*links))));
  const std::vector<double> home = robot.home();
  for (std::size_t i = 0; i < home.size(); ++i) {
    double q = home[i];
    if (robot.joints[i].name == robot.base.x) q += scene.robot_start.x();
    if (robot.joints[i].name == robot.base.y) q += scene.robot_start.y();
    if (robot.joints[i].name == robot.base.yaw) q += scene.robot_start.z();
    world->set_robot_position(i, q);
  }
  world->parts_->physics.world().updateAabbs();  // rays find the robot before the first step, too
  world->parts_->run_rules(0.0);
  return world;
}

void World::step() {
  Parts& p = *parts_;
  const double dt = p.options.physics_step;
  p.grasping.update(dt);
  p.servo.apply(dt);
  p.parts.apply(dt);
  p.physics.world().stepSimulation(dt, 0);
  ++p.steps;
  if (p.steps % p.rules_every == 0) p.run_rules(dt * static_cast<double>(p.rules_every));
}

double World::time() const { return static_cast<double>(parts_->steps) * parts_->options.physics_step; }
const WorldOptions& World::options() const { return parts_->options; }
const scene::Scene& World::scene() const { return parts_->scene; }
const robot::RobotModel& World::robot() const { return parts_->robot_model; }

std::size_t World::robot_joint_count() const { return parts_->robot.links().size(); }

JointReading World::robot_joint(std::size_t joint) const {
  return {parts_->robot.position(joint), parts_->robot.velocity(joint), parts_->servo.effort(joint)};
}

void World::command(std::size_t joint, double position, double velocity) {
  parts_->servo.set_target(joint, position, velocity);
}

void World::set_robot_position(std::size_t joint, double position) {
  parts_->robot.set_position(joint, position);
  parts_->robot.update_transforms();
  parts_->servo.set_target(joint, position, 0.0);
}

std::size_t World::fixture_joint_count() const { return parts_->parts.count(); }
const std::string& World::fixture_joint_name(std::size_t joint) const {
  return parts_->parts.joint(joint).name;
}
int World::find_fixture_joint(std::string_view name) const { return parts_->parts.find(name); }
void World::set_fixture_position(std::size_t joint, double position) {
  parts_->parts.set_position(joint, position);
}

JointReading World::fixture_joint(std::size_t joint) const {
  return {parts_->parts.position(joint), parts_->parts.velocity(joint), parts_->parts.effort(joint)};
}

scene::Pose World::object_pose(std::size_t object) const { return parts_->movables.pose(object); }

Eigen::Vector3d World::object_velocity(std::size_t object) const {
  return from_bullet(parts_->movables.body(object).getLinearVelocity());
}

void World::set_object_pose(std::size_t object, const scene::Pose& pose) {
  for (std::size_t i = 0; i < parts_->grasping.arm_count(); ++i) {
    if (parts_->grasping.held(i) == static_cast<int>(object)) parts_->grasping.drop(i);
  }
  parts_->movables.set_pose(object, pose);
}

void World::push_object(std::size_t object, const Eigen::Vector3d& force) {
  btRigidBody& body = parts_->movables.body(object);
  body.activate(true);
  body.applyCentralForce(to_bullet(force));
}

bool World::at_rest(std::size_t object) const { return !parts_->movables.body(object).isActive(); }

std::vector<Contact> World::contacts() const {
  std::vector<Contact> result;
  btDispatcher* dispatcher = parts_->physics.world().getDispatcher();
  for (int m = 0; m < dispatcher->getNumManifolds(); ++m) {
    const btPersistentManifold* manifold = dispatcher->getManifoldByIndexInternal(m);
    for (int c = 0; c < manifold->getNumContacts(); ++c) {
      const btManifoldPoint& point = manifold->getContactPoint(c);
      if (point.getDistance() > 0.001) continue;
      result.push_back({parts_->physics.name_of(*manifold->getBody0()),
                        parts_->physics.name_of(*manifold->getBody1()),
                        from_bullet(point.getPositionWorldOnB()), from_bullet(point.m_normalWorldOnB),
                        point.getDistance(), point.getAppliedImpulse() / parts_->options.physics_step});
    }
  }
  return result;
}

bool World::touching(std::string_view a, std::string_view b) const {
  const auto all = contacts();
  return std::any_of(all.begin(), all.end(), [&](const Contact& contact) {
    return (contact.a == a && contact.b == b) || (contact.a == b && contact.b == a);
  });
}

std::vector<HeldObject> World::held() const {
  std::vector<HeldObject> result;
  for (std::size_t i = 0; i < parts_->grasping.arm_count(); ++i) {
    const int object = parts_->grasping.held(i);
    if (object < 0) continue;
    result.push_back({parts_->grasping.arm(i), parts_->scene.objects[static_cast<std::size_t>(object)].name,
                      parts_->grasping.force(i)});
  }
  return result;
}

const FactSet& World::facts() const { return parts_->rules.facts(); }
void World::set_fact(const Predicate& fact, bool holds) { parts_->rules.set_fact(fact, holds); }

void World::drop_grasp(std::string_view arm) {
  for (std::size_t i = 0; i < parts_->grasping.arm_count(); ++i) {
    if (parts_->grasping.arm(i) == arm) parts_->grasping.drop(i);
  }
}

void World::freeze_joint(std::string_view joint, bool frozen) {
  const int robot_joint = parts_->robot_model.index_of(std::string(joint));
  if (robot_joint >= 0) parts_->servo.freeze(static_cast<std::size_t>(robot_joint), frozen);
  const int fixture_joint = parts_->parts.find(joint);
  if (fixture_joint >= 0) parts_->parts.freeze(static_cast<std::size_t>(fixture_joint), frozen);
}

void World::disable_device(std::string_view subject, bool dead) {
  parts_->rules.disable(std::string(subject), dead);
}

World::RayHit World::ray(const Eigen::Vector3d& from, const Eigen::Vector3d& to, bool grazing) const {
  struct Callback : btCollisionWorld::ClosestRayResultCallback {
    using ClosestRayResultCallback::ClosestRayResultCallback;
    int child = 0;
    btScalar addSingleResult(btCollisionWorld::LocalRayResult& result, bool normal_in_world) override {
      child = result.m_localShapeInfo != nullptr ? result.m_localShapeInfo->m_triangleIndex : 0;
      return ClosestRayResultCallback::addSingleResult(result, normal_in_world);
    }
  };
  Callback callback(to_bullet(from), to_bullet(to));
  callback.m_collisionFilterGroup = kStaticGroup | kRobotGroup | kObjectGroup | kPartGroup;
  callback.m_collisionFilterMask = callback.m_collisionFilterGroup;
  if (grazing) callback.m_flags |= btTriangleRaycastCallback::kF_UseGjkConvexCastRaytest;
  parts_->physics.world().rayTest(to_bullet(from), to_bullet(to), callback);
  RayHit hit;
  if (!callback.hasHit()) return hit;
  hit.name = parts_->physics.name_of(*callback.m_collisionObject);
  hit.point = from_bullet(callback.m_hitPointWorld);
  hit.normal = from_bullet(callback.m_hitNormalWorld.normalized());
  hit.color = parts_->physics.color_of(*callback.m_collisionObject, callback.child);
  return hit;
}

scene::Pose World::robot_link_pose(const std::string& link) const {
  const auto found = parts_->links.merged.find(link);
  if (found == parts_->links.merged.end()) return scene::Pose::Identity();
  if (found->second.link < 0) return found->second.pose;
  return parts_->robot.link_pose(static_cast<std::size_t>(found->second.link)) * found->second.pose;
}

}  // namespace goalnet::sim
