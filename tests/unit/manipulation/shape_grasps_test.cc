#include "components/manipulation/shape_grasps.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "components/robot/robot_model.h"

namespace goalnet::manipulation {
namespace {

scene::ObjectModel box(const Eigen::Vector3d& size) {
  scene::ObjectModel model;
  scene::Shape shape;
  shape.size = size;
  shape.pose.translation().z() = size.z() / 2;
  model.shapes = {shape};
  return model;
}

class ShapeGrasps : public testing::Test {
 protected:
  robot::RobotModel robot_ = robot::load_robot("default").value();
  const robot::Gripper& gripper_ = robot_.arms[0].gripper;
  Pose table_ = Pose(Eigen::Translation3d(0, 0, 0.85));
  Pose on_its_side_ = table_ * Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitY());
};

TEST_F(ShapeGrasps, FingersCloseAcrossWhatIsThinEnough) {
  const auto candidates = shape_grasps(box({0.20, 0.04, 0.15}), table_, gripper_);
  ASSERT_FALSE(candidates.empty());
  for (const auto& c : candidates) {
    EXPECT_NEAR(c.width, 0.04, 1e-9);
    EXPECT_GT(c.opening, c.width);
    EXPECT_LE(c.opening, 2 * gripper_.open);
    EXPECT_NEAR(std::abs(c.tool.linear()(1, 1)), 1.0, 1e-9);  // y closes across y
    EXPECT_NEAR(c.tool.linear().determinant(), 1.0, 1e-9);
  }
}

TEST_F(ShapeGrasps, TheHandComesFromAboveAndBothSidesButNotFromBelow) {
  const auto model = box({0.20, 0.04, 0.15});
  bool above = false, left = false, right = false;
  for (const auto& c : shape_grasps(model, table_, gripper_)) {
    const Eigen::Vector3d along = (table_ * c.tool).linear().col(2);
    EXPECT_LT(along.z(), 0.3);
    above |= along.z() < -0.99;
    left |= along.x() > 0.99;
    right |= along.x() < -0.99;
  }
  EXPECT_TRUE(above && left && right);
}

TEST_F(ShapeGrasps, FromAboveTheTipsStayOffTheTable) {
  const auto model = box({0.03, 0.03, 0.12});
  int from_above = 0;
  for (const auto& c : shape_grasps(model, on_its_side_, gripper_)) {
    const Pose tool = on_its_side_ * c.tool;
    if (tool.linear()(2, 2) > -0.99) continue;
    ++from_above;
    const Eigen::Vector3d tip = tool * Eigen::Vector3d(0, 0, gripper_.tip);
    EXPECT_GE(tip.z(), 0.85 - 0.015 + 0.005);  // it lies with its axis at the table's height
    EXPECT_LE(tip.z(), 0.85);                  // and the fingers reach past its middle
  }
  EXPECT_GT(from_above, 0);
}

// A bottle's neck is what the fingers close upon from above, whatever its belly measures.
TEST_F(ShapeGrasps, FromAboveABottleIsHeldByItsNeck) {
  auto model = box({0.06, 0.06, 0.12});
  scene::Shape neck;
  neck.size = Eigen::Vector3d(0.026, 0.026, 0.07);
  neck.pose.translation().z() = 0.12 + 0.035;
  model.shapes.push_back(neck);
  int from_above = 0;
  for (const auto& c : shape_grasps(model, table_, gripper_)) {
    if ((table_ * c.tool).linear()(2, 2) > -0.99) continue;
    ++from_above;
    EXPECT_NEAR(c.width, 0.026, 1e-9);
  }
  EXPECT_GT(from_above, 0);
}

TEST_F(ShapeGrasps, WhatIsTooThickEverywhereHasNone) {
  EXPECT_TRUE(shape_grasps(box({0.2, 0.2, 0.2}), table_, gripper_).empty());
}

TEST_F(ShapeGrasps, TheBestComeFirst) {
  const auto candidates = shape_grasps(box({0.05, 0.04, 0.12}), on_its_side_, gripper_);
  ASSERT_GT(candidates.size(), 10u);
  EXPECT_TRUE(std::is_sorted(candidates.begin(), candidates.end(),
                             [](const auto& a, const auto& b) { return a.preference < b.preference; }));
}

}  // namespace
}  // namespace goalnet::manipulation
