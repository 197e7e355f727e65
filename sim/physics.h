// Bullet's world with everything it needs, built and torn down in the right order. Used inside sim/ only.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

#include "sim/articulated_body.h"
#include "sim/contact_islands.h"
#include "sim/world_options.h"

namespace goalnet::sim {

class Physics {
 public:
  explicit Physics(const WorldOptions& options);
  ~Physics();
  Physics(const Physics&) = delete;
  Physics& operator=(const Physics&) = delete;

  btMultiBodyDynamicsWorld& world() { return world_; }
  const btMultiBodyDynamicsWorld& world() const { return world_; }

  // Adds immovable shapes under one name; their memory stays here.
  void add_static(const std::string& name, const scene::Pose& pose, const std::vector<scene::Shape>& shapes,
                  double friction);
  // Registers a body's colliders and the body; `names` one per link. Does not own it.
  void add_articulated(ArticulatedBody& body, const std::vector<std::string>& names, int group, int mask);
  void add_rigid(btRigidBody& body, const std::string& name, const std::vector<scene::Shape>* shapes);
  void remove(ArticulatedBody& body);

  // What a collision object is called, and its colours by child shape.
  const std::string& name_of(const btCollisionObject& object) const;
  std::array<double, 3> color_of(const btCollisionObject& object, int child) const;
  void set_colors(const btCollisionObject& object, const std::vector<scene::Shape>& shapes);
  // Forgets all contacts of an object: after teleporting or changing what it may touch.
  void forget_contacts(btCollisionObject& object);

 private:
  struct StaticBody {
    std::unique_ptr<btCollisionShape> shape;
    std::unique_ptr<btCollisionObject> object;
  };
  int register_name(const std::string& name);

  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btMultiBodyConstraintSolver solver_;
  ContactIslandWorld world_;
  std::vector<StaticBody> statics_;
  std::vector<std::string> names_;                          // by the user index of collision objects
  std::vector<std::vector<std::array<double, 3>>> colors_;  // same
};

}  // namespace goalnet::sim
