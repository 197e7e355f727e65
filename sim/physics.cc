#include "sim/physics.h"

#include "sim/bullet_convert.h"

// A global of Bullet: seconds of rest until a body sleeps. The default of 2 s keeps put-down things awake for
// long.
extern btScalar gDeactivationTime;

namespace goalnet::sim {

Physics::Physics(const WorldOptions& options)
    : dispatcher_(&configuration_), world_(&dispatcher_, &broadphase_, &solver_, &configuration_) {
  gDeactivationTime = 0.4;
  world_.setGravity(btVector3(0, 0, -9.81));
  world_.setForceUpdateAllAabbs(false);
  world_.getSolverInfo().m_numIterations = options.solver_iterations;
  names_.emplace_back("nothing");
  colors_.emplace_back();
}

Physics::~Physics() {
  // Objects must leave the world before their memory goes; bodies of others are removed by their owners.
  for (auto& body : statics_) world_.removeCollisionObject(body.object.get());
}

int Physics::register_name(const std::string& name) {
  names_.push_back(name);
  colors_.emplace_back();
  return static_cast<int>(names_.size()) - 1;
}

void Physics::add_static(const std::string& name, const scene::Pose& pose,
                         const std::vector<scene::Shape>& shapes, double friction) {
  for (const auto& shape : shapes) {
    if (!shape.solid) continue;
    StaticBody body{make_primitive(shape), std::make_unique<btCollisionObject>()};
    body.object->setCollisionShape(body.shape.get());
    body.object->setWorldTransform(to_bullet(scene::Pose(pose * shape.pose)));
    body.object->setFriction(friction);
    // Asleep, as Bullet does with its own static bodies: what sleeps on a worktop is then left alone.
    body.object->setActivationState(ISLAND_SLEEPING);
    body.object->setUserIndex(register_name(name));
    colors_.back() = {shape.color};
    world_.addCollisionObject(body.object.get(), kStaticGroup, kRobotGroup | kObjectGroup);
    statics_.push_back(std::move(body));
  }
}

void Physics::add_articulated(ArticulatedBody& body, const std::vector<std::string>& names, int group,
                              int mask) {
  for (std::size_t i = 0; i < body.links().size(); ++i) {
    btMultiBodyLinkCollider* collider = body.collider(i);
    if (collider == nullptr) continue;
    collider->setUserIndex(register_name(names[i]));
    set_colors(*collider, body.links()[i].shapes);
    world_.addCollisionObject(collider, group, mask);
  }
  world_.addMultiBody(&body.body());
}

void Physics::remove(ArticulatedBody& body) {
  for (std::size_t i = 0; i < body.links().size(); ++i) {
    if (body.collider(i) != nullptr) world_.removeCollisionObject(body.collider(i));
  }
  world_.removeMultiBody(&body.body());
}

void Physics::add_rigid(btRigidBody& body, const std::string& name, const std::vector<scene::Shape>* shapes) {
  body.setUserIndex(register_name(name));
  if (shapes != nullptr) set_colors(body, *shapes);
  world_.addRigidBody(&body, kObjectGroup, kStaticGroup | kRobotGroup | kObjectGroup | kPartGroup);
}

const std::string& Physics::name_of(const btCollisionObject& object) const {
  const int index = object.getUserIndex();
  return names_[index > 0 && index < static_cast<int>(names_.size()) ? static_cast<std::size_t>(index) : 0];
}

void Physics::set_colors(const btCollisionObject& object, const std::vector<scene::Shape>& shapes) {
  auto& colors = colors_[static_cast<std::size_t>(object.getUserIndex())];
  colors.clear();
  for (const auto& shape : shapes) {
    if (shape.solid) colors.push_back(shape.color);
  }
}

std::array<double, 3> Physics::color_of(const btCollisionObject& object, int child) const {
  const int index = object.getUserIndex();
  if (index <= 0 || index >= static_cast<int>(colors_.size())) return {0.5, 0.5, 0.5};
  const auto& colors = colors_[static_cast<std::size_t>(index)];
  if (colors.empty()) return {0.5, 0.5, 0.5};
  const std::size_t place =
      child >= 0 && child < static_cast<int>(colors.size()) ? static_cast<std::size_t>(child) : 0;
  return colors[place];
}

void Physics::forget_contacts(btCollisionObject& object) {
  if (object.getBroadphaseHandle() != nullptr) {
    broadphase_.getOverlappingPairCache()->cleanProxyFromPairs(object.getBroadphaseHandle(), &dispatcher_);
  }
}

}  // namespace goalnet::sim
