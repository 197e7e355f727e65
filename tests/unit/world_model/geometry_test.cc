#include "components/world_model/geometry.h"

#include <gtest/gtest.h>

#include <numbers>

namespace goalnet::world_model {
namespace {

using scene::make_pose;
using scene::Shape;
using scene::ShapeKind;

constexpr double kPi = std::numbers::pi;

Shape shape(ShapeKind kind, Eigen::Vector3d size, Pose pose = Pose::Identity()) {
  Shape made;
  made.kind = kind;
  made.size = size;
  made.pose = pose;
  return made;
}

TEST(Geometry, HeightOfTiltedShapes) {
  const Shape box = shape(ShapeKind::kBox, {0.2, 0.4, 0.6}),
              can = shape(ShapeKind::kCylinder, {0.1, 0.1, 0.5});
  EXPECT_NEAR(height_range({box}, make_pose({0, 0, 1}, {0, 0, 0})).lowest, 0.7, 1e-12);
  EXPECT_NEAR(height_range({box}, make_pose({0, 0, 1}, {kPi / 2, 0, 0})).lowest, 0.8, 1e-12);
  EXPECT_NEAR(height_range({can}, make_pose({0, 0, 1}, {kPi / 2, 0, 0})).lowest, 0.9, 1e-12);
  EXPECT_NEAR(height_range({can}, make_pose({0, 0, 1}, {0, kPi / 4, 0})).highest, 1.0 + 0.35 / std::sqrt(2.0),
              1e-12);
  EXPECT_NEAR(height_range({box, can}, make_pose({0, 0, 1}, {0, 0, 0})).highest, 1.3, 1e-12);
  Shape water = box;
  water.solid = false;  // only seen
  EXPECT_EQ(height_range({water}, make_pose({0, 0, 1}, {0, 0, 0})).lowest, 1.0);
  EXPECT_EQ(height_range({}, make_pose({0, 0, 1}, {0, 0, 0})).highest, 1.0);
}

TEST(Geometry, LinesThroughShapes) {
  const Interval all{-10, 10};
  const Eigen::Vector3d y = Eigen::Vector3d::UnitY();
  const auto box = intersect(shape(ShapeKind::kBox, {0.2, 0.4, 0.6}), {0, 0, 0}, y, all);
  EXPECT_NEAR(box->low, -0.2, 1e-12);
  EXPECT_NEAR(box->high, 0.2, 1e-12);
  EXPECT_FALSE(intersect(shape(ShapeKind::kBox, {0.2, 0.4, 0.6}), {0.11, 0, 0}, y, all));
  const auto can = intersect(shape(ShapeKind::kCylinder, {0.1, 0.1, 0.5}), {0.06, 0, 0.2}, y, all);
  EXPECT_NEAR(can->high, 0.08, 1e-12);
  EXPECT_FALSE(intersect(shape(ShapeKind::kCylinder, {0.1, 0.1, 0.5}), {0, 0, 0.26}, y, all));
  const auto lying = shape(ShapeKind::kCylinder, {0.1, 0.1, 0.5}, make_pose({0, 1, 0}, {kPi / 2, 0, 0}));
  EXPECT_NEAR(intersect(lying, {0, 0, 0}, y, all)->low, 0.75, 1e-12);
  EXPECT_NEAR(intersect(shape(ShapeKind::kSphere, {0.1, 0.1, 0.1}), {0, 0, 0.06}, y, all)->high, 0.08, 1e-12);
  EXPECT_NEAR(intersect(shape(ShapeKind::kSphere, {0.1, 0.1, 0.1}), {0, 0, 0}, y, {0.05, 9})->low, 0.05,
              1e-12);
}

TEST(Geometry, DistanceToARectangle) {
  Eigen::Vector2d nearest;
  EXPECT_EQ(distance_to_rectangle({0.5, 0.5}, {0, 0}, {1, 2}), 0.0);
  EXPECT_NEAR(distance_to_rectangle({-3, 6}, {0, 0}, {1, 2}, &nearest), 5.0, 1e-12);
  EXPECT_EQ(nearest, Eigen::Vector2d(0, 2));
}

}  // namespace
}  // namespace goalnet::world_model
