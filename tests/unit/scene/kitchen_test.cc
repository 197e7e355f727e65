// What the shipped kitchen promises to those who work in it.
#include <cmath>
#include <set>

#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>

#include "components/scene/scene.h"

namespace goalnet::scene {
namespace {

const Scene& kitchen() {
  static const Scene scene = [] {
    auto loaded = load_scene("kitchen");
    if (!loaded) throw std::runtime_error(loaded.error().message);
    return *loaded;
  }();
  return scene;
}

TEST(Kitchen, HasTheObjectsOfTheDomain) {
  const std::vector<std::string> wanted = {
      "StoveFire_1", "Glass_1",     "IceCream_1",     "StoveFire_2", "Counter_1", "Plate_1",
      "Fork_1",      "Microwave",   "Salt_1",         "Bowl_1",      "SinkKnob",  "Ramen_1",
      "Stove",       "Spoon_1",     "CanadaDry_1",    "BoiledEgg_1", "Coke_1",    "Sink",
      "Plate_2",     "StoveFire_4", "LongCup_2",      "Mug_1",       "Fridge",    "StoveFire_3",
      "Kettle",      "Syrup_1",     "InstantRamen_1", "Syrup_2",     "LongCup_1", "EnergyDrink_1",
      "Robot"};
  EXPECT_THAT(kitchen().symbols, testing::UnorderedElementsAreArray(wanted));
  EXPECT_EQ(kitchen().objects.size(), 20u);
}

TEST(Kitchen, HasTheDevicesThatPlansName) {
  for (const char* name : {"SinkKnob", "StoveKnob_1", "StoveKnob_2", "StoveKnob_3", "StoveKnob_4"}) {
    ASSERT_TRUE(kitchen().find_part(name)) << name;
    EXPECT_EQ(kitchen().find_part(name).part->use, PartUse::kKnob) << name;
  }
  for (const char* name : {"Microwave", "FridgeLeftDoor", "FridgeRightDoor"}) {
    ASSERT_TRUE(kitchen().find_part(name)) << name;
    EXPECT_EQ(kitchen().find_part(name).part->use, PartUse::kDoor) << name;
  }
  for (const char* name : {"MicrowaveButton", "FridgeButton"}) {
    ASSERT_TRUE(kitchen().find_part(name)) << name;
    EXPECT_TRUE(kitchen().find_part(name).part->push.has_value()) << name;
  }
  EXPECT_EQ(kitchen().find_part("Microwave").part->name, "MicrowaveDoor");
}

TEST(Kitchen, HasTheRegionsOfTheFacts) {
  for (const char* name : {"Counter_1", "Sink", "StoveFire_1", "StoveFire_2", "StoveFire_3", "StoveFire_4"}) {
    ASSERT_NE(kitchen().find_region(name), nullptr) << name;
    EXPECT_EQ(kitchen().find_region(name)->relation, RegionRelation::kOn) << name;
  }
  for (const char* name : {"Microwave", "FridgeLeft", "FridgeRight"}) {
    ASSERT_NE(kitchen().find_region(name), nullptr) << name;
    EXPECT_EQ(kitchen().find_region(name)->relation, RegionRelation::kIn) << name;
    EXPECT_FALSE(kitchen().find_region(name)->door.empty()) << name;
  }
}

TEST(Kitchen, GraspableThingsStandApart) {
  const auto pose = initial_poses(kitchen(), 0);
  for (std::size_t i = 0; i < pose.size(); ++i) {
    for (std::size_t j = i + 1; j < pose.size(); ++j) {
      const double distance = (pose[i].translation() - pose[j].translation()).norm();
      EXPECT_GT(distance, 0.19) << kitchen().objects[i].name << " and " << kitchen().objects[j].name;
    }
  }
}

TEST(Kitchen, EveryGraspFitsAGripperOfTwelveCentimetres) {
  for (const auto& model : kitchen().models) {
    for (const auto& grasp : model.grasps) {
      EXPECT_LT(grasp.width, 0.11) << model.name << " " << grasp.name;
      EXPECT_LE(grasp.open_width, 0.12) << model.name << " " << grasp.name;
      EXPECT_GT(grasp.open_width, grasp.width) << model.name << " " << grasp.name;
    }
  }
}

TEST(Kitchen, VesselsHaveTheirMouthOnTop) {
  for (const auto& model : kitchen().models) {
    if (!model.cavity) continue;
    EXPECT_GT(model.cavity->mouth.linear()(2, 2), 0.99) << model.name;
    EXPECT_LE(model.cavity->mouth.translation().z(), model.height() + 1e-6) << model.name;
  }
}

TEST(Kitchen, SeedsMoveThingsByCentimetresAndKeepThemApart) {
  const auto nominal = initial_poses(kitchen(), 0);
  std::set<double> seen;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto pose = initial_poses(kitchen(), seed);
    for (std::size_t i = 0; i < pose.size(); ++i) {
      const double moved = (pose[i].translation() - nominal[i].translation()).norm();
      EXPECT_LT(moved, 0.03) << kitchen().objects[i].name;
      EXPECT_DOUBLE_EQ(pose[i].translation().z(), nominal[i].translation().z());
    }
    seen.insert(pose[0].translation().x());
  }
  EXPECT_EQ(seen.size(), 20u);
}

TEST(Kitchen, TheSameSeedGivesTheSameBits) {
  const auto a = initial_poses(kitchen(), 7), b = initial_poses(kitchen(), 7);
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].matrix(), b[i].matrix());
}

TEST(Kitchen, SeedsMeanTheSameEverywhere) {
  // A fixed number: a change of the generator would change every recorded run.
  const auto pose = initial_poses(kitchen(), 1);
  std::size_t mug = 0;
  while (kitchen().objects[mug].name != "Mug_1") ++mug;
  EXPECT_NEAR(pose[mug].translation().x(), 1.3370, 5e-4);
  EXPECT_NEAR(pose[mug].translation().y(), 0.6098, 5e-4);
}

TEST(Kitchen, PartPoseFollowsItsJoint) {
  const auto door = kitchen().find_part("FridgeLeftDoor");
  const auto handle_at = [&](double q) {
    const Pose pose = part_pose(*door.fixture, *door.part, [&](const std::string&) { return q; });
    return Eigen::Vector3d((pose * door.part->grasps[0].frame).translation());
  };
  // Opened, the handle comes towards the robot: out of the front of the fridge.
  const Pose to_fixture = door.fixture->pose.inverse();
  EXPECT_LT((to_fixture * handle_at(1.0)).x(), (to_fixture * handle_at(0.0)).x() - 0.2);
}

}  // namespace
}  // namespace goalnet::scene
