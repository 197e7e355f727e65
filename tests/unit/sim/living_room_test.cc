// The living room at rest, and its television.
#include <map>

#include <gtest/gtest.h>

#include "sim/device_rules.h"
#include "tests/unit/sim/test_world.h"

namespace goalnet::sim {
namespace {

const scene::Scene& living_room() {
  static const scene::Scene scene = *scene::load_scene("living_room");
  return scene;
}

TEST(LivingRoom, EverythingRestsWhereItWasPut) {
  WorldOptions options;
  options.seed = 4;
  auto created = World::create(living_room(), test_robot(), options);
  ASSERT_TRUE(created) << created.error().message;
  World& world = **created;
  std::vector<scene::Pose> start;
  for (std::size_t i = 0; i < living_room().objects.size(); ++i) start.push_back(world.object_pose(i));
  run(world, 1.0);
  for (std::size_t i = 0; i < start.size(); ++i) {
    EXPECT_LT((world.object_pose(i).translation() - start[i].translation()).norm(), 0.0005)
        << living_room().objects[i].name;
    EXPECT_TRUE(world.at_rest(i)) << living_room().objects[i].name;
  }
}

TEST(LivingRoom, TelevisionChangesChannelsOnlyWhenOn) {
  DeviceRules rules(living_room());
  std::map<std::string, double> joints;
  DeviceInput input;
  input.joint = [&](const std::string& name) { return joints[name]; };
  input.objects = scene::initial_poses(living_room(), 0);
  input.held.resize(input.objects.size());
  const auto press = [&](const std::string& button) {
    joints["Tv_1" + button + "_joint"] = 0.0;
    rules.update(input, 0.01);
    joints["Tv_1" + button + "_joint"] = 0.01;
    rules.update(input, 0.01);
    joints["Tv_1" + button + "_joint"] = 0.0;
    rules.update(input, 0.01);
  };
  const auto fact = [&](const std::string& value) {
    return rules.facts().contains({"state", "Tv_1", value});
  };
  press("ChannelUpButton");
  EXPECT_TRUE(fact("Channel3"));
  press("PowerButton");
  EXPECT_TRUE(fact("IsOn"));
  press("ChannelUpButton");
  EXPECT_TRUE(fact("Channel4"));
  EXPECT_FALSE(fact("Channel3"));
  for (int i = 0; i < 4; ++i) press("ChannelDownButton");
  EXPECT_TRUE(fact("Channel6"));  // cyclic
  EXPECT_TRUE(fact("Volume"));
  press("VolumeDownButton");
  EXPECT_FALSE(fact("Volume"));
  press("VolumeUpButton");
  EXPECT_TRUE(fact("Volume"));
  press("PowerButton");
  EXPECT_FALSE(fact("IsOn"));
}

}  // namespace
}  // namespace goalnet::sim
