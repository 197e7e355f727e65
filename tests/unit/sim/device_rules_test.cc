// Each rule of the kitchen, by hand-made joint positions and poses: no physics.
#include "sim/device_rules.h"

#include <map>
#include <numbers>

#include <gtest/gtest.h>

#include "sim/device_geometry.h"
#include "tests/unit/sim/test_world.h"

namespace goalnet::sim {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

class Devices : public testing::Test {
 protected:
  Devices()
      : rules_(test_scene()), poses_(scene::initial_poses(test_scene(), 0)), held_(poses_.size(), false) {}

  void pass(double seconds) {
    DeviceInput input;
    input.joint = [this](const std::string& name) { return joints_[name]; };
    input.objects = poses_;
    input.held = held_;
    for (double t = 0; t < seconds - 1e-9; t += 0.01) rules_.update(input, 0.01);
  }
  bool fact(const std::string& text) const { return rules_.facts().contains(*parse_predicate(text)); }
  std::size_t index(const std::string& name) const {
    for (std::size_t i = 0; i < test_scene().objects.size(); ++i) {
      if (test_scene().objects[i].name == name) return i;
    }
    throw std::runtime_error("no object " + name);
  }
  scene::Pose& pose(const std::string& name) { return poses_[index(name)]; }
  // Upright at a spot or the first support of a region.
  void put(const std::string& name, const std::string& region_name, const std::string& spot_name = "") {
    const scene::Region& region = *test_scene().find_region(region_name);
    scene::Pose local = region.supports[0].frame;
    for (const auto& spot : region.spots) {
      if (spot.name == spot_name) local = spot.frame;
    }
    pose(name) = test_scene().find_fixture(region.fixture)->pose * local;
  }
  // Tilted about y at `tilt`, with the lowest point of the mouth's edge above the middle of the receiver's
  // mouth.
  void tilt_over(const std::string& giver, const std::string& receiver, double tilt) {
    const scene::ObjectModel& model = *test_scene().find_model_of(giver);
    scene::Pose tilted = scene::Pose::Identity();
    tilted.linear() = Eigen::AngleAxisd(tilt, Eigen::Vector3d::UnitY()).toRotationMatrix();
    const Eigen::Vector3d lip =
        tilted * Eigen::Vector3d(model.cavity->radius, 0, model.cavity->mouth.translation().z());
    const scene::Pose& into = pose(receiver);
    const double height = test_scene().find_model_of(receiver)->height();
    tilted.translation() = Eigen::Vector3d(into.translation()) + Eigen::Vector3d(0, 0, height + 0.08) - lip;
    pose(giver) = tilted;
  }

