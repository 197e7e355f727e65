// Skills in simulated physics: what they claim must be true in the world.
#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>

#include "components/manipulation/testing/physics_harness.h"

namespace goalnet::manipulation {
namespace {

std::unique_ptr<PhysicsHarness> kitchen(std::uint64_t seed) {
  return std::move(PhysicsHarness::create("kitchen", "default", seed).value());
}

void expect_done(PhysicsHarness& harness, const Action& action) {
  const auto result = harness.run(action);
  EXPECT_EQ(result.result.outcome, Outcome::kDone) << to_string(action) << ": " << result.result.message;
}

TEST(ManipulationPhysics, AMugIsCarriedUnderTheRunningTap) {
  const auto harness = kitchen(1);
  expect_done(*harness, {"moveto", {"Mug_1"}});
  EXPECT_TRUE(harness->facts().contains({"Near", "Robot", "Mug_1"}));
  expect_done(*harness, {"grasp", {"Mug_1"}});
  harness->wait(0.3);
  EXPECT_TRUE(harness->facts().contains({"Grasping", "Robot", "Mug_1"}));
  EXPECT_EQ(harness->world().held().size(), 1u);
  expect_done(*harness, {"keep-on", {"Mug_1", "Sink"}});
  harness->wait(0.3);
  EXPECT_TRUE(harness->facts().contains({"On", "Mug_1", "Sink"}));
  EXPECT_TRUE(harness->world().held().empty());
  expect_done(*harness, {"turn-on", {"SinkKnob"}});
  harness->wait(2.5);
  EXPECT_TRUE(harness->facts().contains({"state", "SinkKnob", "TapIsOn"}));
  EXPECT_TRUE(harness->facts().contains({"state", "Mug_1", "Water"}));
}

// The tap's place is for whatever holds water, not only for what one pours from.
TEST(ManipulationPhysics, ABowlIsPutUnderTheTap) {
  const auto harness = kitchen(1);
  for (const char* step : {"moveto", "grasp"}) expect_done(*harness, {step, {"Bowl_1"}});
  expect_done(*harness, {"turn-on", {"SinkKnob"}});
  expect_done(*harness, {"keep-on", {"Bowl_1", "Sink"}});
  harness->wait(2.5);
  EXPECT_TRUE(harness->facts().contains({"state", "Bowl_1", "Water"}));
}

// Between a wide tub and what stands behind the hand there is little room; the hand must let go all the same.
TEST(ManipulationPhysics, ATubIsLetGoOfWhereItIsNarrow) {
  const auto harness = kitchen(1);
  expect_done(*harness, {"moveto", {"Fridge"}});
  expect_done(*harness, {"open", {"FridgeRightDoor"}});
  for (const char* step : {"moveto", "grasp"}) expect_done(*harness, {step, {"IceCream_1"}});
  expect_done(*harness, {"moveto", {"Counter_1"}});
  expect_done(*harness, {"keep-on", {"IceCream_1", "Counter_1"}});
  harness->wait(0.5);
  EXPECT_TRUE(harness->facts().contains({"On", "IceCream_1", "Counter_1"}));
  EXPECT_FALSE(harness->facts().contains({"Grasping", "Robot", "IceCream_1"}));
}

// Under the tap the hand with the noodles has no room: the other hand puts the kettle elsewhere.
TEST(ManipulationPhysics, WhatHasNoRoomAboveItIsPutElsewhere) {
  const auto harness = kitchen(1);
  for (const char* step : {"moveto", "grasp"}) expect_done(*harness, {step, {"Kettle"}});
  expect_done(*harness, {"moveto", {"Sink"}});
  expect_done(*harness, {"keep-on", {"Kettle", "Sink"}});
  for (const char* step : {"moveto", "grasp"}) expect_done(*harness, {step, {"Ramen_1"}});
  expect_done(*harness, {"add", {"Ramen_1", "Kettle"}});
  harness->wait(1.0);
  EXPECT_TRUE(harness->facts().contains({"In", "Ramen_1", "Kettle"}));
  EXPECT_TRUE(harness->facts().contains({"On", "Kettle", "Counter_1"}));
  EXPECT_TRUE(harness->world().held().empty());
}

TEST(ManipulationPhysics, ADoorIsPulledOpenByItsHandle) {
  const auto harness = kitchen(2);
  expect_done(*harness, {"open", {"Microwave"}});
  EXPECT_GT(harness->view().joint("MicrowaveDoor_joint"), 1.2);
}

TEST(ManipulationPhysics, TheSameSeedGivesTheSameMotion) {
  std::vector<double> ends[2];
  for (auto& end : ends) {
    const auto harness = kitchen(3);
    expect_done(*harness, {"moveto", {"Coke_1"}});
    expect_done(*harness, {"grasp", {"Coke_1"}});
    end = harness->view().robot;
  }
  ASSERT_EQ(ends[0].size(), ends[1].size());
  // Two processes give the same bits. Two worlds in one process differ by hundredths of a millimetre in
  // contacts.
  for (std::size_t j = 0; j < ends[0].size(); ++j) EXPECT_NEAR(ends[0][j], ends[1][j], 1e-3) << j;
}

TEST(ManipulationPhysics, CancelStopsSmoothlyAndTheNextActionWorks) {
  const auto harness = kitchen(1);
  harness->cancel_when = [](double elapsed) { return elapsed > 0.6; };
  const auto result = harness->run({"moveto", {"Sink"}});
  EXPECT_EQ(result.result.outcome, Outcome::kCancelled);
  EXPECT_LT(result.sim_time, 2.0);
  harness->cancel_when = nullptr;
  expect_done(*harness, {"moveto", {"Sink"}});
}

TEST(ManipulationPhysics, ALostObjectIsNoticed) {
  const auto harness = kitchen(1);
  harness->on_stage = [&](double, const std::string& stage) {
    if (stage == "lift") harness->world().drop_grasp("left"), harness->world().drop_grasp("right");
  };
  const auto result = harness->run({"grasp", {"Mug_1"}});
  // Either it was caught on another attempt or it says so; it never claims what is not true.
  if (result.result.outcome == Outcome::kDone) {
    EXPECT_EQ(harness->world().held().size(), 1u);
  } else {
    EXPECT_EQ(result.result.outcome, Outcome::kMotionFailed);
    EXPECT_FALSE(result.result.message.empty());
  }
}

TEST(ManipulationPhysics, AFrozenJointEndsInAFault) {
  const auto harness = kitchen(1);
  harness->world().freeze_joint("base_x", true);
  const auto result = harness->run({"moveto", {"Mug_1"}});
  EXPECT_EQ(result.result.outcome, Outcome::kMotionFailed);
  EXPECT_THAT(result.result.message, testing::HasSubstr("base_x"));
}

// What stands below the robot's arms falls asleep all the same, and wakes when touched.
TEST(ManipulationPhysics, ThingsNearTheRobotComeToRest) {
  const auto harness = kitchen(1);
  expect_done(*harness, {"grasp", {"Mug_1"}});
  expect_done(*harness, {"keep-on", {"Mug_1", "Sink"}});
  harness->wait(1.0);
  std::size_t mug = 0;
  const auto& objects = harness->world().scene().objects;
  while (objects[mug].name != "Mug_1") ++mug;
  EXPECT_TRUE(harness->world().at_rest(mug));
  const double before = harness->world().object_pose(mug).translation().x();
  expect_done(*harness, {"grasp", {"Mug_1"}});
  EXPECT_FALSE(harness->world().at_rest(mug));
  EXPECT_EQ(harness->world().held().size(), 1u);
  EXPECT_LT(std::abs(harness->world().object_pose(mug).translation().x() - before), 0.2);
}

// From above there is no room below its ceiling; the hand that took the kettle so takes it anew if it must.
TEST(ManipulationPhysics, AKettleGoesIntoTheMicrowave) {
  const auto harness = kitchen(1);
  for (const Action& action :
       {Action{"open", {"Microwave"}}, Action{"moveto", {"Kettle"}}, Action{"grasp", {"Kettle"}},
        Action{"moveto", {"Microwave"}}, Action{"keep-in", {"Kettle", "Microwave"}}})
    expect_done(*harness, action);
  harness->wait(0.3);
  EXPECT_TRUE(harness->facts().contains({"In", "Kettle", "Microwave"}));
}

// Held in its middle, the hand would be where the kettle's handle is: it is put down and taken at its end.
TEST(ManipulationPhysics, ASpoonIsTakenAnewToStandItIntoTheKettle) {
  const auto harness = kitchen(1);
  for (const Action& action : {Action{"moveto", {"Spoon_1"}}, Action{"grasp", {"Spoon_1"}},
                               Action{"moveto", {"Kettle"}}, Action{"place-utensil", {"Spoon_1", "Kettle"}}})
    expect_done(*harness, action);
  harness->wait(0.3);
  EXPECT_TRUE(harness->facts().contains({"In", "Spoon_1", "Kettle"}));
}

TEST(ManipulationPhysics, WhatDoesNotFitStaysInTheHand) {
  const auto harness = std::move(PhysicsHarness::create("living_room", "default", 1).value());
  expect_done(*harness, {"grasp", {"Plate_1"}});
  const auto result = harness->run({"keep-in", {"Plate_1", "GarbageBag_1"}});
  EXPECT_EQ(result.result.outcome, Outcome::kNoPlan);
  EXPECT_NE(result.result.message.find("does not fit"), std::string::npos) << result.result.message;
  EXPECT_EQ(harness->world().held().size(), 1u);
}

TEST(ManipulationPhysics, ASpoonIsPutDownAnywhereAndTakenUpAgain) {
  const auto harness = kitchen(2);
  expect_done(*harness, {"grasp", {"Spoon_1"}});
  expect_done(*harness, {"stow", {"Spoon_1"}});
  expect_done(*harness, {"unstow", {"Spoon_1"}});
  expect_done(*harness, {"release", {"Spoon_1"}});
  expect_done(*harness, {"grasp", {"Spoon_1"}});
  EXPECT_EQ(harness->world().held().size(), 1u);
}

}  // namespace
}  // namespace goalnet::manipulation
