// The living room's rules about what fingers touch, by hand-made input: no physics.
#include <gtest/gtest.h>

#include "components/scene/scene.h"
#include "sim/device_rules.h"

namespace goalnet::sim {
namespace {

class LivingRoomRules : public testing::Test {
 protected:
  LivingRoomRules() : scene_(scene::load_scene("living_room").value()), rules_(scene_) {
    input_.joint = [](const std::string&) { return 0.0; };
    input_.objects = scene::initial_poses(scene_, 0);
    input_.held.assign(scene_.objects.size(), false);
    input_.hands.assign(scene_.objects.size(), 0);
  }
  std::size_t index(const std::string& name) const {
    for (std::size_t i = 0; i < scene_.objects.size(); ++i)
      if (scene_.objects[i].name == name) return i;
    throw std::runtime_error("no object " + name);
  }
  void pass(double seconds) {
    for (double t = 0; t < seconds - 1e-9; t += 0.01) rules_.update(input_, 0.01);
  }
  // A finger at `x` along the remote control's upper side, then away again.
  void press_remote(double x, double force) {
    input_.touches = {{index("Tv_1Remote_1"), {x, 0.002, 0.026}, force}};
    pass(0.1);
    input_.touches.clear();
    pass(0.05);
  }
  bool fact(const std::string& text) const { return rules_.facts().contains(*parse_predicate(text)); }

  scene::Scene scene_;
  DeviceRules rules_;
  DeviceInput input_;
};

TEST_F(LivingRoomRules, OnePressOfTheRemoteControlIsOneToggle) {
  pass(0.1);
  press_remote(0.072, 3.0);
  EXPECT_TRUE(fact("(state Tv_1 IsOn)"));
  press_remote(0.072, 3.0);
  EXPECT_FALSE(fact("(state Tv_1 IsOn)"));
}

TEST_F(LivingRoomRules, TheNearestSpotIsPressed) {
  pass(0.1);
  press_remote(0.072, 3.0);
  press_remote(0.052, 3.0);  // nearer to "channel up" than to "power"
  EXPECT_TRUE(fact("(state Tv_1 IsOn)"));
  EXPECT_TRUE(fact("(state Tv_1 Channel4)"));
}

TEST_F(LivingRoomRules, BrushingOrTakingTheRemoteControlPressesNothing) {
  pass(0.1);
  press_remote(0.072, 0.2);
  EXPECT_FALSE(fact("(state Tv_1 IsOn)"));
  input_.touches = {{index("Tv_1Remote_1"), {0.072, 0.023, 0.010}, 18.0}};  // on its flank
  pass(0.2);
  EXPECT_FALSE(fact("(state Tv_1 IsOn)"));
}

TEST_F(LivingRoomRules, ABagNeedsTwoHandsAndAWhile) {
  const std::size_t bag = index("BagOfChips_1");
  EXPECT_FALSE(fact("(state BagOfChips_1 IsOpen)"));
  input_.hands[bag] = 1;
  pass(2.0);
  EXPECT_FALSE(fact("(state BagOfChips_1 IsOpen)"));
  input_.hands[bag] = 2;
  pass(0.3);
  EXPECT_FALSE(fact("(state BagOfChips_1 IsOpen)"));
  pass(0.3);
  EXPECT_TRUE(fact("(state BagOfChips_1 IsOpen)"));
}

TEST_F(LivingRoomRules, ADiscCountsOnceItIsInTheSlotAndLetGo) {
  const std::size_t disc = index("Cd_1");
  input_.objects[disc] = input_.objects[index("Xbox_1")] * Eigen::Translation3d(0, 0, 0.132);
  input_.held[disc] = true;
  pass(1.0);
  EXPECT_FALSE(fact("(state Xbox_1 CD)"));
  input_.held[disc] = false;
  pass(1.0);
  EXPECT_TRUE(fact("(state Xbox_1 CD)"));
}

}  // namespace
}  // namespace goalnet::sim
