// Recorded starts in the simulated room, and the comparison of what changed there.
#include <gtest/gtest.h>

#include <algorithm>

#include "components/core/config_path.h"
#include "components/robot/robot_model.h"
#include "sim/world.h"
#include "tools/goalnet/physics_run.h"
#include "tools/goalnet/physics_start.h"

namespace goalnet::tools {
namespace {

using inference::Demonstration;

FactSet facts(const std::vector<std::string>& texts) {
  std::vector<Predicate> result;
  for (const std::string& text : texts) result.push_back(*parse_predicate(text));
  return FactSet(std::move(result));
}

Demonstration demonstration(const std::vector<std::string>& first, const std::vector<std::string>& last,
                            std::vector<std::string> actions) {
  Demonstration d;
  d.states = {WorldState{{}, facts(first)}, WorldState{{}, facts(last)}};
  d.actions = std::move(actions);
  return d;
}

class Arrange : public testing::Test {
 protected:
  void SetUp() override {
    const auto scene = scene::load_scene("kitchen");
    ASSERT_TRUE(scene) << scene.error().message;
    const auto robot = robot::load_robot(config_path("robots/default.yaml"));
    ASSERT_TRUE(robot) << robot.error().message;
    auto made = sim::World::create(*scene, *robot, {});
    ASSERT_TRUE(made) << made.error().message;
    world_ = std::move(*made);
  }
  void rest() {
    for (int i = 0; i < 500; ++i) world_->step();
  }
  scene::Pose pose(const std::string& name) const {
    const auto& objects = world_->scene().objects;
    for (std::size_t i = 0; i < objects.size(); ++i)
      if (objects[i].name == name) return world_->object_pose(i);
    ADD_FAILURE() << name;
    return scene::Pose::Identity();
  }
  std::unique_ptr<sim::World> world_;
};

TEST_F(Arrange, ThingsStandWhereTheRecordingHasThem) {
  arrange(*world_, facts({"(On Mug_1 StoveFire_2)", "(On Kettle Sink)", "(On Plate_1 Counter_1)"}));
  rest();
  EXPECT_TRUE(world_->touching("Mug_1", "Stove"));
  EXPECT_TRUE(world_->touching("Kettle", "Sink"));
  EXPECT_FALSE(world_->touching("Mug_1", "Kettle"));
}

TEST_F(Arrange, AThingInAThingLiesInIt) {
  arrange(*world_, facts({"(On Bowl_1 Counter_1)", "(In BoiledEgg_1 Bowl_1)"}));
  rest();
  EXPECT_TRUE(world_->touching("BoiledEgg_1", "Bowl_1"));
  EXPECT_LT((pose("BoiledEgg_1").translation() - pose("Bowl_1").translation()).norm(), 0.1);
}

// Pushed into each other they would burst apart and take the bowl with them.
TEST_F(Arrange, WhatDoesNotFitStaysOut) {
  const scene::Pose plate = pose("Plate_1");
  arrange(*world_, facts({"(In Plate_1 Glass_1)", "(In Spoon_1 Bowl_1)", "(In BoiledEgg_1 Bowl_1)"}));
  EXPECT_EQ(pose("Plate_1").translation(), plate.translation());
  const double apart = (pose("Spoon_1").translation() - pose("BoiledEgg_1").translation()).norm();
  EXPECT_GT(apart, 0.01) << "one in the bowl, the other above it or where it was";
  const scene::Pose bowl = pose("Bowl_1");
  rest();
  EXPECT_LT((pose("Bowl_1").translation() - bowl.translation()).norm(), 0.05);
}

// A place and its part: the part counts. What the scene has there stays as it stands.
TEST_F(Arrange, TheCloserPlaceCounts) {
  const scene::Pose egg = pose("BoiledEgg_1"), cup = pose("LongCup_1");
  arrange(*world_, facts({"(In BoiledEgg_1 Fridge)", "(In BoiledEgg_1 FridgeRight)",
                          "(On LongCup_1 Counter_1)", "(In Coke_1 Fridge)", "(In Coke_1 FridgeRight)"}));
  EXPECT_EQ(pose("BoiledEgg_1").translation(), egg.translation());
  EXPECT_EQ(pose("LongCup_1").translation(), cup.translation());
  rest();
  EXPECT_LT(std::abs(pose("Coke_1").translation().y() - egg.translation().y()), 0.3) << "beside the egg";
}

TEST_F(Arrange, DevicesAreAsRecordedOrOff) {
  arrange(*world_,
          facts({"(state SinkKnob TapIsOn)", "(state Fridge LeftDoorIsOpen)", "(state Mug_1 Water)"}));
  rest();
  EXPECT_TRUE(world_->facts().contains(*parse_predicate("(state SinkKnob TapIsOn)")));
  EXPECT_TRUE(world_->facts().contains(*parse_predicate("(state Fridge LeftDoorIsOpen)")));
  EXPECT_TRUE(world_->facts().contains(*parse_predicate("(state Mug_1 Water)")));
  arrange(*world_, facts({}));
  rest();
  EXPECT_FALSE(world_->facts().contains(*parse_predicate("(state SinkKnob TapIsOn)")));
  EXPECT_FALSE(world_->facts().contains(*parse_predicate("(state Fridge LeftDoorIsOpen)")));
}

TEST_F(Arrange, WhatCannotBeIsLeftAlone) {
  const scene::Pose before = pose("Mug_1");
  arrange(*world_,
          facts({"(On Mug_1 Mug_1)", "(On Mug_1 Shelf_1)", "(In Sofa_9 Fridge)", "(Grasping Robot Mug_1)"}));
  EXPECT_EQ(pose("Mug_1").translation(), before.translation());
  EXPECT_TRUE(
      known_facts(facts({"(On Mug_1 Mug_1)", "(On Mug_1 Shelf_1)", "(Near Robot Sink)"}), world_->scene())
          .empty());
}

TEST(ScoreInPhysics, TheSameChangesScoreOne) {
  const auto d = demonstration({"(On Mug_1 Counter_1)"}, {"(On Mug_1 Sink)", "(Near Robot Sink)"},
                               {"moveto Mug_1", "grasp Mug_1", "moveto Sink", "keep Mug_1 On Sink"});
  // The room says more: what stands near, in which hand something is, where other things are.
  const auto scores = score_physics(
      d, facts({"(On Mug_1 Counter_1)", "(On Fork_1 Counter_1)", "(Near Robot Counter_1)"}),
      facts({"(On Mug_1 Sink)", "(On Fork_1 Counter_1)", "(Near Robot Sink)", "(Near Robot Stove)"}),
      {{"moveto", {"Mug_1"}}, {"grasp", {"Mug_1"}}, {"moveto", {"Sink"}}, {"keep-on", {"Mug_1", "Sink"}}});
  EXPECT_DOUBLE_EQ(scores.sji, 1);
  EXPECT_DOUBLE_EQ(scores.ied, 1);
  EXPECT_DOUBLE_EQ(scores.exact, 1);
}

TEST(ScoreInPhysics, LeavingAPlaceThatTheRecordingDoesNotTellDoesNotCount) {
  const auto d =
      demonstration({}, {"(Grasping Robot Mug_1)", "(Near Robot Mug_1)"}, {"moveto Mug_1", "grasp Mug_1"});
  const auto scores = score_physics(d, facts({"(On Mug_1 Counter_1)"}), facts({"(Grasping Robot Mug_1)"}),
                                    {{"moveto", {"Mug_1"}}, {"grasp", {"Mug_1"}}});
  EXPECT_DOUBLE_EQ(scores.sji, 1);
}

TEST(ScoreInPhysics, DoingNothingScoresNothing) {
  const auto d = demonstration({}, {"(state SinkKnob TapIsOn)"}, {"turn SinkKnob"});
  const auto scores = score_physics(d, facts({}), facts({}), {});
  EXPECT_DOUBLE_EQ(scores.sji, 0);
  EXPECT_DOUBLE_EQ(scores.grr, 0);
}

TEST(RecordedSpelling, IsThatOfTheDemonstrations) {
  EXPECT_EQ(recorded_spelling({"keep-on", {"Mug_1", "Sink"}}), "keep Mug_1 On Sink");
  EXPECT_EQ(recorded_spelling({"keep-in", {"Mug_1", "Microwave"}}), "keep Mug_1 In Microwave");
  EXPECT_EQ(recorded_spelling({"turn-off", {"SinkKnob"}}), "turn SinkKnob");
  EXPECT_EQ(recorded_spelling({"moveto", {"Sink"}}), "moveto Sink");
}

TEST(SceneOf, IsTheRoomWithMostOfTheThings) {
  std::vector<scene::Scene> scenes;
  for (const char* name : {"kitchen", "living_room"}) scenes.push_back(*scene::load_scene(name));
  EXPECT_EQ(scene_of(demonstration({"(On Pillow_1 Loveseat_1)", "(On Coke_1 Shelf_1)"}, {}, {}), scenes).name,
            "living_room");
  EXPECT_EQ(scene_of(demonstration({"(On Mug_1 Sink)", "(On Coke_1 Stove)"}, {}, {}), scenes).name,
            "kitchen");
}

}  // namespace
}  // namespace goalnet::tools
