// Jointed bodies (the robot, doors, knobs, buttons) as Bullet multibodies with a fixed base.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

#include "sim/compound_shape.h"
#include "sim/mass_properties.h"

namespace goalnet::sim {

// One moving link and the one-axis joint that it hangs on. At joint position 0 the link's frame is `origin`.
struct LinkSpec {
  std::string joint;  // name
  int parent = -1;    // index of a link listed before; -1: the fixed base
  bool prismatic = false;
  scene::Pose origin = scene::Pose::Identity();     // in the frame of the parent link (or of the base)
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  // unit vector in the link's frame
  MassProperties mass;                              // in the link's frame
  std::vector<scene::Shape> shapes;                 // in the link's frame
  double friction = 0.8;
};

// Broadphase groups: who can touch whom.
enum CollisionGroup : int { kStaticGroup = 1, kRobotGroup = 2, kObjectGroup = 4, kPartGroup = 8 };

class ArticulatedBody {
 public:
  ArticulatedBody(const scene::Pose& base, std::vector<LinkSpec> links);

  btMultiBody& body() { return *body_; }
  const btMultiBody& body() const { return *body_; }
  const std::vector<LinkSpec>& links() const { return links_; }
  const scene::Pose& base() const { return base_; }
  // Null for links without shapes.
  btMultiBodyLinkCollider* collider(std::size_t link) { return colliders_[link].get(); }

  double position(std::size_t link) const { return body_->getJointPos(static_cast<int>(link)); }
  double velocity(std::size_t link) const { return body_->getJointVel(static_cast<int>(link)); }
  // Moves joints at once (start of a scene, tests); call update_transforms afterwards.
  void set_position(std::size_t link, double q);
  void update_transforms();
  // Frame of a link (not its centre of mass) in the map frame.
  scene::Pose link_pose(std::size_t link) const;

 private:
  std::vector<LinkSpec> links_;
  scene::Pose base_;
  std::unique_ptr<btMultiBody> body_;
  std::vector<std::unique_ptr<CompoundShape>> shapes_;
  std::vector<std::unique_ptr<btMultiBodyLinkCollider>> colliders_;
};

}  // namespace goalnet::sim
