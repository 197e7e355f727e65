#include "components/manipulation/grasp_candidates.h"

#include <cmath>

#include <gtest/gtest.h>

#include "components/robot/robot_model.h"
#include "components/scene/scene.h"

namespace goalnet::manipulation {
namespace {

class GraspCandidates : public testing::Test {
 protected:
  robot::RobotModel robot_ = robot::load_robot("default").value();
  const robot::Gripper& gripper_ = robot_.arms[0].gripper;
};

TEST_F(GraspCandidates, AroundACylinderTheFingersMeetItsAxis) {
  scene::Grasp g;
  g.kind = scene::GraspKind::kAround;
  g.width = 0.07;
  g.low = 0.04;
  g.high = 0.08;
  g.angle_max = 2 * M_PI;
  g.depth = gripper_.tip;  // tool frame on the axis
  g.tilt_max = 0.9;
  const auto candidates = grasp_candidates({g}, gripper_);
  EXPECT_GE(candidates.size(), 100u);
  for (const auto& c : candidates) {
    const auto& p = c.tool.translation();
    EXPECT_NEAR(std::hypot(p.x(), p.y()), 0, 1e-9);
    EXPECT_GE(p.z(), g.low - 1e-9);
    EXPECT_LE(p.z(), g.high + 1e-9);
    EXPECT_NEAR(c.tool.linear()(2, 1), 0, 1e-9);  // fingers close level
    EXPECT_NEAR(c.tool.linear().determinant(), 1, 1e-9);
    EXPECT_LE(c.tool.linear()(2, 2), 1e-9);  // never from below
    EXPECT_LE(c.opening, 2 * gripper_.open + 1e-9);
  }
  for (std::size_t i = 1; i < candidates.size(); ++i)
    EXPECT_LE(candidates[i - 1].preference, candidates[i].preference);
}

TEST_F(GraspCandidates, AnglesOfApproachAreRespected) {
  scene::Grasp g;
  g.kind = scene::GraspKind::kAround;
  g.angle_min = 2.0;
  g.angle_max = 4.0;
  g.width = 0.02;
  for (const auto& c : grasp_candidates({g}, gripper_)) {
    const Eigen::Vector3d from = -c.tool.linear().col(2);
    double angle = std::atan2(from.y(), from.x());
    if (angle < 0) angle += 2 * M_PI;
    EXPECT_GE(angle, 2.0 - 1e-9);
    EXPECT_LE(angle, 4.0 + 1e-9);
  }
}

TEST_F(GraspCandidates, RimsAreStraddledFromAbove) {
  scene::Grasp g;
  g.kind = scene::GraspKind::kRim;
  g.radius = 0.08;
  g.depth = 0.02;
  g.tilt_max = 0.5;
  g.width = 0.005;
  g.angle_max = 2 * M_PI;
  for (const auto& c : grasp_candidates({g}, gripper_)) {
    EXPECT_LT(c.tool.linear()(2, 2), -0.8);
    const Eigen::Vector3d tip = c.tool * Eigen::Vector3d(0, 0, gripper_.tip);
    EXPECT_LT(tip.z(), 0.0);
    EXPECT_GT(tip.z(), -0.021);
  }
}

TEST_F(GraspCandidates, EveryGraspOfTheKitchenHasCandidates) {
  const auto scene = scene::load_scene("kitchen").value();
  for (const auto& model : scene.models)
    EXPECT_FALSE(grasp_candidates(model.grasps, gripper_).empty()) << model.name;
}

}  // namespace
}  // namespace goalnet::manipulation
