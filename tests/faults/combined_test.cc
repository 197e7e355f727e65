// Two and more disturbances in one run, at the worst moments: somebody's hand in the robot's work, and
// sensors that fail for seconds. The loop gets there all the same, or ends with a typed outcome, a message,
// and the robot at rest.
#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>

#include "sim/simulator_node.h"
#include "tests/faults/loop_fixture.h"

namespace goalnet::tools {
namespace {

class CombinedFault : public LoopFixture {
 protected:
  sim::SensorFaults& sensors() {
    return dynamic_cast<sim::SimulatorNode&>(loop_->component("simulator")).sensor_faults();
  }
  void move(const std::string& name, double x, double y, double z = 0.0) {
    scene::Pose pose = loop_->world().object_pose(object(name));
    pose.translation() += Eigen::Vector3d(x, y, z);
    loop_->world().set_object_pose(object(name), pose);
  }
  void set_joint(const std::string& name, double position) {
    const int joint = loop_->world().find_fixture_joint(name);
    ASSERT_GE(joint, 0) << name;
    loop_->world().set_fixture_position(static_cast<std::size_t>(joint), position);
  }
  bool holds_something() { return !loop_->world().held().empty(); }
  void drop() {
    for (const char* arm : {"left", "right"}) loop_->world().drop_grasp(arm);
  }
  void blind_for(double seconds) {
    sensors().poses_lost = true;
    go_on(seconds);
    sensors().poses_lost = false;
  }
  void expect_done(const std::string& fact) {
    run_to_the_end();
    EXPECT_EQ(last_.outcome, Outcome::kDone) << last_.message;
    EXPECT_TRUE(holds(fact)) << fact;
    expect_at_rest();
  }
};

TEST_F(CombinedFault, ItSlipsTwice) {
  loop_->pursue(kMugInSink);
  for (int time = 0; time < 2; ++time) {
    ASSERT_TRUE(run_until([&] { return holds_something(); })) << last_.message;
    go_on(0.4);
    drop();
    go_on(0.3);
  }
  expect_done("On Mug_1 Sink");
}

TEST_F(CombinedFault, TheMugIsPulledAwayFromTheOpenHandWhileNothingIsSeen) {
  loop_->pursue(kMugInSink);
  ASSERT_TRUE(run_until_action("grasp Mug_1"));
  go_on(2.0);
  ASSERT_FALSE(last_.finished);
  sensors().poses_lost = true;
  go_on(0.3);
  move("Mug_1", 0.05, -1.15);
  go_on(0.8);
  sensors().poses_lost = false;
  expect_done("On Mug_1 Sink");
}

TEST_F(CombinedFault, ItIsPutBackOutOfTheSinkAndTheTapTurnedOff) {
  loop_->pursue({{{"state", "Mug_1", "Water"}}, {}, 1.0});
  ASSERT_TRUE(run_until([&] { return holds("state SinkKnob TapIsOn"); }));
  ASSERT_TRUE(run_until_action("keep-on Mug_1 Sink"));
  go_on(0.5);
  set_joint("SinkKnob_joint", 0.0);
  ASSERT_TRUE(run_until([&] { return holds("On Mug_1 Sink"); })) << last_.message;
  const scene::Scene& scene = loop_->world().scene();
  scene::Pose back = loop_->world().object_pose(object("Mug_1"));
  const auto& counter = *scene.find_region("Counter_1");
  back.translation() =
      scene.find_fixture("Counter_1")->pose * counter.supports[0].frame * Eigen::Vector3d(-0.11, 0.60, 0.0);
  loop_->world().set_object_pose(object("Mug_1"), back);
  expect_done("state Mug_1 Water");
}

TEST_F(CombinedFault, TheDoorFallsShutTwiceAndNothingIsSeenForASecond) {
  loop_->pursue({{{"In", "Mug_1", "Microwave"}}, {}, 1.0});
  for (int time = 0; time < 2; ++time) {
    ASSERT_TRUE(run_until([&] { return holds("state Microwave DoorIsOpen"); })) << last_.message;
    go_on(time == 0 ? 2.5 : 0.5);
    set_joint("MicrowaveDoor_joint", 0.0);
    blind_for(1.2);
    ASSERT_TRUE(run_until([&] { return !holds("state Microwave DoorIsOpen"); }));
  }
  expect_done("In Mug_1 Microwave");
}

TEST_F(CombinedFault, TheGlassIsMovedWhileTheCanIsLiftedOverIt) {
  loop_->pursue({{{"state", "Glass_1", "Coke"}}, {}, 1.0});
  ASSERT_TRUE(run_until_action("pour Coke_1 Glass_1"));
  go_on(0.8);
  move("Glass_1", 0.0, 0.18);
  expect_done("state Glass_1 Coke");
}

TEST_F(CombinedFault, TheMugIsTakenOutOfTheRoom) {
  loop_->pursue(kMugInSink);
  ASSERT_TRUE(run_until_action("grasp Mug_1"));
  go_on(1.0);
  move("Mug_1", 6.0, 6.0, -0.8);
  run_to_the_end();
  EXPECT_THAT(last_.outcome, testing::AnyOf(Outcome::kMotionFailed, Outcome::kNoPlan)) << last_.message;
  EXPECT_FALSE(last_.message.empty());
  expect_at_rest();
  expect_nothing_presses();
}

TEST_F(CombinedFault, NothingIsSeenWhileTheHandCloses) {
  loop_->pursue(kMugInSink);
  ASSERT_TRUE(run_until([&] { return holds_something(); }));
  blind_for(1.5);
  expect_done("On Mug_1 Sink");
}

TEST_F(CombinedFault, AnArmIsBlockedAndTheOtherLosesTheMug) {
  loop_->pursue(kMugInSink);
  ASSERT_TRUE(run_until_action("grasp Mug_1"));
  loop_->world().freeze_joint("left_arm_4", true);
  ASSERT_TRUE(run_until([&] { return holds_something(); })) << last_.message;
  go_on(0.4);
  drop();
  expect_done("On Mug_1 Sink");
  expect_nothing_presses();
}

}  // namespace
}  // namespace goalnet::tools
