// Knobs are turned, doors pulled and buttons pressed by the hand; nothing else moves them.
#include <numbers>

#include <gtest/gtest.h>

#include "tests/unit/sim/puppet.h"
#include "tests/unit/sim/test_world.h"

namespace goalnet::sim {
namespace {

using Eigen::Vector3d;
constexpr double kDegree = std::numbers::pi / 180.0;

class Hand {
 public:
  explicit Hand(const std::string& name) : world(make_world()), hand(*world, "right") {
    const auto found = world->scene().find_part(name);
    fixture = found.fixture;
    part = found.part;
    joint = static_cast<std::size_t>(world->find_fixture_joint(found.part->joint.name));
    // The left hand behind, so that it touches nothing.
    world->set_robot_position(static_cast<std::size_t>(world->robot().index_of("left_arm_2")), 2.4);
  }
  double q() const { return world->fixture_joint(joint).position; }
  // Tool pose at the grasp for a joint position, `back` metres before it. Handles and knobs are approached
  // along +x.
  scene::Pose grip(double position, double back) const {
    const scene::Pose frame = scene::part_pose(*fixture, *part,
                                               [&](const std::string& asked) {
                                                 return asked == part->joint.name ? position : 0.0;
                                               }) *
                              part->grasps[0].frame;
    const Vector3d x = frame.linear().col(0);
    return Puppet::tool(Vector3d(frame.translation()) - back * x, x, frame.linear().col(1));
  }
  bool stand_before(const scene::Pose& tool, double lift, double sideways, double opening) {
    const Vector3d in = fixture->pose.linear().col(0), left = fixture->pose.linear().col(1);
    const Vector3d base = Vector3d(tool.translation()) - 0.62 * in + sideways * left;
    return hand.place(base.x(), base.y(), std::atan2(in.y(), in.x()), lift, tool, opening);
  }
  bool take(double lift, double sideways) {
    const double width = part->grasps[0].width;
    if (!stand_before(grip(0, 0.10), lift, sideways, width / 2 + 0.02) || !hand.move(grip(0, 0), 0.8))
      return false;
    hand.fingers(width / 2 - 0.006, 0.4);
    hand.wait(0.1);
    return true;
  }
  bool turn_to(double position, double seconds) {
    const double start = q();
    return hand.follow([&](double s) { return grip(start + s * (position - start), 0); }, seconds);
  }
  bool let_go() {
    hand.fingers(part->grasps[0].width / 2 + 0.025, 0.3);
    scene::Pose back = hand.target();
    back.translation() -= 0.08 * back.linear().col(2);
    return hand.move(back, 0.6);
  }

  std::unique_ptr<World> world;
  Puppet hand;
  const scene::Fixture* fixture = nullptr;
  const scene::Part* part = nullptr;
  std::size_t joint = 0;
};

TEST(MovingParts, SinkKnobIsTurnedOnAndOff) {
  Hand h("SinkKnob");
  ASSERT_TRUE(h.take(0.2, 0.3));
  EXPECT_NEAR(h.q(), 0.0, 0.02);
  ASSERT_TRUE(h.turn_to(85 * kDegree, 1.5));
  EXPECT_NEAR(h.q(), 85 * kDegree, 2 * kDegree);
  EXPECT_TRUE(holds(*h.world, "(state SinkKnob TapIsOn)"));
  ASSERT_TRUE(h.turn_to(0.0, 1.5));
  ASSERT_TRUE(h.let_go());
  EXPECT_NEAR(h.q(), 0.0, 2 * kDegree);
  EXPECT_FALSE(holds(*h.world, "(state SinkKnob TapIsOn)"));
  EXPECT_TRUE(h.world->held().empty());  // knobs are never "held": friction turns them
}

TEST(MovingParts, StoveKnobsAreTurned) {
  for (const char* name : {"StoveKnob_1", "StoveKnob_4"}) {
    Hand h(name);
    ASSERT_TRUE(h.take(0.1, 0.3)) << name;
    ASSERT_TRUE(h.turn_to(70 * kDegree, 1.2)) << name;
    EXPECT_NEAR(h.q(), 70 * kDegree, 2 * kDegree) << name;
    EXPECT_TRUE(holds(*h.world, std::string("(state Stove StoveFire") + name[10] + ")")) << name;
  }
}

TEST(MovingParts, DoorsArePulledOpenAndStay) {
  for (const char* name : {"MicrowaveDoor", "FridgeRightDoor"}) {
    Hand h(name);
    ASSERT_TRUE(h.take(0.3, 0.2)) << name;
    ASSERT_TRUE(h.turn_to(40 * kDegree, 2.5)) << name;
    EXPECT_NEAR(h.q(), 40 * kDegree, 2 * kDegree) << name;
    ASSERT_TRUE(h.let_go()) << name;
    h.hand.wait(0.5);
    EXPECT_NEAR(h.q(), 40 * kDegree, 3 * kDegree) << name;
  }
}

TEST(MovingParts, ButtonsArePressedAndComeBack) {
  for (const char* name : {"MicrowaveButton", "FridgeButton"}) {
    Hand h(name);
    const scene::Pose push =
        scene::part_pose(*h.fixture, *h.part, [](const std::string&) { return 0.0; }) * *h.part->push;
    const Vector3d in = push.linear().col(0), left = h.fixture->pose.linear().col(1);
    const double tip = 0.015;
    const auto finger_at = [&](double depth) {
      return Puppet::tool(Vector3d(push.translation()) + (depth - tip) * in, in, left);
    };
    ASSERT_TRUE(h.stand_before(finger_at(-0.05), 0.3, 0.3, 0.0)) << name;
    ASSERT_TRUE(h.hand.move(finger_at(0.010), 0.6)) << name;
    EXPECT_NEAR(h.q(), 0.010, 0.001) << name;
    ASSERT_TRUE(h.hand.move(finger_at(-0.05), 0.6)) << name;
    h.hand.wait(0.3);
    EXPECT_NEAR(h.q(), 0.0, 0.0005) << name;
    EXPECT_EQ(holds(*h.world, "(state Microwave MicrowaveIsOn)"), std::string(name) == "MicrowaveButton");
    EXPECT_EQ(holds(*h.world, "(state Fridge WaterDispenserIsOpen)"), std::string(name) == "FridgeButton");
  }
}

TEST(MovingParts, AFrozenDoorResists) {
  Hand h("MicrowaveDoor");
  h.world->freeze_joint("MicrowaveDoor_joint", true);
  ASSERT_TRUE(h.take(0.3, 0.25));
  h.turn_to(20 * kDegree, 1.0);
  EXPECT_LT(h.q(), 3 * kDegree);
}

TEST(MovingParts, PositionsSetByHandStayAndClamp) {
  auto world = make_world();
  const auto door = static_cast<std::size_t>(world->find_fixture_joint("FridgeLeftDoor_joint"));
  world->set_fixture_position(door, 1.0);
  run(*world, 1.0);
  EXPECT_NEAR(world->fixture_joint(door).position, 1.0, 1e-3);
  EXPECT_TRUE(holds(*world, "(state Fridge LeftDoorIsOpen)"));
  world->set_fixture_position(door, 100.0);
  EXPECT_NEAR(world->fixture_joint(door).position, 118 * kDegree, 1e-9);
  EXPECT_EQ(world->find_fixture_joint("NoSuch_joint"), -1);
}

}  // namespace
}  // namespace goalnet::sim
