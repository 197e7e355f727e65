#include "sim/compound_shape.h"

#include <algorithm>

#include "sim/bullet_convert.h"

namespace goalnet::sim {

std::unique_ptr<btCollisionShape> make_primitive(const scene::Shape& shape) {
  std::unique_ptr<btCollisionShape> result;
  switch (shape.kind) {
    case scene::ShapeKind::kBox:
      result = std::make_unique<btBoxShape>(to_bullet(Eigen::Vector3d(shape.size / 2.0)));
      break;
    case scene::ShapeKind::kCylinder:
      result =
          std::make_unique<btCylinderShapeZ>(btVector3(shape.size.x(), shape.size.x(), shape.size.z() / 2.0));
      break;
    case scene::ShapeKind::kSphere:
      return std::make_unique<btSphereShape>(shape.size.x());  // its margin is its radius
  }
  // Bullet rounds corners by its margin: as large as thin things allow, because with smaller ones discs rock
  // for ever.
  const double least = scene::half_extents(shape).minCoeff();
  result->setMargin(std::min(0.004, 0.45 * least));
  return result;
}

CompoundShape::CompoundShape(const std::vector<scene::Shape>& shapes, const scene::Pose& frame)
    : compound_(/*enableDynamicAabbTree=*/true) {
  const scene::Pose to_frame = frame.inverse();
  for (const auto& shape : shapes) {
    if (!shape.solid) continue;
    children_.push_back(make_primitive(shape));
    compound_.addChildShape(to_bullet(scene::Pose(to_frame * shape.pose)), children_.back().get());
  }
  compound_.setMargin(0.0);
}

}  // namespace goalnet::sim
