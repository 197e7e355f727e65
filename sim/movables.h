// The graspable things of a scene as rigid bodies.
#pragma once

#include <memory>
#include <vector>

#include "components/scene/scene.h"
#include "sim/physics.h"

namespace goalnet::sim {

class Movables {
 public:
  Movables(Physics& physics, const scene::Scene& scene, const std::vector<scene::Pose>& poses);
  ~Movables();

  std::size_t count() const { return bodies_.size(); }
  btRigidBody& body(std::size_t i) { return *bodies_[i].body; }
  const btRigidBody& body(std::size_t i) const { return *bodies_[i].body; }
  // Index of the object that a collision object belongs to; -1: none.
  int find(const btCollisionObject* object) const;
  // Pose of the object's frame (not of its centre of mass) in the map frame.
  scene::Pose pose(std::size_t i) const;
  void set_pose(std::size_t i, const scene::Pose& pose);

 private:
  struct Body {
    MassProperties mass;
    std::unique_ptr<CompoundShape> shape;
    std::unique_ptr<btRigidBody> body;
  };
  Physics& physics_;
  std::vector<Body> bodies_;
};

}  // namespace goalnet::sim
