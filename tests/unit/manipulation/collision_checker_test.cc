#include "components/manipulation/collision_checker.h"

#include <gtest/gtest.h>

#include "components/manipulation/phases.h"
#include "components/manipulation/workbench.h"

namespace goalnet::manipulation {
namespace {

// The kitchen as its files say, the robot at home in the middle of the floor.
class KitchenBench : public testing::Test {
 protected:
  KitchenBench() {
    auto made =
        Workbench::create(robot::load_robot("default").value(), scene::load_scene("kitchen").value(), {});
    bench_ = std::move(*made);
    view_.robot = bench_->model().home();
    const auto& scene = bench_->scene();
    const auto poses = scene::initial_poses(scene, 0);
    for (std::size_t i = 0; i < poses.size(); ++i) view_.objects[scene.objects[i].name] = poses[i];
    bench_->observe(view_);
  }
  Configuration at(double x, double y, double yaw) {
    return bench_->with_stand(bench_->now(), {x, y, yaw, bench_->stand_of(bench_->now()).lift});
  }

  std::unique_ptr<Workbench> bench_;
  WorldView view_;
};

TEST_F(KitchenBench, HomeIsFreeAndTheCounterIsNot) {
  auto& checker = bench_->checker();
  const CollisionQuery query{&checker.all_parts(), 0.01, nullptr, true};
  EXPECT_EQ(checker.explain(at(0, 0, 0), query), "");
  EXPECT_FALSE(checker.collides(at(0, 0, 0), query));
  EXPECT_TRUE(checker.collides(at(1.2, 0, 0), query));
  EXPECT_NE(checker.explain(at(1.2, 0, 0), query).find("touches Counter_1"), std::string::npos);
}

TEST_F(KitchenBench, OpenDoorsAreInTheWay) {
  auto& checker = bench_->checker();
  const CollisionQuery query{&checker.trunk_parts(), 0.01, nullptr, false};
  const auto q = at(-0.75, -1.45, 0);
  EXPECT_FALSE(checker.collides(q, query)) << checker.explain(q, query);
  checker.pose_joint(view_, "FridgeRightDoor_joint", 1.6);
  checker.pose_joint(view_, "FridgeLeftDoor_joint", 1.2);
  EXPECT_TRUE(checker.collides(q, query));
}

TEST_F(KitchenBench, WhatStandsOnTheTrayMovesAlongWhenTheBaseDrives) {
  auto& checker = bench_->checker();
  const auto& tray = *bench_->model().tray;
  const Pose frame = bench_->kinematics().forward(view_.robot, bench_->kinematics().link_index(tray.link));
  Pose slot = frame;
  slot.translation() = frame * tray.slots.front().position;
  view_.objects["Mug_1"] = slot;
  view_.objects["Spoon_1"] = moved(slot, {0, 0, 0.08});
  view_.facts.insert({"In", "Spoon_1", "Mug_1"});
  bench_->observe(view_);
  EXPECT_TRUE(checker.rides("Mug_1"));
  EXPECT_TRUE(checker.rides("Spoon_1")) << "what is in it moves along, too";
  const CollisionQuery query{&checker.all_parts(), 0.01, nullptr, true};
  // Backwards, so that the mast comes to where the mug stands now.
  const Configuration back = at(slot.translation().x(), slot.translation().y(), 0);
  EXPECT_TRUE(checker.collides(back, query)) << "it stays where it is unless the base drives";
  {
    const RidingAlong scope(checker);
    EXPECT_EQ(checker.explain(back, query), "");
  }
  EXPECT_TRUE(checker.collides(back, query));
  // Above the tray's edge where it comes to, so high that only the mug runs into it.
  view_.objects["Coke_1"] =
      moved(bench_->kinematics().forward(back, bench_->kinematics().link_index(tray.link)) *
                Eigen::Translation3d(tray.slots.front().position),
            {0, 0, 0.05});
  bench_->observe(view_);
  const RidingAlong scope(checker);
  EXPECT_EQ(checker.explain(back, query), "Mug_1 touches Coke_1");
}

TEST_F(KitchenBench, TolerancesAllowOnlyWhatTheySay) {
  auto& checker = bench_->checker();
  const CollisionQuery query{&checker.all_parts(), 0.01, nullptr, true};
  const auto q = at(0.897, 0, 0);  // the front a few millimetres before the counter
  ASSERT_TRUE(checker.collides(q, query));
  const Tolerances relaxed = checker.baseline(q, query);
  const CollisionQuery tolerant{&checker.all_parts(), 0.01, &relaxed, true};
  EXPECT_FALSE(checker.collides(q, tolerant)) << checker.explain(q, tolerant);
  EXPECT_TRUE(checker.collides(at(0.92, 0, 0), tolerant)) << "pressing on must stay forbidden";
  const Tolerances strict = checker.baseline(q, query, 0.5);
  const CollisionQuery unforgiving{&checker.all_parts(), 0.01, &strict, true};
  EXPECT_TRUE(checker.collides(q, unforgiving));
}

TEST_F(KitchenBench, WhatIsHeldMovesWithTheHand) {
  auto& checker = bench_->checker();
  Pose tool = bench_->tool_pose(bench_->now(), 0);
  view_.objects["Mug_1"] = tool * Eigen::Translation3d(0, 0.03, 0.0);
  bench_->observe(view_);
  const CollisionQuery query{&checker.arm_parts(0), 0.0, nullptr, false};
  EXPECT_TRUE(checker.collides(bench_->now(), query));  // a mug through the fingers
  bench_->set_held(0, "Mug_1");
  EXPECT_EQ(bench_->arm_holding("Mug_1"), 0u);
  EXPECT_FALSE(checker.collides(bench_->now(), query)) << checker.explain(bench_->now(), query);
  // Driving up to the counter, the mug meets it before the hand does.
  EXPECT_NE(checker.explain(at(0.9, 0, 0), query), "");
}

TEST_F(KitchenBench, ThingsFitBesideNeighboursOnly) {
  auto& checker = bench_->checker();
  Pose pose = view_.objects["Kettle"];
  pose.translation().z() += 0.003;
  EXPECT_FALSE(checker.object_fits("Mug_1", pose, 0.01, {}));
  pose.translation().y() += 0.18;
  EXPECT_TRUE(checker.object_fits("Mug_1", pose, 0.002, {}));
}

TEST_F(KitchenBench, MotionsKeepClearAndWithinLimits) {
  auto goal = bench_->arm_of(bench_->now(), 0);
  goal[0] -= 1.2;
  const auto motion = bench_->move_arm(0, goal, 0.2);
  ASSERT_TRUE(motion) << motion.error().message;
  ASSERT_EQ(motion->joints.size(), 8u);  // the arm and the lift
  for (const auto& point : motion->points) {
    for (std::size_t j = 0; j < motion->joints.size(); ++j) {
      const auto& joint =
          bench_->model().joints[static_cast<std::size_t>(bench_->model().index_of(motion->joints[j]))];
      EXPECT_LE(std::abs(point.velocity[j]), joint.limits.velocity);
      EXPECT_GE(point.position[j], joint.limits.lower);
      EXPECT_LE(point.position[j], joint.limits.upper);
    }
  }
  const auto drive = bench_->drive({-1.0, 0.5, 2.0, 0.3});
  ASSERT_TRUE(drive) << drive.error().message;
  EXPECT_GT(duration_s(*drive), 1.0);
  EXPECT_FALSE(bench_->drive({1.3, 0, 0, 0.3}));
}

}  // namespace
}  // namespace goalnet::manipulation
