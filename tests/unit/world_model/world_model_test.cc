// Each relation, its borders, and what must not disturb it.
#include "components/world_model/world_model.h"

#include <gmock/gmock-more-matchers.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "tests/unit/world_model/test_world.h"

namespace goalnet::world_model {
namespace {

using test::default_robot;
using test::kitchen;
using test::TestWorld;

constexpr double kHalfTurn = std::numbers::pi;

std::vector<std::string> facts_about(const FactSet& facts, const std::string& relation) {
  std::vector<std::string> found;
  for (const Predicate& fact : facts)
    if (fact.relation == relation) found.push_back(to_string(fact));
  return found;
}

// Like the first states of the demonstrations: everything stands somewhere, nothing is near or held.
TEST(WorldModel, DescribesTheKitchenAtTheStart) {
  for (std::uint64_t seed = 0; seed <= 10; ++seed) {
    TestWorld world({}, seed);
    const FactSet& facts = world.look();
    EXPECT_THAT(facts_about(facts, "Near"), testing::IsEmpty());
    EXPECT_THAT(facts_about(facts, "Grasping"), testing::IsEmpty());
    EXPECT_THAT(facts_about(facts, "Held"), testing::IsEmpty());
    for (const scene::Object& object : kitchen().objects) {
      const scene::Region* region = kitchen().find_region(object.placement.on);
      const std::string relation = region->relation == scene::RegionRelation::kIn ? "In" : "On";
      EXPECT_TRUE(facts.contains({relation, object.name, region->name})) << object.name << " seed " << seed;
      EXPECT_TRUE(facts.contains({"IsGraspable", object.name, ""})) << object.name;
    }
    EXPECT_TRUE(world.holds("(In IceCream_1 Fridge)"));
    EXPECT_TRUE(world.holds("(In IceCream_1 FridgeRight)"));
    EXPECT_TRUE(world.holds("(IsSqueezeable Syrup_1)"));
    EXPECT_EQ(facts_about(facts, "On").size() + facts_about(facts, "In").size(),
              kitchen().objects.size() + 3);
  }
}

TEST(WorldModel, KnowsTheNamesOfTheRoom) {
  TestWorld world;
  EXPECT_THAT(world.model.world().objects, testing::IsSupersetOf({"Robot", "Mug_1", "Sink", "SinkKnob",
                                                                  "StoveFire_1", "Counter_1", "Fridge"}));
  EXPECT_TRUE(std::is_sorted(world.model.world().objects.begin(), world.model.world().objects.end()));
}

TEST(WorldModel, OnEverySurfaceAndInEveryContainer) {
  for (const scene::Region& region : kitchen().regions)
    for (std::size_t s = 0; s < region.supports.size(); ++s) {
      if (region.supports[s].reserved) continue;
      TestWorld world;
      world.put_on("Mug_1", region.name, s);
      if (region.name == "Counter_1") world.pose("Mug_1").translation().y() += 0.05;  // beside the others
      world.look();
      const std::string relation = region.relation == scene::RegionRelation::kIn ? "In" : "On";
      EXPECT_TRUE(world.holds(relation + " Mug_1 " + region.name)) << s;
      EXPECT_EQ(world.holds("On Mug_1 Counter_1"), region.name == "Counter_1");
    }
}

TEST(WorldModel, NothingIsOnWhatItHoversAboveOrLiesBeside) {
  TestWorld world;
  world.put_on("Mug_1", "Sink");
  world.pose("Mug_1").translation().z() += 0.05;
  world.look();
  EXPECT_FALSE(world.holds("On Mug_1 Sink"));
  world.put_on("Mug_1", "StoveFire_1");
  world.pose("Mug_1").translation().x() += 0.12;
  world.look_for(0.2);
  EXPECT_FALSE(world.holds("On Mug_1 StoveFire_1"));
}

TEST(WorldModel, AMugOnItsSideIsStillOnTheSurface) {
  TestWorld world;
  world.put_on("Mug_1", "Sink");
  world.pose("Mug_1").translation().z() += 0.0402;
  world.pose("Mug_1").linear() =
      Eigen::AngleAxisd(kHalfTurn / 2, Eigen::Vector3d::UnitX()).toRotationMatrix();
  world.look();
  EXPECT_TRUE(world.holds("On Mug_1 Sink"));
}

TEST(WorldModel, WhatMovesIsNotYetPutDown) {
  TestWorld world;
  world.put_on("Mug_1", "Sink");
  const double x = world.pose("Mug_1").translation().x();
  world.pose("Mug_1").translation() = Eigen::Vector3d(0, 0, 1);
  world.look();
  world.put_on("Mug_1", "Sink");
  world.pose("Mug_1").translation().x() = x - 0.02;
  world.look();
  EXPECT_FALSE(world.holds("On Mug_1 Sink"));
  world.pose("Mug_1").translation().x() = x - 0.01;  // 0.2 m/s
  world.look();
  EXPECT_FALSE(world.holds("On Mug_1 Sink"));
  world.look();
  EXPECT_TRUE(world.holds("On Mug_1 Sink"));
  world.pose("Mug_1").translation().x() = x;  // pushed along, it stays there
  world.look();
  EXPECT_TRUE(world.holds("On Mug_1 Sink"));
}

// Noise around every border: a relation may change once, not with every sample.
TEST(WorldModel, DoesNotFlickerAtTheBorder) {
  const scene::Region* burner = kitchen().find_region("StoveFire_1");
  std::mt19937 random(7);
  const auto noise = [&](double size) {
    return size * (static_cast<double>(random() % 2001) / 1000.0 - 1.0);
  };
  const auto changes = [&](const std::string& fact, auto disturb) {
    TestWorld world;
    int count = 0;
    bool was = false;
    for (int n = 0; n < 300; ++n) {
      disturb(world);
      world.look();
      if (n > 0 && world.holds(fact) != was) ++count;
      was = world.holds(fact);
    }
    return count;
  };
  EXPECT_LE(changes("On Mug_1 StoveFire_1",
                    [&](TestWorld& world) {  // sideways
                      world.put_on("Mug_1", "StoveFire_1");
                      world.pose("Mug_1").translation().x() +=
                          0.5 * burner->supports[0].size_y + 0.006 + noise(0.001);
                    }),
            1);
  EXPECT_LE(changes("On Mug_1 StoveFire_1",
                    [&](TestWorld& world) {  // height
                      world.put_on("Mug_1", "StoveFire_1");
                      world.pose("Mug_1").translation().z() += 0.015 + noise(0.002);
                    }),
            1);
  EXPECT_LE(changes("Near Robot Mug_1",
                    [&](TestWorld& world) {  // distance
                      const Eigen::Vector3d mug = world.pose("Mug_1").translation();
                      world.drive_to(mug.x() - 0.95 + noise(0.03), mug.y(), 0.0);
                    }),
            1);
  EXPECT_LE(changes("Near Robot Mug_1",
                    [&](TestWorld& world) {  // direction
                      const Eigen::Vector3d mug = world.pose("Mug_1").translation();
                      world.drive_to(mug.x() - 0.8, mug.y(), 1.4 + noise(0.05));
                    }),
            1);
  EXPECT_LE(changes("Near Robot Sink",
                    [&](TestWorld& world) { world.drive_to(-0.2, 2.0 - 0.95 + noise(0.03), kHalfTurn / 2); }),
            1);
  EXPECT_LE(changes("state SinkKnob TapIsOn",
                    [&](TestWorld& world) {
                      world.joint("SinkKnob_joint") = 45.0 * kHalfTurn / 180.0 + noise(0.1);
                    }),
            1);
  EXPECT_LE(changes("Held Mug_1 LeftHand",
                    [&](TestWorld& world) {
                      world.grip_mug("left", "Mug_1");
                      world.joint("left_finger_1") += 0.005 + noise(0.002);
                    }),
            1);
}

// The control: with a single threshold the same noise does make the fact flicker.
TEST(WorldModel, FlickersWithoutHysteresis) {
  Params params;
  params.near_object.exit = params.near_object.enter;
  TestWorld world(params);
  std::mt19937 random(7);
  int changes = 0;
  bool was = false;
  for (int n = 0; n < 300; ++n) {
    const Eigen::Vector3d mug = world.pose("Mug_1").translation();
    world.drive_to(mug.x() - 0.95 + 0.03 * (static_cast<double>(random() % 2001) / 1000.0 - 1.0), mug.y(),
                   0.0);
    world.look();
    if (world.holds("Near Robot Mug_1") != was) ++changes;
    was = world.holds("Near Robot Mug_1");
  }
  EXPECT_GT(changes, 50);
}

TEST(WorldModel, NearIsCloseAndInFront) {
  TestWorld world;
  const Eigen::Vector3d mug = world.pose("Mug_1").translation();
  world.drive_to(mug.x() - 0.7, mug.y(), 0.0);
  world.look();
  EXPECT_TRUE(world.holds("Near Robot Mug_1"));
  EXPECT_TRUE(world.holds("Near Robot Counter_1"));
  EXPECT_FALSE(world.holds("Near Robot Salt_1"));  // at the other end of the counter
  EXPECT_FALSE(world.holds("Near Robot Sink"));
  world.drive_to(mug.x() - 0.7, mug.y(), kHalfTurn);  // its back to them
  world.look();
  EXPECT_FALSE(world.holds("Near Robot Mug_1"));
  EXPECT_FALSE(world.holds("Near Robot Counter_1"));

  world.drive_to(-0.2, 2.0 - 0.6, kHalfTurn / 2 + 2.0 * kHalfTurn);  // a yaw that has turned around
  world.look();
  EXPECT_TRUE(world.holds("Near Robot Sink"));
  EXPECT_TRUE(world.holds("Near Robot SinkKnob"));  // belongs to the sink
  EXPECT_FALSE(world.holds("Near Robot Microwave"));
  world.drive_to(0, 0, 0);
  world.look();
  world.drive_to(-1.5, 2.0 - 0.6, kHalfTurn / 2);
  world.look();
  EXPECT_TRUE(world.holds("Near Robot Stove"));
  EXPECT_TRUE(world.holds("Near Robot StoveFire_3"));
  EXPECT_FALSE(world.holds("Near Robot Sink"));
  EXPECT_FALSE(world.holds("Near Robot SinkKnob"));

  // The doors keep the robot at a distance; what stands on the shelf before it is near all the same.
  world.drive_to(-0.31, -1.25, -1.83);
  world.look();
  EXPECT_TRUE(world.holds("Near Robot IceCream_1"));
  EXPECT_TRUE(world.holds("Near Robot Fridge"));
  world.drive_to(-0.31, -0.7, -1.83);
  world.look();
  EXPECT_FALSE(world.holds("Near Robot IceCream_1"));
}

TEST(WorldModel, HoldsWhatTheFingersEncloseAndCarry) {
  TestWorld world;
  world.look();
  world.grip_mug("left", "Mug_1");
  world.look();
  EXPECT_FALSE(world.holds("Held Mug_1 LeftHand"));  // not yet: it has to last
  world.look_for(0.15);
  EXPECT_TRUE(world.holds("Held Mug_1 LeftHand"));
  EXPECT_TRUE(world.holds("Grasping Robot Mug_1"));
  EXPECT_FALSE(world.holds("On Mug_1 Counter_1"));
  EXPECT_FALSE(world.holds("Near Robot Mug_1"));  // it is with the robot, as in the demonstrations
  // It comes along.
  for (int n = 0; n < 20; ++n) {
    world.joint("base_x") -= 0.03;
    world.grip_mug("left", "Mug_1");
    world.look();
    EXPECT_TRUE(world.holds("Held Mug_1 LeftHand"));
  }
  // Open fingers do not hold.
  world.joint("left_finger_1") = world.joint("left_finger_2") = 0.06;
  world.look();
  EXPECT_FALSE(world.holds("Grasping Robot Mug_1"));
}

TEST(WorldModel, DoesNotHoldWhatOneFingerTouchesOrPassesBy) {
  TestWorld world;
  world.grip_mug("right", "Mug_1");
  world.joint("right_finger_1") = 0.058;  // only the other finger touches
  world.look_for(0.3);
  EXPECT_FALSE(world.holds("Held Mug_1 RightHand"));

  world.grip_mug("right", "Mug_1");  // the hand moves along the mug without taking it
  const scene::Pose start = world.pose("Mug_1");
  for (int n = 0; n < 10; ++n) {
    world.pose("Mug_1") = start;
    world.pose("Mug_1").translation() += (0.012 * n - 0.05) * start.linear().col(2);
    world.look();
    EXPECT_FALSE(world.holds("Held Mug_1 RightHand")) << n;
  }
}

TEST(WorldModel, TheTrayCarries) {
  TestWorld world;
  for (int n = 0; n < 30; ++n) {
    world.joint("base_y") = -0.02 * n;
    const scene::Pose tray = world.link("tray");
    world.pose("Glass_1") = tray * scene::make_pose(default_robot().tray->slots[0].position, {0, 0, 0.3});
    world.look();
    if (n == 0) continue;
    EXPECT_TRUE(world.holds("Held Glass_1 Tray")) << n;
    EXPECT_TRUE(world.holds("Grasping Robot Glass_1"));
    EXPECT_FALSE(world.holds("Near Robot Glass_1"));
  }
}

TEST(WorldModel, ThingsOnAndInOtherThings) {
  TestWorld world;
  const Eigen::Vector3d plate = world.pose("Plate_1").translation();
  world.put("Mug_1", plate.x(), plate.y(), plate.z() + 0.006);
  world.look();
  EXPECT_TRUE(world.holds("On Mug_1 Plate_1"));
  EXPECT_TRUE(world.holds("In Mug_1 Plate_1"));  // a soup plate
  EXPECT_FALSE(world.holds("On Mug_1 Counter_1"));
  EXPECT_TRUE(world.holds("On Plate_1 Counter_1"));

  const Eigen::Vector3d kettle = world.pose("Kettle").translation();
  world.put("BoiledEgg_1", kettle.x(), kettle.y(), kettle.z() + 0.009);
  world.look_for(0.1);
  EXPECT_TRUE(world.holds("In BoiledEgg_1 Kettle"));
  EXPECT_TRUE(world.holds("On Kettle Counter_1"));

  // A spoon that leans in a mug: its handle stands out.
  const Eigen::Vector3d glass = world.pose("Glass_1").translation();
  scene::Pose spoon =
      scene::make_pose({glass.x(), glass.y(), glass.z() + 0.10}, {0, kHalfTurn / 2 - 0.15, 0});
  world.pose("Spoon_1") = spoon;
  world.look_for(0.1);
  EXPECT_TRUE(world.holds("In Spoon_1 Glass_1"));
}

TEST(WorldModel, DevicesFollowTheirJoints) {
  TestWorld world;
  world.look();
  EXPECT_FALSE(world.holds("state SinkKnob TapIsOn"));
  world.joint("SinkKnob_joint") = 1.2;
  world.joint("FridgeLeftDoor_joint") = 1.5;
  world.joint("MicrowaveDoor_joint") = 1.0;
  world.joint("StoveKnob_3_joint") = 1.5;
  world.look();
  EXPECT_TRUE(world.holds("state SinkKnob TapIsOn"));
  EXPECT_TRUE(world.holds("state Fridge LeftDoorIsOpen"));
  EXPECT_FALSE(world.holds("state Fridge RightDoorIsOpen"));
  EXPECT_TRUE(world.holds("state Microwave DoorIsOpen"));
  EXPECT_TRUE(world.holds("state Stove StoveFire3"));
  world.joint("SinkKnob_joint") = 0.1;
  world.look();
  EXPECT_FALSE(world.holds("state SinkKnob TapIsOn"));
}

// Perception may tell of doors on the same topic as the robot's driver of its joints, late and alone.
TEST(WorldModel, DoorsAloneSayNothingAboutTheRobot) {
  TestWorld world;
  world.look();
  const std::int64_t seen = world.model.joints_time_ns();
  const ObservedJoints late{seen - 3'000'000'000, {"FridgeLeftDoor_joint"}, {1.5}};
  EXPECT_EQ(world.model.observe(late), 0u);
  EXPECT_TRUE(world.model.update().facts.contains({"state", "Fridge", "LeftDoorIsOpen"}));
  const ObservedJoints early{seen + 3'000'000'000, {"FridgeLeftDoor_joint"}, {0.0}};
  EXPECT_EQ(world.model.observe(early), 0u);
  EXPECT_FALSE(world.model.update().facts.contains({"state", "Fridge", "LeftDoorIsOpen"}));
  EXPECT_EQ(world.model.joints_time_ns(), seen);
}

TEST(WorldModel, TakesContentsAndSwitchesAsPerceived) {
  TestWorld world;
  world.model.observe(std::vector<ObservedState>{
      {"Mug_1", {"Coffee", "temperatureHigh"}}, {"Microwave", {"MicrowaveIsOn"}}, {"SinkKnob", {"TapIsOn"}}});
  world.look();
  EXPECT_TRUE(world.holds("state Mug_1 Coffee"));
  EXPECT_TRUE(world.holds("state Mug_1 temperatureHigh"));
  EXPECT_TRUE(world.holds("state Microwave MicrowaveIsOn"));
  EXPECT_TRUE(world.holds("state SinkKnob TapIsOn"));  // its joint has not been seen
  world.joint("SinkKnob_joint") = 0.0;
  world.look();
  EXPECT_FALSE(world.holds("state SinkKnob TapIsOn"));  // the joint knows better
  world.model.observe(std::vector<ObservedState>{{"Mug_1", {"Water"}}});
  world.look();
  EXPECT_FALSE(world.holds("state Mug_1 Coffee"));
  EXPECT_TRUE(world.holds("state Mug_1 Water"));
}

TEST(WorldModel, LeavesOutWhatMakesNoSense) {
  TestWorld world;
  world.look();
  const FactSet before = world.model.world().facts;
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  scene::Pose broken = scene::Pose::Identity();
  broken.translation().x() = nan;
  EXPECT_EQ(world.model.observe(
                ObservedPoses{world.time_ns, {{"Mug_1", broken}, {"Dragon_1", scene::Pose::Identity()}}}),
            2u);
  broken.translation().x() = inf;
  EXPECT_EQ(world.model.observe(ObservedPoses{world.time_ns, {{"Mug_1", broken}}}), 1u);
  EXPECT_EQ(world.model.observe(ObservedJoints{world.time_ns, {"base_x", "SinkKnob_joint"}, {nan, inf}}), 2u);
  EXPECT_EQ(world.model.observe(ObservedJoints{world.time_ns, {"base_x", "base_y"}, {1.0}}), 2u);
  EXPECT_EQ(world.model.observe(
                std::vector<ObservedState>{{"Dragon_1", {"Fire"}}, {"Mug_1", {"two words", "", "(x"}}}),
            4u);
  // Old news.
  EXPECT_EQ(world.model.observe(ObservedPoses{world.time_ns - 1, {{"Mug_1", scene::Pose::Identity()}}}), 1u);
  EXPECT_EQ(world.model.observe(ObservedJoints{world.time_ns - 1, {"base_x"}, {5.0}}), 1u);
  EXPECT_EQ(world.model.update().facts, before);
}

TEST(WorldModel, ForgetsWhatIsNoLongerSeen) {
  TestWorld world;
  world.look();
  std::erase_if(world.objects, [](const ObservedPose& object) { return object.name == "Mug_1"; });
  world.look_for(1.9);
  EXPECT_TRUE(world.holds("On Mug_1 Counter_1"));
  world.look_for(0.3);
  EXPECT_FALSE(world.holds("On Mug_1 Counter_1"));
  EXPECT_TRUE(world.holds("IsGraspable Mug_1"));
  EXPECT_TRUE(world.holds("On Kettle Counter_1"));
}

TEST(WorldModel, ClaimsNothingBeforeItHasSeenEverything) {
  TestWorld world;
  EXPECT_FALSE(world.model.complete());
  EXPECT_TRUE(world.model.update().facts.empty());
  world.model.observe(ObservedPoses{5, world.objects});
  EXPECT_FALSE(world.model.complete());
  EXPECT_TRUE(world.model.update().facts.empty());
  world.joints.time_ns = 3;
  world.model.observe(world.joints);
  EXPECT_TRUE(world.model.complete());
  EXPECT_EQ(world.model.time_ns(), 3);
  EXPECT_FALSE(world.model.update().facts.empty());
}

TEST(WorldModel, AnEmptySceneIsFine) {
  scene::Scene empty;
  empty.symbols = {"Robot"};
  WorldModel model(empty, default_robot());
  model.observe(ObservedPoses{1, {}});
  model.observe(ObservedJoints{1, {}, {}});
  EXPECT_TRUE(model.update().facts.empty());
  EXPECT_THAT(model.world().objects, testing::ElementsAre("Robot"));
}

// The poses of fast hands are compared with the joints of the same moment, not with the newest.
TEST(WorldModel, PairsPosesWithTheJointsOfTheirMoment) {
  TestWorld world;
  world.grip_mug("left", "Mug_1");
  world.look_for(0.3);
  for (int n = 0; n < 10; ++n) {
    world.grip_mug("left", "Mug_1");
    world.time_ns += 50'000'000;
    world.joints.time_ns = world.time_ns;
    world.model.observe(world.joints);
    world.joint("base_x") += 0.04;  // 20 ms later and 4 cm on
    world.joints.time_ns += 20'000'000;
    world.model.observe(world.joints);
    world.model.observe(ObservedPoses{world.time_ns, world.objects});
    world.model.update();
    EXPECT_TRUE(world.holds("Held Mug_1 LeftHand")) << n;
    world.time_ns += 20'000'000;
  }
}

}  // namespace
}  // namespace goalnet::world_model
