// A mess that a seed decides: the same every time, and one that could have come about.
#include <gtest/gtest.h>

#include "components/core/config_path.h"
#include "components/robot/robot_model.h"
#include "sim/world.h"
#include "tools/goalnet/untidy_start.h"

namespace goalnet::tools {
namespace {

std::unique_ptr<sim::World> room(const char* name) {
  return std::move(sim::World::create(scene::load_scene(name).value(),
                                      robot::load_robot(config_path("robots/default.yaml")).value(), {})
                       .value());
}

std::vector<scene::Pose> poses(const sim::World& world) {
  std::vector<scene::Pose> all;
  for (std::size_t i = 0; i < world.scene().objects.size(); ++i) all.push_back(world.object_pose(i));
  return all;
}

class UntidyStart : public testing::TestWithParam<const char*> {};

TEST_P(UntidyStart, TheSameSeedGivesTheSameMess) {
  const auto a = room(GetParam()), b = room(GetParam()), other = room(GetParam());
  make_untidy(*a, 5);
  make_untidy(*b, 5);
  make_untidy(*other, 6);
  bool differs = false;
  for (std::size_t i = 0; i < poses(*a).size(); ++i) {
    EXPECT_EQ(a->object_pose(i).matrix(), b->object_pose(i).matrix());
    differs |= a->object_pose(i).matrix() != other->object_pose(i).matrix();
  }
  EXPECT_TRUE(differs);
}

TEST_P(UntidyStart, ThingsMoveFallAndComeToRestWhereTheyCouldHave) {
  std::size_t moved = 0, fallen = 0, count = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto world = room(GetParam());
    for (int i = 0; i < 300; ++i) world->step();
    const auto before = poses(*world);
    make_untidy(*world, seed);
    const auto placed = poses(*world);
    for (int i = 0; i < 1000; ++i) world->step();
    for (std::size_t i = 0; i < before.size(); ++i) {
      const scene::Pose now = world->object_pose(i);
      ++count;
      moved += (placed[i].translation() - before[i].translation()).norm() > 0.005;
      fallen += now.linear()(2, 2) < 0.5;
      EXPECT_GT(now.translation().z(), -0.02) << world->scene().objects[i].name << ", seed " << seed;
      EXPECT_LT(now.translation().z(), placed[i].translation().z() + 0.15)
          << "thrown up by what it was put into";
      const double sunk = placed[i].translation().z() - now.translation().z();
      EXPECT_FALSE(now.linear()(2, 2) > 0.95 && sunk > 0.008 && sunk < 0.03)
          << world->scene().objects[i].name << ", seed " << seed
          << ": pressed into its support by what it was put into";
    }
  }
  EXPECT_GT(moved, count / 3);
  EXPECT_GT(fallen, 3u);
  EXPECT_LT(fallen, count / 3);
}

INSTANTIATE_TEST_SUITE_P(Rooms, UntidyStart, testing::Values("kitchen", "living_room"),
                         [](const auto& room_name) { return std::string(room_name.param); });

}  // namespace
}  // namespace goalnet::tools
