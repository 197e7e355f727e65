// What the world shows after an action when the rules promise more than it keeps.
#include <gmock/gmock.h>

#include "tests/unit/coordinator/toy_world.h"

namespace goalnet::coordinator {
namespace {

using testing::HasSubstr;

const Action kTurnOn{"turn-on", {"Tap"}};
const Action kTurnOff{"turn-off", {"Tap"}};

// Turns the tap on, and the world shows only that.
void turn_on_in_vain(Play& play) {
  play.plan({kTurnOn});
  play.world.insert(fact("(state Tap TapIsOn)"));
  play.finish_action(Outcome::kDone);
  play.pass(7.0);
}

TEST(Expectation, WhatNobodyAskedForMayStayAsItWas) {
  Play play;
  play.world_now(facts({"(On Kettle Sink)"}));  // beside the stream
  ASSERT_TRUE(play.pursue(goal({"(state Tap TapIsOn)"})));
  turn_on_in_vain(play);
  EXPECT_TRUE(play.report().finished);
  EXPECT_EQ(play.report().outcome, Outcome::kDone) << play.report().message;
}

TEST(Expectation, AnActionWithoutAnyEffectHasFailed) {
  Play play;
  play.world_now(facts({"(On Kettle Sink)"}));
  ASSERT_TRUE(play.pursue(goal({"(state Tap TapIsOn)"})));
  play.plan({kTurnOn});
  play.finish_action(Outcome::kDone);
  play.pass(7.0);
  EXPECT_FALSE(play.report().finished);
  EXPECT_THAT(play.report().message, HasSubstr("lacks"));
}

TEST(Expectation, WhatIsAskedForIsTakenInHandBeforeTheNextTry) {
  Play play;
  play.world_now(facts({"(On Mug_1 Sink)"}));  // beside the stream
  const Goal water = goal({"(state Mug_1 Water)"});
  ASSERT_TRUE(play.pursue(water));
  EXPECT_EQ(play.port.plan_goal.positive, water.positive);
  turn_on_in_vain(play);
  EXPECT_EQ(play.port.plan_goal.positive, goal({"(Grasping Robot Mug_1)"}).positive);
  play.plan({kMugToSink[0]});
  play.act();
  EXPECT_EQ(play.port.plan_goal.positive, water.positive) << "then it is planned for what was asked for";
  EXPECT_EQ(play.report().goal.positive, water.positive) << "which is all that people see";
  play.plan({kMugToSink[1]});
  play.world.insert(fact("(state Mug_1 Water)"));
  play.act();
  EXPECT_EQ(play.report().outcome, Outcome::kDone);
  EXPECT_TRUE(play.report().finished);
  EXPECT_THAT(play.report().message, HasSubstr("turn-on Tap\" failed")) << "the outcome tells what was tried";
}

TEST(Expectation, WhatIsAskedForIsTakenInHandBeforeWhatStandsBesideIt) {
  Play play;
  play.world_now(facts({"(On Glass_1 Sink)", "(On Mug_1 Sink)"}));  // both beside the stream
  ASSERT_TRUE(play.pursue(goal({"(state Mug_1 Water)"})));
  turn_on_in_vain(play);
  EXPECT_EQ(play.port.plan_goal.positive, goal({"(Grasping Robot Mug_1)"}).positive);
}

TEST(Expectation, WhatCannotBeTakenInHandIsPlannedForAsItIs) {
  Play play;
  play.world_now(facts({"(On Mug_1 Sink)"}));
  const Goal water = goal({"(state Mug_1 Water)"});
  ASSERT_TRUE(play.pursue(water));
  turn_on_in_vain(play);
  play.coordinator.on_plan({play.id(), 0, {}, Outcome::kNoPlan, "both hands are full"}, play.now);
  EXPECT_FALSE(play.report().finished);
  EXPECT_EQ(play.port.plan_goal.positive, water.positive);
}

TEST(Expectation, TheOutcomeTellsWhatElseFailed) {
  Play play;
  play.world_now(facts({"(On Mug_1 Counter_1)"}));
  ASSERT_TRUE(play.pursue(goal({"(On Mug_1 Sink)"})));
  play.plan(kMugToSink);
  play.act(Outcome::kMotionFailed, "it slipped");
  play.plan(kMugToSink);
  play.act();
  for (int i = 0; i < 3; ++i) {
    play.act(Outcome::kMotionFailed, "no free place");
    if (i < 2) play.plan({kMugToSink[1]});
  }
  EXPECT_EQ(play.report().outcome, Outcome::kMotionFailed);
  EXPECT_THAT(play.report().message, HasSubstr("no free place (3 times)"));
  EXPECT_THAT(play.report().message, HasSubstr("before that \"grasp Mug_1\" failed: it slipped"));
}

}  // namespace
}  // namespace goalnet::coordinator
