// All that a message names must be used: by a step, or to tell something apart; otherwise it is refused.
#include "components/goalnet/language/coverage.h"

#include <gtest/gtest.h>

#include "tests/unit/goalnet/instruction_fixture.h"

namespace goalnet::inference {
namespace {

class CoverageTest : public InstructionFixture {
 protected:
  static void expect_refused_for(const std::string& room, const std::string& sentence,
                                 const std::string& thing) {
    const auto run = follow(room, sentence);
    EXPECT_TRUE(run.refused) << sentence;
    EXPECT_TRUE(run.message.starts_with("it is not clear what to do with " + thing)) << run.message;
  }
};

TEST_F(CoverageTest, WhatNothingUsesIsNamedInTheRefusal) {
  expect_refused_for("kitchen", "get a plate ready with a fork on it", "Fork_1");
  expect_refused_for("living_room", "come to the couch with a pillow", "Pillow_1");
}

TEST_F(CoverageTest, PlacesMatterAsWell) {
  expect_refused_for("kitchen", "tip the coffee away, it's from yesterday refrigerator", "Fridge");
  expect_refused_for("kitchen", "the kettle's already burner, put the kettle in the microwave",
                     "StoveFire_1");
  // where what is used stands
  expect_reached("kitchen", "the coke on the stove is a fire hazard, put it on the counter",
                 "(On Coke_1 Counter_1)");
}

TEST_F(CoverageTest, WhatTellsSomethingApartOrIsLeftOutIsUsed) {
  expect_reached("kitchen", "bring me the mug, not the glass", "(Grasping Robot Mug_1)");
  expect_reached("kitchen", "my plate is dirty, bring me the mug", "(Grasping Robot Mug_1)");
  expect_reached("kitchen", "put the mug next to the plate", "(On Mug_1 Counter_1)");
  expect_reached("living_room", "bring me the coke or the beer",
                 "(Grasping Robot Coke_1) / (Grasping Robot Beer_1)");
  expect_reached("living_room", "lay the book on the shelf", "(On Book_1 Shelf_*)");
}

TEST_F(CoverageTest, BothThingsOfAListAreUsedWhateverIsSaidBehindIt) {
  expect_reached("living_room", "throw away the coke and the beer before my sister arrives",
                 "(In Beer_1 GarbageBin_1)(In Coke_1 GarbageBin_1)");
  expect_reached("kitchen", "bring me the fork and the spoon because lunch is ready",
                 "(Grasping Robot Fork_1)(Grasping Robot Spoon_1)");
}

TEST_F(CoverageTest, WhatIsWantedIsBroughtAndNotFoundToBeThereAlready) {
  expect_reached("kitchen", "Got in from my run just now and I'm dying for the energy drink in the fridge",
                 "(Grasping Robot EnergyDrink_1)");
}

TEST_F(CoverageTest, WhatGoesOnTopIsAdded) {
  for (const char* sentence : {"some ice cream in the bowl with the chocolate sauce please",
                               "I'd love a scoop of ice cream in the bowl with chocolate syrup on top"})
    expect_reached("kitchen", sentence, "(state Bowl_1 IceCream)(state Bowl_1 Chocolate)");
}

}  // namespace
}  // namespace goalnet::inference
