#include "sim/articulated_body.h"

#include "sim/bullet_convert.h"

namespace goalnet::sim {
namespace {

btQuaternion rotation_of(const scene::Pose& pose) {
  btQuaternion rotation;
  to_bullet(Eigen::Matrix3d(pose.linear())).getRotation(rotation);
  return rotation.normalized();
}

}  // namespace

ArticulatedBody::ArticulatedBody(const scene::Pose& base, std::vector<LinkSpec> links)
    : links_(std::move(links)), base_(base) {
  const int count = static_cast<int>(links_.size());
  body_ =
      std::make_unique<btMultiBody>(count, 0.0, btVector3(0, 0, 0), /*fixedBase=*/true, /*canSleep=*/false);
  body_->setBaseWorldTransform(to_bullet(base));
  body_->setHasSelfCollision(false);
  body_->setLinearDamping(0.0);
  body_->setAngularDamping(0.0);
  for (int i = 0; i < count; ++i) {
    const LinkSpec& link = links_[static_cast<std::size_t>(i)];
    const scene::Pose parent_center =
        link.parent < 0 ? scene::Pose::Identity() : links_[static_cast<std::size_t>(link.parent)].mass.center;
    const scene::Pose pivot = parent_center.inverse() * link.origin;
    const scene::Pose& center = link.mass.center;
    const btQuaternion parent_to_this = rotation_of(pivot * center).inverse();
    const btVector3 axis = to_bullet(Eigen::Vector3d(center.linear().transpose() * link.axis));
    const btVector3 parent_to_pivot = to_bullet(Eigen::Vector3d(pivot.translation()));
    const btVector3 pivot_to_center =
        to_bullet(Eigen::Vector3d(center.linear().transpose() * center.translation()));
    const btVector3 inertia = to_bullet(link.mass.inertia);
    if (link.prismatic) {
      body_->setupPrismatic(i, link.mass.mass, inertia, link.parent, parent_to_this, axis, parent_to_pivot,
                            pivot_to_center, true);
    } else {
      body_->setupRevolute(i, link.mass.mass, inertia, link.parent, parent_to_this, axis, parent_to_pivot,
                           pivot_to_center, true);
    }
  }
  body_->finalizeMultiDof();
  shapes_.resize(links_.size());
  colliders_.resize(links_.size());
  for (std::size_t i = 0; i < links_.size(); ++i) {
    shapes_[i] = std::make_unique<CompoundShape>(links_[i].shapes, links_[i].mass.center);
    if (shapes_[i]->empty()) continue;
    colliders_[i] = std::make_unique<btMultiBodyLinkCollider>(body_.get(), static_cast<int>(i));
    colliders_[i]->setCollisionShape(shapes_[i]->get());
    colliders_[i]->setFriction(links_[i].friction);
    body_->getLink(static_cast<int>(i)).m_collider = colliders_[i].get();
  }
  update_transforms();
}

void ArticulatedBody::set_position(std::size_t link, double q) {
  body_->setJointPos(static_cast<int>(link), q);
  body_->setJointVel(static_cast<int>(link), 0.0);
}

void ArticulatedBody::update_transforms() {
  btAlignedObjectArray<btQuaternion> rotations;
  btAlignedObjectArray<btVector3> origins;
  body_->forwardKinematics(rotations, origins);
  body_->updateCollisionObjectWorldTransforms(rotations, origins);
}

scene::Pose ArticulatedBody::link_pose(std::size_t link) const {
  const LinkSpec& spec = links_[link];
  const scene::Pose parent = spec.parent < 0 ? base_ : link_pose(static_cast<std::size_t>(spec.parent));
  scene::Pose motion = scene::Pose::Identity();
  if (spec.prismatic) {
    motion.translation() = position(link) * spec.axis;
  } else {
    motion.linear() = Eigen::AngleAxisd(position(link), spec.axis).toRotationMatrix();
  }
  return parent * spec.origin * motion;
}

}  // namespace goalnet::sim
