#include "components/scene/shape.h"

#include <numbers>

#include <gtest/gtest.h>

namespace goalnet::scene {
namespace {

TEST(Shape, VolumeOfPrimitives) {
  Shape shape;
  shape.size = {1.0, 2.0, 3.0};
  EXPECT_DOUBLE_EQ(volume(shape), 6.0);
  shape.kind = ShapeKind::kCylinder;
  shape.size = {0.5, 0.5, 2.0};
  EXPECT_NEAR(volume(shape), std::numbers::pi * 0.5, 1e-12);
  shape.kind = ShapeKind::kSphere;
  shape.size = Eigen::Vector3d::Constant(1.0);
  EXPECT_NEAR(volume(shape), 4.0 / 3.0 * std::numbers::pi, 1e-12);
}

TEST(Shape, BoundsFollowRotation) {
  Shape shape;
  shape.size = {2.0, 0.2, 0.2};
  shape.pose = make_pose({1.0, 0.0, 0.0}, {0.0, 0.0, std::numbers::pi / 2});
  const Bounds box = bounds({shape});
  EXPECT_NEAR(box.upper.y(), 1.0, 1e-9);
  EXPECT_NEAR(box.lower.y(), -1.0, 1e-9);
  EXPECT_NEAR(box.upper.x(), 1.1, 1e-9);
}

TEST(Shape, NoShapesHaveZeroBounds) { EXPECT_EQ(bounds({}).upper, Eigen::Vector3d::Zero()); }

TEST(Shape, PoseUsesFixedAxesLikeUrdf) {
  // First roll about x, then yaw about the fixed z.
  const Pose pose = make_pose({0, 0, 0}, {std::numbers::pi / 2, 0, std::numbers::pi / 2});
  EXPECT_LT((pose * Eigen::Vector3d::UnitY() - Eigen::Vector3d::UnitZ()).norm(), 1e-9);
  EXPECT_LT((pose * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitY()).norm(), 1e-9);
}

}  // namespace
}  // namespace goalnet::scene
