// What can go wrong in the room itself while the robot works: the loop must notice, and either get there all
// the same or end with a typed outcome and a message, the robot at rest.
#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>

#include "tests/faults/loop_fixture.h"

namespace goalnet::tools {
namespace {

using testing::AnyOf;

class PhysicalFault : public LoopFixture {};

TEST_F(PhysicalFault, SomebodyMovesTheMugOnTheWay) {
  loop_->pursue(kMugInSink);
  ASSERT_TRUE(run_until_action("moveto Mug_1"));
  go_on(0.5);
  scene::Pose elsewhere = loop_->world().object_pose(object("Mug_1"));
  elsewhere.translation() +=
      Eigen::Vector3d(0.20, -1.20, 0.0);  // to a free place in the rear row of the counter
  loop_->world().set_object_pose(object("Mug_1"), elsewhere);
  run_to_the_end();
  EXPECT_EQ(last_.outcome, Outcome::kDone) << last_.message;
  EXPECT_TRUE(holds("On Mug_1 Sink"));
}

TEST_F(PhysicalFault, SomebodyDoesTheWorkFirst) {
  loop_->pursue(kMugInSink);
  ASSERT_TRUE(run_until_action("grasp Mug_1"));
  const scene::Scene& scene = loop_->world().scene();
  loop_->world().set_object_pose(
      object("Mug_1"), scene.find_fixture("Sink")->pose * scene.find_region("Sink")->supports[0].frame);
  run_to_the_end();
  EXPECT_EQ(last_.outcome, Outcome::kDone) << last_.message;
  EXPECT_TRUE(holds("On Mug_1 Sink"));
}

TEST_F(PhysicalFault, TheDoorFallsShut) {
  loop_->pursue({{{"In", "Mug_1", "Microwave"}}, {}, 1.0});
  ASSERT_TRUE(run_until_action("moveto Mug_1") || run_until_action("grasp Mug_1"));
  if (!holds("state Microwave DoorIsOpen")) {
    ASSERT_TRUE(run_until([&] { return holds("state Microwave DoorIsOpen"); }));
  }
  go_on(0.5);
  const int door = loop_->world().find_fixture_joint("MicrowaveDoor_joint");
  ASSERT_GE(door, 0);
  loop_->world().set_fixture_position(static_cast<std::size_t>(door), 0.0);
  run_to_the_end();
  EXPECT_EQ(last_.outcome, Outcome::kDone) << last_.message;
  EXPECT_TRUE(holds("In Mug_1 Microwave"));
}

TEST_F(PhysicalFault, TheHandLosesTheMug) {
  loop_->pursue(kMugInSink);
  ASSERT_TRUE(run_until([&] { return holds("Grasping Robot Mug_1"); }));
  ASSERT_TRUE(run_until_action("moveto Sink"));
  go_on(1.0);
  loop_->world().drop_grasp("left");
  loop_->world().drop_grasp("right");
  run_to_the_end();
  // It lies on the floor now, where the arms may or may not get it.
  EXPECT_THAT(last_.outcome, AnyOf(Outcome::kDone, Outcome::kMotionFailed, Outcome::kNoPlan))
      << last_.message;
  EXPECT_EQ(holds("On Mug_1 Sink"), last_.outcome == Outcome::kDone);
  EXPECT_EQ(last_.message.empty(), false);
  expect_at_rest();
}

// While it is being lifted: it falls back to where it stood, or beside.
TEST_F(PhysicalFault, TheGraspSlips) {
  loop_->pursue(kMugInSink);
  ASSERT_TRUE(run_until_action("grasp Mug_1"));
  ASSERT_TRUE(run_until([&] { return !loop_->world().held().empty(); }));
  go_on(0.4);
  for (const char* arm : {"left", "right"}) loop_->world().drop_grasp(arm);
  run_to_the_end();
  EXPECT_EQ(last_.outcome, Outcome::kDone) << last_.message;
  EXPECT_TRUE(holds("On Mug_1 Sink"));
  expect_at_rest();
}

// For good: every attempt fails for the same reason, which the message names, and nothing presses against
// what blocks the joint when the run is over.
TEST_F(PhysicalFault, BothArmsAreBlockedForGood) {
  loop_->pursue(kMugInSink);
  ASSERT_TRUE(run_until_action("grasp Mug_1"));
  for (const char* joint : {"left_arm_4", "right_arm_4"}) loop_->world().freeze_joint(joint, true);
  run_to_the_end();
  EXPECT_EQ(last_.outcome, Outcome::kMotionFailed) << last_.message;
  EXPECT_THAT(last_.message, testing::HasSubstr("_arm_4"));
  expect_at_rest();
  expect_nothing_presses();
  // Freed afterwards, it does not jump, and the next instruction is carried out.
  const auto elbows = [&] { return std::pair(joint_position("left_arm_4"), joint_position("right_arm_4")); };
  const auto [left, right] = elbows();
  for (const char* joint : {"left_arm_4", "right_arm_4"}) loop_->world().freeze_joint(joint, false);
  go_on(1.0);
  EXPECT_NEAR(elbows().first, left, 0.06);  // goal tolerance: what is nearer keeps its command
  EXPECT_NEAR(elbows().second, right, 0.06);
  last_ = {};
  loop_->pursue(kMugInSink);
  run_to_the_end();
  EXPECT_EQ(last_.outcome, Outcome::kDone) << last_.message;
  EXPECT_TRUE(holds("On Mug_1 Sink"));
}

// The arm that it began with, for good: the other one does the work.
TEST_F(PhysicalFault, OneArmIsBlockedForGood) {
  loop_->pursue(kMugInSink);
  ASSERT_TRUE(run_until_action("grasp Mug_1"));
  const double left = joint_position("left_arm_4"), right = joint_position("right_arm_4");
  go_on(0.4);
  const bool with_left =
      std::abs(joint_position("left_arm_4") - left) > std::abs(joint_position("right_arm_4") - right);
  loop_->world().freeze_joint(with_left ? "left_arm_4" : "right_arm_4", true);
  ASSERT_TRUE(run_until([&] { return !loop_->world().held().empty(); })) << last_.message;
  EXPECT_EQ(loop_->world().held().front().arm, with_left ? "right" : "left");
  run_to_the_end();
  EXPECT_EQ(last_.outcome, Outcome::kDone) << last_.message;
  EXPECT_TRUE(holds("On Mug_1 Sink"));
  expect_at_rest();
  expect_nothing_presses();
}

TEST_F(PhysicalFault, AnArmIsBlockedForAWhile) {
  loop_->pursue(kMugInSink);
  ASSERT_TRUE(run_until_action("grasp Mug_1"));
  for (const char* joint : {"left_arm_2", "right_arm_2"}) loop_->world().freeze_joint(joint, true);
  go_on(6.0);
  EXPECT_FALSE(last_.finished) << "it goes on trying: " << last_.message;
  for (const char* joint : {"left_arm_2", "right_arm_2"}) loop_->world().freeze_joint(joint, false);
  run_to_the_end();
  EXPECT_EQ(last_.outcome, Outcome::kDone) << last_.message;
  EXPECT_TRUE(holds("On Mug_1 Sink"));
}

TEST_F(PhysicalFault, TheTapIsDead) {
  loop_->world().disable_device("Mug_1", true);  // no water reaches it
  loop_->pursue({{{"On", "Mug_1", "Sink"}, {"state", "Mug_1", "Water"}}, {}, 1.0});
  run_to_the_end();
  EXPECT_NE(last_.outcome, Outcome::kDone);
  EXPECT_FALSE(last_.message.empty());
  EXPECT_FALSE(holds("state Mug_1 Water"));  // where the mug ended up depends on the last attempt
  EXPECT_LT(loop_->sim_time(), 300.0) << "it gives up before its time is over";
}

}  // namespace
}  // namespace goalnet::tools
