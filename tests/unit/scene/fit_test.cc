// What does not go where, by its size.
#include "components/scene/fit.h"

#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>

namespace goalnet::scene {
namespace {

using testing::Contains;
using testing::Not;
using testing::Pair;

TEST(Fit, MouthsAndMiddles) {
  const auto scene = load_scene("living_room");
  ASSERT_TRUE(scene) << scene.error().message;
  const auto pairs = unfit_pairs(*scene);
  EXPECT_THAT(pairs, Contains(Pair("Pillow_1", "GarbageBin_1")));
  EXPECT_THAT(pairs, Contains(Pair("GarbageBin_1", "GarbageBag_1")));
  EXPECT_THAT(pairs, Not(Contains(Pair("Coke_1", "GarbageBag_1"))));
  EXPECT_THAT(pairs, Not(Contains(Pair("GarbageBag_1", "GarbageBin_1"))));
  EXPECT_THAT(pairs, Not(Contains(Pair("Cd_1", "Xbox_1")))) << "a slot is another question";
  EXPECT_THAT(pairs, Not(Contains(Pair("GarbageBin_1", "GarbageBin_1"))));
}

TEST(Fit, BoardsAbove) {
  auto scene = load_scene("kitchen");
  ASSERT_TRUE(scene) << scene.error().message;
  EXPECT_THAT(unfit_pairs(*scene), Not(Contains(Pair("Kettle", "Fridge"))));
  const double tall = scene->find_model_of("Kettle")->height() + kHeadroom;
  for (auto& region : scene->regions)
    if (region.name == "FridgeLeft")
      for (auto& support : region.supports) support.clearance = tall - 0.001;
  EXPECT_THAT(unfit_pairs(*scene), Contains(Pair("Kettle", "FridgeLeft")));
  EXPECT_THAT(unfit_pairs(*scene), Not(Contains(Pair("Kettle", "Fridge")))) << "the other side will do";
  for (auto& region : scene->regions)
    for (auto& support : region.supports) support.clearance = tall - 0.001;
  EXPECT_THAT(unfit_pairs(*scene), Contains(Pair("Kettle", "Fridge")));
}

}  // namespace
}  // namespace goalnet::scene
