// When a hand holds something, and when it does not any more.
#include <gtest/gtest.h>

#include "tests/unit/sim/puppet.h"
#include "tests/unit/sim/test_world.h"

namespace goalnet::sim {
namespace {

using Eigen::Vector3d;

// The right hand before the coke can, fingers open; base beside it so that the elbow has room.
class Grasp : public testing::Test {
 protected:
  Grasp() : world_(make_world()), hand_(*world_, "right"), can_(object_index(*world_, "Coke_1")) {
    at_ = Vector3d(world_->object_pose(can_).translation()) + Vector3d(0, 0, 0.07);
  }
  static scene::Pose tool(const Vector3d& position) {
    return Puppet::tool(position, Vector3d::UnitX(), Vector3d::UnitY());
  }
  void approach(double sideways = 0.0) {
    const Vector3d beside = at_ + Vector3d(0, sideways, 0);
    ASSERT_TRUE(
        hand_.place(at_.x() - 0.75, at_.y() + 0.3, 0, 0.25, tool(beside - Vector3d(0.12, 0, 0)), 0.053));
    ASSERT_TRUE(hand_.move(tool(beside), 0.8));
  }
  void close() {
    hand_.fingers(0.033 - 0.004, 0.4);
    hand_.wait(0.1);
  }

  std::unique_ptr<World> world_;
  Puppet hand_;
  std::size_t can_;
  Vector3d at_;
};

TEST_F(Grasp, FormsWhenBothFingersEncloseAndLiftsTheThing) {
  approach();
  EXPECT_TRUE(world_->held().empty());
  close();
  ASSERT_EQ(world_->held().size(), 1u);
  EXPECT_EQ(world_->held()[0].object, "Coke_1");
  EXPECT_EQ(world_->held()[0].arm, "right");
  const Vector3d before = world_->object_pose(can_).translation();
  ASSERT_TRUE(hand_.move(tool(at_ + Vector3d(-0.1, 0, 0.15)), 1.2));
  const Vector3d moved = Vector3d(world_->object_pose(can_).translation()) - before;
  EXPECT_LT((moved - Vector3d(-0.1, 0, 0.15)).norm(), 0.002);
  hand_.wait(0.3);
  // The hand bears the weight.
  EXPECT_NEAR(world_->held()[0].force, 9.81 * 0.36, 0.05);
}

TEST_F(Grasp, EndsWhenTheFingersOpen) {
  approach();
  close();
  ASSERT_EQ(world_->held().size(), 1u);
  hand_.fingers(0.05, 0.3);
  EXPECT_TRUE(world_->held().empty());
  ASSERT_TRUE(hand_.move(tool(at_ - Vector3d(0.12, 0, 0)), 0.8));
  hand_.wait(1.0);
  EXPECT_GT(world_->object_pose(can_).linear()(2, 2), 0.999);  // stands where it stood
  EXPECT_LT((world_->object_pose(can_).translation().head<2>() - at_.head<2>()).norm(), 0.005);
}

TEST_F(Grasp, DoesNotFormInTheAir) {
  approach(0.0);
  ASSERT_TRUE(hand_.move(tool(at_ - Vector3d(0.12, 0, 0)), 0.8));
  hand_.fingers(0.0, 0.5);
  hand_.wait(0.2);
  EXPECT_TRUE(world_->held().empty());
}

TEST_F(Grasp, DoesNotFormWithOneFingerOnly) {
  // Fingers open; the hand moves sideways until one of them pushes the can along.
  approach();
  ASSERT_TRUE(hand_.move(tool(at_ + Vector3d(0, 0.05, 0)), 1.0));
  hand_.wait(0.2);
  EXPECT_TRUE(world_->touching("Coke_1", "robot/right_finger_1_link") ||
              world_->touching("Coke_1", "robot/right_finger_2_link"));
  EXPECT_TRUE(world_->held().empty());
}

TEST_F(Grasp, DoesNotFormWithoutPressing) {
  approach();
  hand_.fingers(0.0335, 0.5);  // touches at most, does not squeeze
  hand_.wait(0.2);
  EXPECT_TRUE(world_->held().empty());
}

TEST_F(Grasp, BreaksUnderOverload) {
  approach();
  close();
  ASSERT_TRUE(hand_.move(tool(at_ + Vector3d(0, 0, 0.1)), 1.0));
  ASSERT_EQ(world_->held().size(), 1u);
  // 18 N on each pad at friction 0.72 bear 37 N: 20 N for a moment is fine, 80 N is not.
  for (int k = 0; k < 50; ++k) {
    world_->push_object(can_, {0, 0, -20});
    world_->step();
  }
  EXPECT_EQ(world_->held().size(), 1u);
  for (int k = 0; k < 100; ++k) {
    world_->push_object(can_, {0, 0, -80});
    world_->step();
  }
  EXPECT_TRUE(world_->held().empty());
  EXPECT_LT(world_->object_pose(can_).translation().z(), 0.95);
}

TEST_F(Grasp, CanBeDroppedAsAFault) {
  approach();
  close();
  ASSERT_TRUE(hand_.move(tool(at_ + Vector3d(0, 0, 0.1)), 1.0));
  hand_.fingers(0.05, 0.01);
  world_->drop_grasp("right");
  EXPECT_TRUE(world_->held().empty());
  hand_.wait(1.0);
  EXPECT_NEAR(world_->object_pose(can_).translation().z(), 0.85, 0.06);
}

TEST_F(Grasp, EndsWhenTheThingIsTakenAway) {
  approach();
  close();
  ASSERT_EQ(world_->held().size(), 1u);
  scene::Pose elsewhere = world_->object_pose(can_);
  elsewhere.translation().y() -= 0.2;
  world_->set_object_pose(can_, elsewhere);
  EXPECT_TRUE(world_->held().empty());
  hand_.wait(0.2);
  EXPECT_LT((world_->object_pose(can_).translation() - elsewhere.translation()).norm(), 0.002);
}

TEST(GraspOfRims, PlateAndBowlArePinchedAtTheirEdge) {
  for (const char* name : {"Plate_2", "Bowl_1"}) {
    auto world = make_world();
    // The other hand out of the way, above the counter.
    world->set_robot_position(static_cast<std::size_t>(world->robot().index_of("left_arm_2")), 2.4);
    Puppet hand(*world, "right");
    const std::size_t object = object_index(*world, name);
    const scene::Grasp& grasp = world->scene().find_model_of(name)->grasps[0];
    const double lean = grasp.tilt_max / 2.0;
    const Vector3d approach(std::sin(lean), 0, -std::cos(lean));
    const Vector3d edge =
        world->object_pose(object) * Vector3d(-grasp.radius, 0, grasp.frame.translation().z());
    const Vector3d at = edge + (grasp.depth - 0.015) * approach;
    const auto tool = [&](const Vector3d& p) { return Puppet::tool(p, approach, Vector3d::UnitX()); };
    ASSERT_TRUE(hand.place(edge.x() - 0.72, edge.y() + 0.25, 0, 0.35, tool(at - 0.08 * approach),
                           grasp.open_width / 2))
        << name;
    ASSERT_TRUE(hand.move(tool(at), 0.8)) << name;
    hand.fingers(0.0, 0.3);
    hand.wait(0.1);
    ASSERT_EQ(world->held().size(), 1u) << name;
    ASSERT_TRUE(hand.move(tool(at + Vector3d(-0.05, 0, 0.12)), 1.2)) << name;
    EXPECT_EQ(world->held().size(), 1u) << name;
    EXPECT_GT(world->object_pose(object).linear()(2, 2), 0.99) << name;
  }
}

}  // namespace
}  // namespace goalnet::sim
