#include "sim/inverse_dynamics.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "components/robot/robot_model.h"
#include "sim/robot_links.h"
#include "tests/unit/sim/test_world.h"

namespace goalnet::sim {
namespace {

MassProperties rod(double mass, double length) {
  scene::Shape shape;
  shape.size = {0.02, 0.02, length};
  shape.pose.translation().z() = length / 2.0;
  return mass_of_shapes({shape}, mass);
}

TEST(MassProperties, BoxAndCombination) {
  scene::Shape left, right;
  left.size = right.size = {1.0, 1.0, 1.0};
  left.pose.translation().x() = -0.5;
  right.pose.translation().x() = 0.5;
  const MassProperties both = mass_of_shapes({left, right}, 6.0);
  scene::Shape whole;
  whole.size = {2.0, 1.0, 1.0};
  const MassProperties one = mass_of_shapes({whole}, 6.0);
  EXPECT_NEAR((inertia_tensor(both) - inertia_tensor(one)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(both.center.translation().norm(), 0.0, 1e-12);
}

TEST(MassProperties, TensorIsBroughtToPrincipalAxes) {
  Eigen::Matrix3d tensor;
  tensor << 2.0, 0.3, 0.0, 0.3, 3.0, 0.1, 0.0, 0.1, 4.0;
  const MassProperties properties = mass_of_tensor(1.0, scene::Pose::Identity(), tensor);
  EXPECT_NEAR((inertia_tensor(properties) - tensor).norm(), 0.0, 1e-9);
  EXPECT_NEAR(properties.center.linear().determinant(), 1.0, 1e-9);
}

TEST(InverseDynamics, PendulumHeldLevel) {
  LinkSpec link;
  link.axis = Eigen::Vector3d::UnitY();
  link.mass = rod(2.0, 1.0);
  InverseDynamics dynamics(scene::Pose::Identity(), {link});
  std::vector<double> force(1);
  // Rotated by 90 degrees about y the rod points along +x; its weight turns it about +y by m g l / 2.
  dynamics.compute({std::numbers::pi / 2}, {0.0}, {0.0}, force);
  EXPECT_NEAR(force[0], -2.0 * 9.81 * 0.5, 1e-9);
  dynamics.compute({0.0}, {0.0}, {0.0}, force);
  EXPECT_NEAR(force[0], 0.0, 1e-12);
}

TEST(InverseDynamics, AgreesWithBulletOnTheWholeRobot) {
  // Forces computed for wanted accelerations, given to Bullet's forward dynamics, must give these
  // accelerations.
  auto links = make_robot_links(test_robot());
  ASSERT_TRUE(links) << links.error().message;
  ArticulatedBody body(scene::Pose::Identity(), links->links);
  const std::size_t n = links->links.size();
  std::vector<double> q(n), v(n), a(n), force(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double x = static_cast<double>(i);
    q[i] = test_robot().joints[i].home + 0.3 * std::sin(1.0 + x);
    v[i] = 0.5 * std::cos(2.0 * x);
    a[i] = 1.5 * std::sin(3.0 * x);
    body.body().setJointPos(static_cast<int>(i), q[i]);
    body.body().setJointVel(static_cast<int>(i), v[i]);
  }
  body.update_transforms();
  InverseDynamics dynamics(scene::Pose::Identity(), links->links);
  dynamics.compute(q, v, a, force);
  btAlignedObjectArray<btScalar> scratch_r;
  btAlignedObjectArray<btVector3> scratch_v;
  btAlignedObjectArray<btMatrix3x3> scratch_m;
  body.body().clearForcesAndTorques();
  for (std::size_t i = 0; i < n; ++i) {
    body.body().addJointTorque(static_cast<int>(i), force[i]);
    body.body().addLinkForce(static_cast<int>(i), btVector3(0, 0, -9.81 * links->links[i].mass.mass));
  }
  const double dt = 1e-4;
  body.body().computeAccelerationsArticulatedBodyAlgorithmMultiDof(dt, scratch_r, scratch_v, scratch_m, false,
                                                                   false, false);
  for (std::size_t i = 0; i < n; ++i) {
    EXPECT_NEAR((body.velocity(i) - v[i]) / dt, a[i], 1e-6) << links->links[i].joint;
  }
}

TEST(RobotLinks, LinkPosesEqualTheUrdfChain) {
  auto world = make_world();
  // 0.17 m from wrist to tool, in the hand's z: a fixed joint behind moving ones.
  const scene::Pose hand = world->robot_link_pose("left_hand"), tool = world->robot_link_pose("left_tcp");
  EXPECT_NEAR((hand.inverse() * Eigen::Vector3d(tool.translation()) - Eigen::Vector3d(0, 0, 0.17)).norm(),
              0.0, 1e-9);
}

}  // namespace
}  // namespace goalnet::sim
