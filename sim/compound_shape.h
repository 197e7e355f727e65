// A Bullet collision shape made of the scene's primitives, with its parts' memory.
#pragma once

#include <memory>
#include <vector>

#include <btBulletCollisionCommon.h>

#include "components/scene/shape.h"

namespace goalnet::sim {

class CompoundShape {
 public:
  // `frame`: the body's Bullet frame (centre of mass, principal axes) in the frame that the shapes are given
  // in. Shapes that are not solid are left out.
  CompoundShape(const std::vector<scene::Shape>& shapes, const scene::Pose& frame);

  btCompoundShape* get() { return &compound_; }
  bool empty() const { return children_.empty(); }

 private:
  std::vector<std::unique_ptr<btCollisionShape>> children_;
  btCompoundShape compound_;
};

// One primitive, centred at its own origin, z the axis of cylinders.
std::unique_ptr<btCollisionShape> make_primitive(const scene::Shape& shape);

}  // namespace goalnet::sim