  DeviceRules rules_;
  std::vector<scene::Pose> poses_;
  std::vector<bool> held_;
  std::map<std::string, double> joints_;
};

TEST_F(Devices, StartWithTheStatesOfTheScene) {
  EXPECT_TRUE(fact("(state Mug_1 Coffee)"));
  EXPECT_TRUE(fact("(state IceCream_1 ScoopsLeft)"));
  EXPECT_FALSE(fact("(state SinkKnob TapIsOn)"));
}

TEST_F(Devices, KnobsSwitchWithHysteresis) {
  joints_["SinkKnob_joint"] = 40 * kDegree;
  pass(0.1);
  EXPECT_FALSE(fact("(state SinkKnob TapIsOn)"));
  joints_["SinkKnob_joint"] = 50 * kDegree;
  pass(0.1);
  EXPECT_TRUE(fact("(state SinkKnob TapIsOn)"));
  joints_["SinkKnob_joint"] = 40 * kDegree;
  pass(0.1);
  EXPECT_TRUE(fact("(state SinkKnob TapIsOn)"));
  joints_["SinkKnob_joint"] = 20 * kDegree;
  pass(0.1);
  EXPECT_FALSE(fact("(state SinkKnob TapIsOn)"));
}

TEST_F(Devices, EachStoveKnobHasItsBurner) {
  for (int i = 1; i <= 4; ++i) {
    const std::string number = std::to_string(i);
    joints_["StoveKnob_" + number + "_joint"] = 90 * kDegree;
    pass(0.02);
    EXPECT_TRUE(fact("(state Stove StoveFire" + number + ")"));
    joints_["StoveKnob_" + number + "_joint"] = 0.0;
    pass(0.02);
    EXPECT_FALSE(fact("(state Stove StoveFire" + number + ")"));
  }
}

TEST_F(Devices, ButtonTogglesOncePerPress) {
  joints_["MicrowaveButton_joint"] = 0.0;
  pass(0.1);
  joints_["MicrowaveButton_joint"] = 0.01;
  pass(1.0);
  EXPECT_TRUE(fact("(state Microwave MicrowaveIsOn)"));
  joints_["MicrowaveButton_joint"] = 0.004;  // not fully released: no second press
  pass(0.1);
  joints_["MicrowaveButton_joint"] = 0.01;
  pass(0.1);
  EXPECT_TRUE(fact("(state Microwave MicrowaveIsOn)"));
  joints_["MicrowaveButton_joint"] = 0.0;
  pass(0.1);
  joints_["MicrowaveButton_joint"] = 0.01;
  pass(0.1);
  EXPECT_FALSE(fact("(state Microwave MicrowaveIsOn)"));
}

TEST_F(Devices, OpenMicrowaveDoesNotRun) {
  joints_["MicrowaveDoor_joint"] = 90 * kDegree;
  pass(0.1);
  EXPECT_TRUE(fact("(state Microwave DoorIsOpen)"));
  joints_["MicrowaveButton_joint"] = 0.01;
  pass(0.1);
  EXPECT_FALSE(fact("(state Microwave MicrowaveIsOn)"));
}

TEST_F(Devices, OpeningTheMicrowaveStopsIt) {
  rules_.set_fact(*parse_predicate("(state Microwave MicrowaveIsOn)"), true);
  joints_["MicrowaveDoor_joint"] = 90 * kDegree;
  pass(0.02);
  EXPECT_FALSE(fact("(state Microwave MicrowaveIsOn)"));
}

TEST_F(Devices, RunningTapFillsWhatStandsUnderItAfterTwoSeconds) {
  put("Mug_1", "Sink", "under_tap");
  joints_["SinkKnob_joint"] = 90 * kDegree;
  pass(1.9);
  EXPECT_FALSE(fact("(state Mug_1 Water)"));
  pass(0.2);
  EXPECT_TRUE(fact("(state Mug_1 Water)"));
  EXPECT_TRUE(fact("(state Mug_1 Coffee)"));
}

TEST_F(Devices, InterruptedWaterStartsAnew) {
  put("Mug_1", "Sink", "under_tap");
  joints_["SinkKnob_joint"] = 90 * kDegree;
  pass(1.5);
  joints_["SinkKnob_joint"] = 0;
  pass(0.1);
  joints_["SinkKnob_joint"] = 90 * kDegree;
  pass(1.5);
  EXPECT_FALSE(fact("(state Mug_1 Water)"));
}

TEST_F(Devices, TapFillsOnlyUprightVesselsBelowIt) {
  joints_["SinkKnob_joint"] = 90 * kDegree;
  put("Mug_1", "Sink", "left");
  put("Glass_1", "Sink", "under_tap");
  pose("Glass_1").linear() = Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX()).toRotationMatrix();
  pass(3.0);
  EXPECT_FALSE(fact("(state Mug_1 Water)"));
  EXPECT_FALSE(fact("(state Glass_1 Water)"));
}

TEST_F(Devices, WaterCoolsWhatIsHot) {
  rules_.set_fact(*parse_predicate("(state Kettle temperatureHigh)"), true);
  put("Kettle", "Sink", "under_tap");
  joints_["SinkKnob_joint"] = 90 * kDegree;
  pass(2.1);
  EXPECT_TRUE(fact("(state Kettle Water)"));
  EXPECT_FALSE(fact("(state Kettle temperatureHigh)"));
}

TEST_F(Devices, BurnerHeatsWhatStandsOnItAndNothingElse) {
  put("Kettle", "StoveFire_2");
  put("Mug_1", "StoveFire_3");
  joints_["StoveKnob_2_joint"] = 90 * kDegree;
  pass(2.9);
  EXPECT_FALSE(fact("(state Kettle temperatureHigh)"));
  pass(0.2);
  EXPECT_TRUE(fact("(state Kettle temperatureHigh)"));
  EXPECT_FALSE(fact("(state Mug_1 temperatureHigh)"));
}

TEST_F(Devices, MicrowaveHeatsWhatIsInside) {
  put("Mug_1", "Microwave");
  rules_.set_fact(*parse_predicate("(state Microwave MicrowaveIsOn)"), true);
  pass(3.1);
  EXPECT_TRUE(fact("(state Mug_1 temperatureHigh)"));
  EXPECT_FALSE(fact("(state Kettle temperatureHigh)"));
}

TEST_F(Devices, DispenserFillsAVesselHeldBelowItUntilTheDoorOpens) {
  joints_["FridgeButton_joint"] = 0.0;
  pass(0.1);
  joints_["FridgeButton_joint"] = 0.01;
  pass(0.1);
  EXPECT_TRUE(fact("(state Fridge WaterDispenserIsOpen)"));
  const auto& rule = test_scene().rules.fills[1];
  const Eigen::Vector3d outlet = outlet_position(test_scene(), rule, [](const std::string&) { return 0.0; });
  pose("Glass_1") = scene::make_pose(outlet - Eigen::Vector3d(0, 0, 0.2), Eigen::Vector3d::Zero());
  pass(2.1);
  EXPECT_TRUE(fact("(state Glass_1 Water)"));
  joints_["FridgeLeftDoor_joint"] = 60 * kDegree;
  pass(0.1);
  EXPECT_FALSE(fact("(state Fridge WaterDispenserIsOpen)"));
}

