#include "sim/movables.h"

#include "sim/bullet_convert.h"

namespace goalnet::sim {

Movables::Movables(Physics& physics, const scene::Scene& scene, const std::vector<scene::Pose>& poses)
    : physics_(physics) {
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const scene::ObjectModel& model = scene.model_of(scene.objects[i]);
    Body entry;
    entry.mass = mass_of_shapes(model.shapes, model.mass);
    if (model.center_of_mass) entry.mass.center.translation() = *model.center_of_mass;
    entry.shape = std::make_unique<CompoundShape>(model.shapes, entry.mass.center);
    btRigidBody::btRigidBodyConstructionInfo info(model.mass, nullptr, entry.shape->get(),
                                                  to_bullet(entry.mass.inertia));
    info.m_startWorldTransform = to_bullet(scene::Pose(poses[i] * entry.mass.center));
    info.m_friction = model.friction;
    info.m_rollingFriction = model.rolling_friction;
    info.m_linearDamping = 0.02;
    info.m_angularDamping = 0.1;
    info.m_linearSleepingThreshold = 0.01;
    info.m_angularSleepingThreshold = 0.08;
    entry.body = std::make_unique<btRigidBody>(info);
    // Scenes place things at rest: what does not begin to move at once may sleep at once.
    entry.body->setDeactivationTime(0.35);
    physics.add_rigid(*entry.body, scene.objects[i].name, &model.shapes);
    bodies_.push_back(std::move(entry));
  }
}

Movables::~Movables() {
  for (auto& entry : bodies_) physics_.world().removeRigidBody(entry.body.get());
}

int Movables::find(const btCollisionObject* object) const {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (bodies_[i].body.get() == object) return static_cast<int>(i);
  }
  return -1;
}

scene::Pose Movables::pose(std::size_t i) const {
  return from_bullet(bodies_[i].body->getCenterOfMassTransform()) * bodies_[i].mass.center.inverse();
}

void Movables::set_pose(std::size_t i, const scene::Pose& pose) {
  btRigidBody& body = *bodies_[i].body;
  const btTransform transform = to_bullet(scene::Pose(pose * bodies_[i].mass.center));
  body.setCenterOfMassTransform(transform);
  body.setInterpolationWorldTransform(transform);
  body.setLinearVelocity(btVector3(0, 0, 0));
  body.setAngularVelocity(btVector3(0, 0, 0));
  body.clearForces();
  physics_.forget_contacts(body);
  physics_.world().updateSingleAabb(&body);
  body.activate(true);
}

}  // namespace goalnet::sim
