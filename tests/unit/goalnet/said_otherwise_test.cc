// Wrong acts that were met: what is left after all, pointed back at, said on in one breath, or wished not to
// be.
#include <gtest/gtest.h>

#include "tests/unit/goalnet/instruction_fixture.h"

namespace goalnet::inference {
namespace {

class SaidOtherwise : public InstructionFixture {
 protected:
  static std::string refusal(const std::string& room, const std::string& sentence) {
    const auto run = follow(room, sentence);
    EXPECT_TRUE(run.refused) << sentence;
    return run.message;
  }
};

TEST_F(SaidOtherwise, WhatIsLeftAfterAllStays) {
  expect_reached("living_room",
                 "book one to the shelf, and book two as well, oh no leave book two where it is",
                 "(On Book_1 Shelf_*) (On Book_2 CoffeeTable_1)");
  expect_reached("living_room", "books on the shelf but leave book two",
                 "(On Book_1 Shelf_*) (On Book_2 CoffeeTable_1)");
}

TEST_F(SaidOtherwise, AShameIsNotWished) {
  expect_reached("kitchen", "it would be a shame if the fridge stayed open",
                 "!(state Fridge LeftDoorIsOpen) !(state Fridge RightDoorIsOpen)");
  EXPECT_TRUE(
      follow("living_room", "I would be angry if the tv was on").refused ||
      !reached("(state Tv_1 IsOn)", follow("living_room", "I would be angry if the tv was on").facts));
}

TEST_F(SaidOtherwise, NotThirstyIsNoWish) {
  expect_reached("kitchen", "I'm not thirsty I'm hungry give me the egg",
                 "(Grasping Robot BoiledEgg_1) !(Grasping Robot CanadaDry_1)");
}

TEST_F(SaidOtherwise, APlaceTellsWhichIsFetched) {
  expect_reached("living_room", "book on shelf: fetch", "(Grasping Robot Book_3)");
  expect_reached("living_room", "the remote lay on the shelf, bring it", "(Grasping Robot Tv_1Remote_1)");
  expect_reached("living_room", "armchair three, take the pillow off it", "(Grasping Robot Pillow_4)");
}

TEST_F(SaidOtherwise, ACorrectedSourceIsNoDestination) {
  expect_reached("living_room",
                 "move the pillow from armchair one to armchair four, I mean from armchair two",
                 "(On Pillow_2 Armchair_4) (On Pillow_1 Armchair_1)");
}

TEST_F(SaidOtherwise, ARequestBehindACommandIsItsOwn) {
  expect_reached("kitchen", "pour the coffee out, then mug in the sink",
                 "!(state Mug_1 Coffee) (On Mug_1 Sink)");
  expect_reached("living_room", "take the bowl off the couch, coffee table is fine",
                 "(On Bowl_1 CoffeeTable_1)");
  expect_reached("kitchen", "mug and glass sink", "(On Mug_1 Sink) (On Glass_1 Sink)");
}

TEST_F(SaidOtherwise, AConditionSaidInOneBreathIsOfTheLastOrder) {
  expect_reached("living_room", "take the bag of chips put them on the coffee table open it if it is closed",
                 "(On BagOfChips_1 CoffeeTable_1)");
}

TEST_F(SaidOtherwise, TheTubIsPutBackAndNoBowlOfIt) {
  expect_reached("kitchen", "put a scoop of ice cream in the bowl, then put the ice cream back in the fridge",
                 "(state Bowl_1 IceCream) (In IceCream_1 Fridge) !(In Bowl_1 Fridge)");
  expect_reached("kitchen", "take the ice cream, put a scoop in the bowl, then put it back",
                 "(state Bowl_1 IceCream) (In IceCream_1 Fridge)");
}

TEST_F(SaidOtherwise, RefusalsSayWhatIsWrong) {
  EXPECT_NE(refusal("kitchen", "do nothing").find("nothing is asked for"), std::string::npos);
  EXPECT_EQ(refusal("kitchen", "put the").find("\"\""), std::string::npos);
  EXPECT_EQ(refusal("kitchen", "bring me a").find("\"\""), std::string::npos);
}

}  // namespace
}  // namespace goalnet::inference