TEST_F(Devices, DispenserMovesWithItsDoor) {
  const auto& rule = test_scene().rules.fills[1];
  const Eigen::Vector3d closed = outlet_position(test_scene(), rule, [](const std::string&) { return 0.0; });
  const Eigen::Vector3d open = outlet_position(test_scene(), rule, [](const std::string&) { return 1.2; });
  EXPECT_GT((closed - open).norm(), 0.2);
}

TEST_F(Devices, PouringMovesTheContents) {
  tilt_over("Mug_1", "Glass_1", 100 * kDegree);
  pass(0.6);
  EXPECT_TRUE(fact("(state Glass_1 Coffee)"));
  EXPECT_FALSE(fact("(state Mug_1 Coffee)"));
}

TEST_F(Devices, TiltingTooLittlePoursNothing) {
  tilt_over("Mug_1", "Glass_1", 50 * kDegree);
  pass(3.0);
  EXPECT_FALSE(fact("(state Glass_1 Coffee)"));
  EXPECT_TRUE(fact("(state Mug_1 Coffee)"));
}

TEST_F(Devices, PouringBesideIsSpilling) {
  tilt_over("Mug_1", "Glass_1", 100 * kDegree);
  pose("Mug_1").translation().x() += 0.3;
  pass(2.0);
  EXPECT_FALSE(fact("(state Glass_1 Coffee)"));
  EXPECT_FALSE(fact("(state Mug_1 Coffee)"));
}

TEST_F(Devices, SaltIsShakenOutAndNeverEmpty) {
  tilt_over("Salt_1", "InstantRamen_1", 120 * kDegree);
  pass(1.1);
  EXPECT_TRUE(fact("(state InstantRamen_1 Salt)"));
}

TEST_F(Devices, SyrupNeedsAPressingHand) {
  tilt_over("Syrup_2", "Mug_1", 130 * kDegree);
  pass(1.5);
  EXPECT_FALSE(fact("(state Mug_1 Chocolate)"));
  held_[index("Syrup_2")] = true;
  pass(1.1);
  EXPECT_TRUE(fact("(state Mug_1 Chocolate)"));
  EXPECT_TRUE(fact("(state Syrup_2 Chocolate)"));
}

TEST_F(Devices, ThingsInsideAVesselCount) {
  const Eigen::Vector3d bottom = Eigen::Vector3d(pose("Bowl_1").translation()) + Eigen::Vector3d(0, 0, 0.01);
  pose("BoiledEgg_1") = scene::make_pose(bottom, Eigen::Vector3d::Zero());
  pass(0.6);
  EXPECT_TRUE(fact("(state Bowl_1 Egg)"));
}

TEST_F(Devices, SpoonScoopsAndGivesTheScoop) {
  const Eigen::Vector3d tub = pose("IceCream_1").translation();
  // Bowl of the spoon down in the tub.
  pose("Spoon_1") =
      scene::make_pose(tub + Eigen::Vector3d(0, 0, 0.07 + 0.07), Eigen::Vector3d(0, 90 * kDegree, 0));
  pass(0.6);
  EXPECT_TRUE(fact("(state Spoon_1 ScoopsLeft)"));
  EXPECT_TRUE(fact("(state IceCream_1 ScoopsLeft)"));
  const Eigen::Vector3d bowl = pose("Bowl_1").translation();
  pose("Spoon_1") =
      scene::make_pose(bowl + Eigen::Vector3d(-0.07, 0, 0.15), Eigen::Vector3d(180 * kDegree, 0, 0));
  pass(0.6);
  EXPECT_TRUE(fact("(state Bowl_1 IceCream)"));
  EXPECT_FALSE(fact("(state Spoon_1 ScoopsLeft)"));
}

TEST_F(Devices, ADeadDeviceDoesNotChange) {
  rules_.disable("SinkKnob", true);
  joints_["SinkKnob_joint"] = 90 * kDegree;
  pass(0.1);
  EXPECT_FALSE(fact("(state SinkKnob TapIsOn)"));
  rules_.disable("SinkKnob", false);
  pass(0.1);
  EXPECT_TRUE(fact("(state SinkKnob TapIsOn)"));
}

TEST_F(Devices, RegionsOnAndIn) {
  const auto& scene = test_scene();
  EXPECT_TRUE(in_region(scene, *scene.find_region("Counter_1"), pose("Mug_1")));
  EXPECT_FALSE(in_region(scene, *scene.find_region("Sink"), pose("Mug_1")));
  EXPECT_TRUE(in_region(scene, *scene.find_region("FridgeLeft"), pose("CanadaDry_1")));
  EXPECT_FALSE(in_region(scene, *scene.find_region("FridgeRight"), pose("CanadaDry_1")));
  scene::Pose lifted = pose("Mug_1");
  lifted.translation().z() += 0.2;
  EXPECT_FALSE(in_region(scene, *scene.find_region("Counter_1"), lifted));
}

}  // namespace
}  // namespace goalnet::sim
