// What the shipped living room promises.
#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>

#include "components/scene/scene.h"

namespace goalnet::scene {
namespace {

TEST(LivingRoom, HasTheObjectsOfTheDomain) {
  const auto scene = load_scene("living_room");
  ASSERT_TRUE(scene) << scene.error().message;
  const std::vector<std::string> wanted = {
      "Cd_1",         "Armchair_4",   "Loveseat_2", "Plate_1",       "Pillow_2",         "Counter_1",
      "Armchair_2",   "Bowl_1",       "Armchair_1", "CoffeeTable_1", "Book_2",           "BagOfChips_1",
      "Pillow_1",     "Cd_2",         "Xbox_1",     "Studytable_1",  "Coke_1",           "SnackTable_1",
      "Tv_1",         "GarbageBin_1", "Armchair_3", "GarbageBag_1",  "Shelf_1",          "Loveseat_1",
      "Tv_1Remote_1", "Shelf_2",      "Pillow_3",   "Beer_1",        "XboxController_1", "Pillow_4",
      "Book_1",       "Book_3",       "Robot"};
  EXPECT_THAT(scene->symbols, testing::UnorderedElementsAreArray(wanted));
  for (const auto& object : scene->objects) {
    EXPECT_TRUE(scene->model_of(object).has_property("IsGraspable")) << object.name;
  }
  for (const char* surface :
       {"Counter_1", "Loveseat_1", "Loveseat_2", "Armchair_1", "Armchair_2", "Armchair_3", "Armchair_4",
        "CoffeeTable_1", "SnackTable_1", "Studytable_1", "Shelf_1", "Shelf_2"}) {
    EXPECT_NE(scene->find_region(surface), nullptr) << surface;
  }
  for (const char* button :
       {"PowerButton", "ChannelUpButton", "ChannelDownButton", "VolumeUpButton", "VolumeDownButton"}) {
    EXPECT_TRUE(scene->find_part(std::string("Tv_1") + button)) << button;
  }
}

}  // namespace
}  // namespace goalnet::scene
