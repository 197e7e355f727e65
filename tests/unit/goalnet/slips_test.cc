// What is said after "sorry", "hmm", "oh no" stands for what was said before it, and only for that.
#include "components/goalnet/language/slips.h"

#include <gtest/gtest.h>

#include "tests/unit/goalnet/instruction_fixture.h"

namespace goalnet::inference {
namespace {

using SlipsTest = InstructionFixture;

TEST_F(SlipsTest, AThingReplacesTheOneBefore) {
  expect_reached("kitchen", "bring me the spoon, oops, the fork",
                 "(Grasping Robot Fork_1) !(Grasping Robot Spoon_1)");
  expect_reached("kitchen", "light burner one, sorry, burner four",
                 "(state Stove StoveFire4) !(state Stove StoveFire1)");
  expect_reached("living_room", "drive to the couch, my bad, the tv", "(Near Robot Tv_1)");
}

TEST_F(SlipsTest, WhatIsDeniedIsReplacedWhereverItWasAskedFor) {
  expect_reached("kitchen", "put the coke in the fridge and wash the mug, oh no, not the coke, the salt",
                 "(In Salt_1 Fridge) (On Mug_1 Sink) !(In Coke_1 Fridge)");
}

TEST_F(SlipsTest, ANumberReplacesHowMany) {
  expect_reached("living_room", "put two books on the desk, actually all three",
                 "(On Book_1 Studytable_1) (On Book_2 Studytable_1) (On Book_3 Studytable_1)");
}

TEST_F(SlipsTest, OnlyTheLastOfAListIsReplaced) {
  expect_reached("kitchen", "bring me the salt and the fork, sorry, spoon",
                 "(Grasping Robot Salt_1) (Grasping Robot Spoon_1) !(Grasping Robot Fork_1)");
}

TEST_F(SlipsTest, AListAtTheVeryBeginningIsReplaced) {  // nothing stands before it, not even a verb
  expect_reached("kitchen", "the fork and the glass, sorry, the fork and the spoon please",
                 "(Grasping Robot Fork_1) (Grasping Robot Spoon_1) !(Grasping Robot Glass_1)");
}

TEST_F(SlipsTest, TheSentenceMayGoOnBehind) {
  expect_reached("kitchen", "put the mug, sorry, the glass in the sink",
                 "(On Glass_1 Sink) !(On Mug_1 Sink)");
}

TEST_F(SlipsTest, HesitatingBeforeOneMoreThingReplacesNothing) {
  expect_reached("kitchen", "bring me the fork, um, and the spoon",
                 "(Grasping Robot Fork_1) (Grasping Robot Spoon_1)");
  expect_reached("kitchen", "bring me the fork and, uh, the spoon",
                 "(Grasping Robot Fork_1) (Grasping Robot Spoon_1)");
}

}  // namespace
}  // namespace goalnet::inference
